"""Writing OBJ files: a deformed copy of a source, or a plain one."""

from __future__ import annotations

import re
from collections.abc import Sequence

import numpy as np

from solver.mesh.formats.obj import ObjSource, byte_order_mark, obj_lines
from solver.mesh.polygons import Polygons
from solver.types import BoolArray, FloatArray, IntArray

# Blanks may hold a backslash that continues the line.
_BLANK, _TOKEN = rb"(?:\s|\\(?=\s))+", rb"[^\s\\#]+"
_THREE_NUMBERS = re.compile(
    rb"\s*vn?" + rb"".join(rb"(" + _BLANK + rb")" + _TOKEN for _ in range(3))
)


def rewrite_obj(
    source: ObjSource,
    X: FloatArray,
    moved: BoolArray,
    normals: FloatArray,
    turned: BoolArray,
) -> bytes:
    """The source with new `v` lines for `moved` (n,) vertices and `vn` lines for `turned` (k,).

    Every other byte stays: other lines, weights and colours after coordinates, comments, blanks,
    line endings. Numbers have the shortest text that reads back the same float64.
    """
    lines = obj_lines(source.data)
    _replace(lines, source.vertex_lines[moved], X[moved])
    _replace(lines, source.normal_lines[turned], normals[turned])
    return byte_order_mark(source.data) + b"".join(lines)


def plain_obj(X: FloatArray, polygons: Polygons) -> bytes:
    """An OBJ of `v` and `f` lines alone."""
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
