"""Writing OFF files: a deformed copy of the file that was read, or a plain one."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from solver.mesh.formats.colours import whole
from solver.mesh.formats.columns import changed_columns
from solver.mesh.formats.format import DeformedSurface
from solver.mesh.formats.off.lines import OffLines
from solver.mesh.formats.off.read import OffSource
from solver.mesh.formats.text.listing import point_lines, polygon_lines
from solver.mesh.formats.text.points import read_any
from solver.mesh.formats.text.splice import Replacement, spliced


def write_off(surface: DeformedSurface) -> bytes:
    """The file that was read with new positions and normals, or positions, colours and faces.

    Numbers have the shortest text that reads back the same float64.
    """
    if isinstance(surface.source, OffSource):
        return b"".join(_rewritten(surface.source.data, surface))
    X, polygons = surface.positions, surface.polygons
    colours = None if surface.colours is None else whole(surface.colours())
    keyword = b"OFF" if colours is None else b"COFF"
    head = keyword + b"\n%d %d 0\n" % (len(X), len(polygons.sizes))
    points = point_lines(b"", X, colours)
    return head + points + polygon_lines(lambda size: b"%d" % size, polygons)


def _rewritten(data: bytes, surface: DeformedSurface) -> Iterator[bytes]:
    normals = None
    if OffLines("", data).has_normals:
        normals = np.concatenate([read_any(some, 3) for some in OffLines("", data).vertices()])
    values, changed = changed_columns(surface, normals)

    def replacements() -> Iterator[Replacement]:
        done = 0
        for lines in OffLines("", data, surface.progress).vertices():
            rows = slice(done, done + len(lines))
            words = (lines.first[:, None] + np.arange(values.shape[1]))[changed[rows]]
            ends = lines.block.ends(words)
            yield Replacement(lines.block.places(words), ends, values[rows][changed[rows]])
            done = rows.stop

    return spliced(data, replacements())
