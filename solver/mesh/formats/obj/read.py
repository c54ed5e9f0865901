"""Reading OBJ files: positions, polygons, and all that saving must keep."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from solver.errors import MeshError
from solver.mesh.formats.colours import rgba_of_text
from solver.mesh.formats.format import FileContent, Groups, Smoothing
from solver.mesh.formats.obj.rows import Rows, coloured_lines, read_rows
from solver.mesh.formats.text.file import Flaw, TextFile, check_text
from solver.mesh.formats.text.lines import Lines
from solver.mesh.formats.text.points import read_any
from solver.mesh.polygons import Polygons
from solver.mesh.progress import Progress, silent
from solver.types import FloatArray, IntArray

_NOT_SMOOTH = b"", b"0", b"off"
_EXTRAS = {"texture coordinates": b"vt", "normals": b"vn", "objects": b"o", "groups": b"g"}


@dataclass(frozen=True, eq=False)
class ObjSource:
    """What an OBJ file holds beyond its surface, for writing it back.

    `vertex_at` (n,) and `normal_at` (k,) are the bytes where the `v` and `vn` lines start with
    their keyword; `normals` (k, 3) has NaN where a `vn` line is unreadable; `corner_normals` gives
    the normal of every polygon corner, -1 for none.
    """

    data: bytes
    vertex_at: IntArray
    normal_at: IntArray
    normals: FloatArray
    corner_normals: IntArray

    def colours(self) -> FloatArray:
        """(n, 4) of the vertices; white where a line has none."""
        parts = []
        for lines in _lines(TextFile("", self.data, continued=True)):
            vertices = lines.starting_with(b"v")
            coloured = coloured_lines(vertices)
            parts.append(np.full((len(vertices), 3), np.nan))
            parts[-1][coloured] = read_any(vertices[coloured], 4)
        return rgba_of_text(np.concatenate(parts))


def read_obj(data: bytes, name: str, progress: Progress = silent) -> FileContent:
    """Vertices and polygons, with an ObjSource. Raises MeshError naming the line.

    Faces may name vertices that come later. A normal that is not there or cannot be read is no
    error: exporters write such lines, and no position depends on them.
    """
    check_text(name, data, "an OBJ mesh")
    text = TextFile(name, data, continued=True)
    rows = Rows.concatenate([read_rows(lines) for lines in _lines(text, progress)])
    vertex_at, normal_at, face_at = (rows.at[keyword] for keyword in (b"v", b"vn", b"f"))
    if not vertex_at.size:
        raise MeshError(f"{name}: no vertices, expected an OBJ mesh with lines 'v x y z'")
    if not face_at.size:
        raise MeshError(f"{name}: no faces, expected at least one line 'f ...'")
    if rows.flaws:
        raise text.error(min(rows.flaws))
    corners = _resolve(rows.vertex_numbers, rows.sizes, face_at, vertex_at)
    wrong = np.flatnonzero(corners < 0)
    if wrong.size:
        raise _missing(text, int(wrong[0]), rows)
    corner_normals = _resolve(rows.normal_numbers, rows.sizes, face_at, normal_at)
    source = ObjSource(data, vertex_at, normal_at, rows.normals, corner_normals)
    extras = {words: len(rows.at[keyword]) for words, keyword in _EXTRAS.items()}
    extras |= {words: count for words, count in rows.rare.items() if count}
    colours = source.colours if rows.rare["colours"] else None
    named = rows.at[b"o"] if rows.at[b"o"].size else rows.at[b"g"]
    groups = _groups(text.data, named, face_at) if named.size else None
    smoothing = _smoothing(text.data, rows, corner_normals)
    polygons = Polygons(rows.sizes, corners)
    return FileContent(rows.points, polygons, extras, source, groups, colours, smoothing)


def _lines(text: TextFile, progress: Progress = silent) -> Iterator[Lines]:
    return map(Lines.of, text.blocks(comments=True, progress=progress))


def _groups(data: bytes, at: IntArray, face_at: IntArray) -> Groups:
    """The faces by the object or group that the last of the lines `at` before them names."""
    names = [word.decode("utf-8", "replace") for word in _named(data, at)]
    number = {name: k for k, name in enumerate(dict.fromkeys(names))}
    # The last entry is for faces before the first line.
    numbers = np.array([*(number[name] for name in names), -1])
    return Groups(tuple(number), numbers[np.searchsorted(at, face_at) - 1])


def _named(data: bytes, at: IntArray) -> Iterator[bytes]:
    """What follows the keyword of each of the lines `at`."""
    for start in at.tolist():
        line = data[start : data.find(b"\n", start) + 1 or len(data)]
        yield b" ".join(line.partition(b"#")[0].split()[1:])


def _smoothing(data: bytes, rows: Rows, corner_normals: IntArray) -> Smoothing | None:
    """By normals; corners without one by the smoothing group of their face, if there are groups."""
    at, face_at = rows.at[b"s"], rows.at[b"f"]
    if not at.size and (corner_normals < 0).all():
        return None
    if not at.size:
        return Smoothing(corner_normals, rows.normals)
    known = {name: number for number, name in enumerate(dict.fromkeys(_named(data, at)))}
    numbers = [-1 if name in _NOT_SMOOTH else known[name] for name in _named(data, at)]
    # Groups are off before the first line; a face without one is smooth with no other.
    group = np.array([*numbers, -1])[np.searchsorted(at, face_at) - 1]
    group = np.where(group < 0, len(known) + np.arange(len(group)), group)
    spread = np.repeat(len(rows.normals) + group, rows.sizes)
    alike = np.where(corner_normals < 0, spread, corner_normals)
    return Smoothing(alike, rows.normals)


def _resolve(numbers: IntArray, sizes: IntArray, face_at: IntArray, at: IntArray) -> IntArray:
    """Indices from 0; negative numbers count back from the face; -1 where nothing is there."""
    index = numbers - 1
    negative = numbers < 0
    if negative.any():
        before = np.repeat(np.searchsorted(at, face_at), sizes)
        index[negative] = (before + numbers)[negative]
    index[(index < 0) | (index >= len(at))] = -1
    return index


def _missing(text: TextFile, corner: int, rows: Rows) -> MeshError:
    face = np.searchsorted(np.cumsum(rows.sizes), corner, side="right")
    at, vertex_at = int(rows.at[b"f"][face]), rows.at[b"v"]
    number = int(rows.vertex_numbers[corner])
    expected = f"the file has {len(vertex_at)}"
    if number == 0:
        expected = "the first vertex is 1"
    elif number < 0:
        expected = f"{np.searchsorted(vertex_at, at)} come before it"
    return text.error(Flaw(0, at, f"the face names vertex {number}, but {expected}"))
