"""Writing OBJ files: a deformed copy of the file that was read, or a plain one."""

from __future__ import annotations

import re
from collections.abc import Sequence

import numpy as np

from solver.mesh.formats.format import DeformedSurface
from solver.mesh.formats.obj.read import ObjSource, byte_order_mark, obj_lines
from solver.mesh.normals import turn_normals
from solver.mesh.polygons import Polygons
from solver.types import FloatArray, IntArray

# Blanks may hold a backslash that continues the line.
_BLANK, _TOKEN = rb"(?:\s|\\(?=\s))+", rb"[^\s\\#]+"
_THREE_NUMBERS = re.compile(
    rb"\s*vn?" + rb"".join(rb"(" + _BLANK + rb")" + _TOKEN for _ in range(3))
)


def write_obj(surface: DeformedSurface) -> bytes:
    """The file that was read with new `v` and `vn` lines, or `v` and `f` lines alone.

    Numbers have the shortest text that reads back the same float64.
    """
    if isinstance(surface.source, ObjSource):
        return _rewritten(surface.source, surface)
    return _plain(surface.positions, surface.polygons)


def _rewritten(source: ObjSource, surface: DeformedSurface) -> bytes:
    """The source with new lines for the vertices that moved and the normals that turned.

    Every other byte stays: other lines, weights and colours after coordinates, comments, blanks,
    line endings.
    """
    rest, X = surface.rest, surface.positions
    users = source.corner_normals[surface.triangle_corners]
    normals, turned = turn_normals(source.normals, users, rest, X, surface.triangles)
    moved = (rest != X).any(axis=1)
    lines = obj_lines(source.data)
    _replace(lines, source.vertex_lines[moved], X[moved])
    _replace(lines, source.normal_lines[turned], normals[turned])
    return byte_order_mark(source.data) + b"".join(lines)


def _plain(X: FloatArray, polygons: Polygons) -> bytes:
    vertices = [b"v %a %a %a\n" % tuple(row) for row in X.tolist()]
    one_based = Polygons(polygons.sizes, polygons.corners + 1)
    faces = ["f " + " ".join(map(str, face)) + "\n" for face in one_based.tolist()]
    return b"".join(vertices) + "".join(faces).encode()


def _replace(lines: list[bytes], at: IntArray, values: FloatArray) -> None:
    for i, (x, y, z) in zip(at.tolist(), _rows(values), strict=True):
        line = lines[i]
        match = _THREE_NUMBERS.match(line)
        # The reader found three numbers in this very line.
        assert match is not None
        head = line[: match.start(1)]
        a, b, c = match.groups()
        lines[i] = b"%b%b%a%b%a%b%a%b" % (head, a, x, b, y, c, z, line[match.end() :])


def _rows(values: FloatArray) -> Sequence[tuple[float, float, float]]:
    rows: list[tuple[float, float, float]] = np.asarray(values, dtype=np.float64).tolist()
    return rows
