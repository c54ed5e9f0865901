"""Writing OBJ files: a deformed copy of the file that was read, or a plain one."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import pairwise

import numpy as np

from solver.mesh.formats.format import DeformedSurface
from solver.mesh.formats.obj.read import ObjSource
from solver.mesh.formats.text.listing import point_lines, polygon_lines
from solver.mesh.formats.text.splice import Replacement, spliced
from solver.mesh.normals import turn_normals
from solver.mesh.polygons import Polygons
from solver.mesh.progress import Progress, portion
from solver.types import FloatArray, IntArray

# Blanks may hold a backslash that continues the line.
_THREE_NUMBERS = re.compile(rb"vn?(?:[\s\\]+[^\s\\#]+){3}")
# A comment and a backslash that continues a line end a word too.
_BLANKS = bytes.maketrans(b"\t\r\v\f\n\\#", b"       ")
_BLANK = ord(" ")
# Bytes of the file that are worked on at a time.
_SPAN = 1 << 20


def write_obj(surface: DeformedSurface) -> bytes:
    """The file that was read with new `v` and `vn` lines, or `v` with colours and `f` lines.

    Numbers have the shortest text that reads back the same float64.
    """
    if isinstance(surface.source, ObjSource):
        return b"".join(_rewritten(surface.source, surface))
    one_based = Polygons(surface.polygons.sizes, surface.polygons.corners + 1)
    colours = None if surface.colours is None else np.round(surface.colours()[:, :3], 6)
    points = point_lines(b"v ", surface.positions, colours)
    return points + polygon_lines(lambda size: b"f", one_based)


def _rewritten(source: ObjSource, surface: DeformedSurface) -> Iterator[bytes]:
    """The source with new numbers for the vertices that moved and the normals that turned.

    Every other byte stays: other lines, weights and colours after coordinates, comments, blanks,
    line endings.
    """
    rest, X = surface.rest, surface.positions
    users = source.corner_normals[surface.triangle_corners]
    normals, turned = turn_normals(source.normals, users, rest, X, surface.triangles)
    moved = surface.moved
    at = np.concatenate([source.vertex_at[moved], source.normal_at[turned]])
    values = np.concatenate([X[moved], normals[turned]])
    order = np.argsort(at, kind="stable")
    # Normals take about a third of the time.
    progress = portion(surface.progress, 0.3, 1.0)
    return spliced(source.data, _replacements(source.data, at[order], values[order], progress))


def _replacements(
    data: bytes, at: IntArray, values: FloatArray, progress: Progress
) -> Iterator[Replacement]:
    """`values` (l, 3) for the three words after the keywords at bytes `at` (l,)."""
    bounds = np.searchsorted(at, np.arange(0, len(data) + _SPAN, _SPAN)).tolist()
    for first, stop in pairwise(bounds):
        if first < stop:
            starts, stops = _triples(data, at[first:stop])
            yield Replacement(starts.ravel(), stops.ravel(), values[first:stop].ravel())
            progress(stop / len(at))


def _triples(data: bytes, at: IntArray) -> tuple[IntArray, IntArray]:
    """(l, 3) where the three words after each keyword start and stop."""
    start, last_line = int(at[0]), _THREE_NUMBERS.match(data, int(at[-1]))
    # The reader found three numbers in this very line.
    assert last_line is not None
    text = data[start : last_line.end()].translate(_BLANKS)
    blank = np.frombuffer(b" %b " % text, dtype=np.uint8) == _BLANK
    starts = np.flatnonzero(blank[:-1] & ~blank[1:]) + start
    stops = np.flatnonzero(~blank[:-1] & blank[1:]) + start
    words = np.searchsorted(starts, at)[:, None] + np.arange(1, 4)
    return starts[words], stops[words]
