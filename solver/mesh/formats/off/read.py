"""Reading OFF files: positions, polygons, and how many colours and normals come with them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from solver.errors import MeshError
from solver.mesh.formats.colours import rgba_of_text
from solver.mesh.formats.format import FileContent
from solver.mesh.formats.off.lines import OffLines
from solver.mesh.formats.text.blocks import whole_numbers
from solver.mesh.formats.text.file import Flaw, check_text
from solver.mesh.formats.text.lines import Lines, first_failing
from solver.mesh.formats.text.points import finite_points, read_any
from solver.mesh.polygons import Polygons
from solver.mesh.progress import Progress, silent
from solver.types import FloatArray, IntArray


@dataclass(frozen=True)
class OffSource:
    """An OFF file, for writing it back."""

    data: bytes

    def colours(self) -> FloatArray:
        """(n, 4) of the vertices, which have some."""
        lines = OffLines("", self.data)
        skip, behind = 3 + 3 * lines.has_normals, 2 * lines.has_texture
        parts = [np.empty((0, 4))]
        for some in lines.vertices():
            width = 4 if (some.count >= skip + 4 + behind).all() else 3
            parts.append(np.full((len(some), 4), np.nan))
            parts[-1][:, :width] = read_any(some, skip, width)
        return rgba_of_text(np.concatenate(parts))


def read_off(data: bytes, name: str, progress: Progress = silent) -> FileContent:
    """Vertices and polygons, with an OffSource. Raises MeshError naming the line."""
    check_text(name, data, "an OFF mesh")
    content = _Content(OffLines(name, data, progress))
    lines, n, m = content.lines, content.lines.vertex_count, content.lines.face_count
    if content.found < n + m:
        raise MeshError(
            f"{name}: the file ends early, expected {n} vertices and {m} faces, "
            f"got {content.found} lines"
        )
    if content.flaws:
        raise lines.text.error(min(content.flaws))
    extras = {
        "texture coordinates": n * lines.has_texture,
        "normals": n * lines.has_normals,
        "colours": n * lines.has_colours,
        "face colours": content.coloured,
    }
    present = {words: count for words, count in extras.items() if count}
    source = OffSource(data)
    colours = source.colours if lines.has_colours else None
    return FileContent(content.points, content.polygons, present, source, colours=colours)


class _Content:
    """What the lines say, and what is wrong with them.

    found: how many lines there were.  coloured: how many faces have more than their vertices.
    """

    def __init__(self, lines: OffLines) -> None:
        self.lines = lines
        self.found = self.coloured = 0
        self.flaws: list[Flaw] = []
        self.points = np.concatenate([np.empty((0, 3)), *map(self._points, lines.vertices())])
        parts = [(np.empty(0, np.int64), np.empty(0, np.int64)), *map(self._faces, lines.faces())]
        sizes, corners = (np.concatenate(column) for column in zip(*parts, strict=True))
        self.polygons = Polygons(sizes, corners)

    def _points(self, lines: Lines) -> FloatArray:
        self.found += len(lines)
        points, flaws = finite_points(lines, 0)
        self.flaws += flaws
        return points

    def _faces(self, lines: Lines) -> tuple[IntArray, IntArray]:
        self.found += len(lines)
        try:
            sizes, corners = _read_faces(lines)
        except (ValueError, OverflowError):
            bad = first_failing(lines, _read_faces)
            self._flaw(lines, bad, "expected a count of at least three and that many vertices")
            sizes, corners = _read_faces(lines[:bad])
        last = self.lines.vertex_count - 1
        wrong = np.flatnonzero((corners < 0) | (corners > last))
        if wrong.size:
            bad = int(np.searchsorted(np.cumsum(sizes), wrong[0], side="right"))
            number = corners[wrong[0]]
            self._flaw(lines, bad, f"the face names vertex {number}, but they go from 0 to {last}")
        self.coloured += int((lines.count[: len(sizes)] > sizes + 1).sum())
        return sizes, corners

    def _flaw(self, lines: Lines, at: int, message: str) -> None:
        self.flaws.append(Flaw(2, int(lines.places[at]), message))


def _read_faces(lines: Lines) -> tuple[IntArray, IntArray]:
    """Sizes, and corners one after another. Raises ValueError or OverflowError."""
    sizes = whole_numbers(lines.block.joined(lines.first, lines.first))
    if (sizes < 3).any() or (sizes >= lines.count).any():
        raise ValueError("a line is too short")
    return sizes, whole_numbers(lines.block.joined(lines.first + 1, lines.first + sizes))
