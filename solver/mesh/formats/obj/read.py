"""Reading OBJ files: positions, polygons, and all that saving must keep."""

from __future__ import annotations

import re
from bisect import bisect_left
from collections import defaultdict
from dataclasses import dataclass

import numpy as np

from solver.errors import MeshError
from solver.mesh.formats.format import FileContent
from solver.mesh.formats.text import Text, is_point, points, split_lines
from solver.mesh.polygons import Polygons
from solver.types import FloatArray, IntArray

_BOM = b"\xef\xbb\xbf"
_EXTRAS = {"texture coordinates": b"vt", "normals": b"vn", "groups": b"g"}
_CONTINUES = re.compile(rb"\\[ \t]*(\r\n|\r|\n)")


@dataclass(frozen=True, eq=False)
class ObjSource:
    """What an OBJ file holds beyond its surface, for writing it back.

    `vertex_lines` (n,) and `normal_lines` (k,) count in `obj_lines(data)`; `normals` (k, 3) has NaN
    where a `vn` line is unreadable; `corner_normals` gives the normal of every polygon corner, -1
    for none.
    """

    data: bytes
    vertex_lines: IntArray
    normal_lines: IntArray
    normals: FloatArray
    corner_normals: IntArray


def read_obj(data: bytes, name: str) -> FileContent:
    """Vertices and polygons, with an ObjSource. Raises MeshError naming the line.

    Faces may name vertices that come later. A normal that is not there or cannot be read is no
    error: exporters write such lines, and no position depends on them.
    """
    split_lines(name, data, "an OBJ mesh")
    lines = obj_lines(data)
    marked = b"#" in data or b"\\" in data
    text = Text(name, lines, [_bare(line) for line in lines] if marked else lines)
    at = _lines_by_keyword(text.bare)
    v_lines, vn_lines, f_lines = at[b"v"], at[b"vn"], at[b"f"]
    if not v_lines:
        raise MeshError(f"{name}: no vertices, expected an OBJ mesh with lines 'v x y z'")
    if not f_lines:
        raise MeshError(f"{name}: no faces, expected at least one line 'f ...'")
    V = points(text, v_lines, 1)
    normals = _normals(text, vn_lines)
    polygons, corner_normals = _FaceReader(text, f_lines).read(v_lines, vn_lines)
    v_at, vn_at = (np.array(lines, dtype=np.int64) for lines in (v_lines, vn_lines))
    source = ObjSource(data, v_at, vn_at, normals, corner_normals)
    extras = {words: len(at[key]) for words, key in _EXTRAS.items()}
    return FileContent(V, polygons, extras, source)


def obj_lines(data: bytes) -> list[bytes]:
    """The lines of an OBJ, endings kept; a backslash joins a line and the next, unless commented.

    A byte order mark is left out.
    """
    lines = data.removeprefix(_BOM).splitlines(keepends=True)
    if not _CONTINUES.search(data):
        return lines
    joined: list[bytes] = []
    pending: list[bytes] = []
    for line in lines:
        pending.append(line)
        if b"#" in line or not _CONTINUES.search(line):
            joined.append(b"".join(pending))
            pending = []
    return joined + [b"".join(pending)] * bool(pending)


def byte_order_mark(data: bytes) -> bytes:
    """The mark that `obj_lines` leaves out, if the data starts with one."""
    return _BOM * data.startswith(_BOM)


def _lines_by_keyword(lines: list[bytes]) -> defaultdict[bytes, list[int]]:
    """Which lines start with each word; those without one under the empty word."""
    at: defaultdict[bytes, list[int]] = defaultdict(list)
    for i, line in enumerate(lines):
        at[(line.split(None, 1) or [b""])[0]].append(i)
    return at


def _bare(line: bytes) -> bytes:
    """The line without its comment and with blanks for continuations."""
    if b"#" in line:
        line = line.split(b"#", 1)[0]
    return _CONTINUES.sub(b" ", line) if b"\\" in line else line


def _normals(text: Text, at: list[int]) -> FloatArray:
    """(k, 3), NaN for every line that is not three finite numbers."""
    unreadable = [b"nan"] * 3
    rows = (text.bare[i].split()[1:4] for i in at)
    tokens = [token for row in rows for token in (row if is_point(row) else unreadable)]
    normals = np.array(list(map(float, tokens)), dtype=np.float64).reshape(-1, 3)
    normals[~np.isfinite(normals).all(axis=1)] = np.nan
    return normals


@dataclass(frozen=True)
class _FaceReader:
    """Reads the `f` lines `at`."""

    text: Text
    at: list[int]

    def read(self, v_lines: list[int], vn_lines: list[int]) -> tuple[Polygons, IntArray]:
        """Polygons and the normal of every corner (-1 for none)."""
        sizes = np.array([len(self._corners(i)) for i in self.at], dtype=np.int64)
        small = np.flatnonzero(sizes < 3)
        if small.size:
            raise self.text.error(self.at[int(small[0])], "a face needs at least three corners")
        vertex_numbers, normal_numbers = self._numbers()
        corners = self._resolve(vertex_numbers, sizes, v_lines)
        wrong = np.flatnonzero(corners < 0)
        if wrong.size:
            raise self._missing(int(wrong[0]), vertex_numbers, sizes, v_lines)
        return Polygons(sizes, corners), self._resolve(normal_numbers, sizes, vn_lines)

    def _corners(self, line: int) -> list[bytes]:
        return self.text.bare[line].split()[1:]

    def _numbers(self) -> tuple[IntArray, IntArray]:
        """Vertex and normal of every corner as written, 0 for no normal."""
        joined = b" ".join([self.text.bare[i].lstrip()[1:] for i in self.at])
        tokens = joined.split()
        shapes = set(joined.translate(None, b"0123456789+-").split())
        try:
            if not shapes:
                return np.array(list(map(int, tokens)), np.int64), np.zeros(len(tokens), np.int64)
            if shapes == {b"//"}:
                # The usual case, several times faster. The count shows a number missing at an end.
                fields = joined.replace(b"//", b"/0/").replace(b"/", b" ").split()
                if len(fields) == 3 * len(tokens):
                    vertices, normals = (list(map(int, fields[k::3])) for k in (0, 2))
                    return np.array(vertices, np.int64), np.array(normals, np.int64)
            vertices = [int(token.split(b"/", 1)[0]) for token in tokens]
            normals = list(map(_normal_number, tokens))
            return np.array(vertices, np.int64), np.array(normals, np.int64)
        except (ValueError, OverflowError) as error:
            bad = next(i for i in self.at if not all(map(_is_corner, self._corners(i))))
            raise self.text.error(bad, "expected corners v, v/vt, v//vn or v/vt/vn") from error

    def _resolve(self, numbers: IntArray, sizes: IntArray, lines: list[int]) -> IntArray:
        """Indices from 0; negative numbers count back from the face; -1 where nothing is there."""
        if not numbers.any():
            return np.full(len(numbers), -1, dtype=np.int64)
        before = np.repeat(np.searchsorted(lines, self.at), sizes)
        index = np.where(numbers < 0, before + numbers, numbers - 1)
        return np.where((index >= 0) & (index < len(lines)), index, -1)

    def _missing(
        self, corner: int, numbers: IntArray, sizes: IntArray, v_lines: list[int]
    ) -> MeshError:
        line = self.at[int(np.searchsorted(np.cumsum(sizes), corner, side="right"))]
        number = int(numbers[corner])
        expected = f"the file has {len(v_lines)}"
        if number == 0:
            expected = "the first vertex is 1"
        elif number < 0:
            expected = f"{bisect_left(v_lines, line)} come before it"
        return self.text.error(line, f"the face names vertex {number}, but {expected}")


def _normal_number(token: bytes) -> int:
    parts = token.split(b"/", 2)
    # A slash more than the format has is an exporter's slip that changes nothing.
    return int(parts[2].rstrip(b"/") or 0) if len(parts) == 3 else 0


def _is_corner(token: bytes) -> bool:
    try:
        return all(abs(n) < 2**63 for n in (int(token.split(b"/", 1)[0]), _normal_number(token)))
    except ValueError:
        return False
