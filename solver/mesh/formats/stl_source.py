"""An STL file that was read, written back with the shape that its surface has now."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from solver.mesh.formats.columns import turned_face_normals
from solver.mesh.formats.format import DeformedSurface
from solver.mesh.formats.narrowing import check_distinct, narrowed, widened
from solver.mesh.formats.text.file import TextFile
from solver.mesh.formats.text.lines import Lines
from solver.mesh.formats.text.points import read_any
from solver.mesh.formats.text.splice import Replacement, spliced
from solver.mesh.progress import Progress, silent
from solver.types import BoolArray, FloatArray

RECORD = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
HEAD = 84


@dataclass(frozen=True)
class StlSource:
    """An STL file, for writing it back: header or names, attributes, order of triangles."""

    data: bytes
    is_text: bool

    def rewritten(self, surface: DeformedSurface) -> bytes:
        """The file with new numbers for corners that moved and normals that turned.

        A triangle whose normal is zero, as some programs write it, keeps that.
        """
        return b"".join(self._text(surface)) if self.is_text else self._binary(surface)

    def lines(self, progress: Progress = silent) -> Iterator[Lines]:
        """Of a text: its lines, some thousands at a time; keywords are small letters."""
        return map(Lines.of, TextFile("", self.data.lower()).blocks(progress=progress))

    def _binary(self, surface: DeformedSurface) -> bytes:
        triangles = surface.triangles
        end = HEAD + len(triangles) * RECORD.itemsize
        records = np.frombuffer(self.data[HEAD:end], RECORD).copy()
        normals, turned = turned_face_normals(surface, widened(records["normal"]))
        moved, stored = surface.moved[triangles], narrowed(surface.positions, "<f4")
        if moved.any():
            check_distinct(surface.positions, stored, triangles, surface.path)
        records["corners"][moved] = stored[triangles[moved]]
        records["normal"][turned] = normals[turned]
        return self.data[:HEAD] + records.tobytes() + self.data[end:]

    def _text(self, surface: DeformedSurface) -> Iterator[bytes]:
        before = [read_any(lines.beginning_with(b"facet"), 2) for lines in self.lines()]
        normals, turned = turned_face_normals(surface, np.concatenate(before))
        corners = surface.triangles.ravel()
        points, moved = surface.positions[corners], surface.moved[corners]
        return spliced(
            self.data, self._replacements(points, moved, normals, turned, surface.progress)
        )

    def _replacements(
        self,
        points: FloatArray,
        moved: BoolArray,
        normals: FloatArray,
        turned: BoolArray,
        progress: Progress,
    ) -> Iterator[Replacement]:
        """Of all corners (3 m, 3) and normals (m, 3) those that changed."""
        corner = facet = 0
        for lines in self.lines(progress):
            at, normal_at = lines.beginning_with(b"vertex"), lines.beginning_with(b"facet")
            rows = slice(corner, corner + len(at))
            facets = slice(facet, facet + len(normal_at))
            corner, facet = rows.stop, facets.stop
            first = np.concatenate([at.first[moved[rows]] + 1, normal_at.first[turned[facets]] + 2])
            values = np.concatenate([points[rows][moved[rows]], normals[facets][turned[facets]]])
            order = np.argsort(first)
            words = (first[order, None] + np.arange(3)).ravel()
            block = lines.block
            yield Replacement(block.places(words), block.ends(words), values[order].ravel())
