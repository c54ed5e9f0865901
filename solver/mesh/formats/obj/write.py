"""Writing OBJ files: a deformed copy of the file that was read, or a plain one."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import pairwise

import numpy as np

from solver.mesh.formats.format import DeformedSurface
from solver.mesh.formats.lines import point_lines, polygon_lines
from solver.mesh.formats.obj.read import ObjSource
from solver.mesh.formats.splice import replace_words
from solver.mesh.normals import turn_normals
from solver.mesh.polygons import Polygons
from solver.types import FloatArray, IntArray

# Blanks may hold a backslash that continues the line.
_THREE_NUMBERS = re.compile(rb"vn?(?:[\s\\]+[^\s\\#]+){3}")
# Bytes of the file that are worked on at a time.
_SPAN = 1 << 20


def write_obj(surface: DeformedSurface) -> bytes:
    """The file that was read with new `v` and `vn` lines, or `v` and `f` lines alone.

    Numbers have the shortest text that reads back the same float64.
    """
    if isinstance(surface.source, ObjSource):
        return b"".join(_rewritten(surface.source, surface))
    one_based = Polygons(surface.polygons.sizes, surface.polygons.corners + 1)
    return point_lines(b"v ", surface.positions) + polygon_lines(b"f", one_based)


def _rewritten(source: ObjSource, surface: DeformedSurface) -> Iterator[bytes]:
    """The source with new numbers for the vertices that moved and the normals that turned.

    Every other byte stays: other lines, weights and colours after coordinates, comments, blanks,
    line endings.
    """
    rest, X = surface.rest, surface.positions
    users = source.corner_normals[surface.triangle_corners]
    normals, turned = turn_normals(source.normals, users, rest, X, surface.triangles)
    moved = (rest != X).any(axis=1)
    at = np.concatenate([source.vertex_at[moved], source.normal_at[turned]])
    values = np.concatenate([X[moved], normals[turned]])
    order = np.argsort(at, kind="stable")
    return _with_triples(source.data, at[order], values[order])


def _with_triples(data: bytes, at: IntArray, values: FloatArray) -> Iterator[bytes]:
    """The data with `values` (l, 3) after the keywords at bytes `at` (l,), piece by piece."""
    bounds = np.searchsorted(at, np.arange(0, len(data) + _SPAN, _SPAN)).tolist()
    done = 0
    for first, stop in pairwise(bounds):
        if first == stop:
            continue
        last_line = _THREE_NUMBERS.match(data, at[stop - 1])
        # The reader found three numbers in this very line.
        assert last_line is not None
        start, end = int(at[first]), last_line.end()
        yield data[done:start]
        yield replace_words(data[start:end], at[first:stop] - start, values[first:stop])
        done = end
    yield data[done:]
