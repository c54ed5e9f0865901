"""The surface as it is shaded: one vertex over seams, several along hard edges.

What draws it makes normals of its own from the vertices that it is given.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from solver.mesh.mesh import Mesh
from solver.mesh.polygons import Polygons
from solver.types import BoolArray, FloatArray, IntArray


@dataclass(frozen=True, eq=False)
class Shaded:
    """polygons: over vertices that are drawn, (p, k) or lists.

    vertices: (k,) the vertex of the mesh where each of those is; None where they are the mesh's.
    """

    polygons: IntArray | list[list[int]]
    vertices: IntArray | None

    def of(self, values: FloatArray) -> FloatArray:
        """(k, 3) at the vertices that are drawn, of (n, 3) at those of the mesh."""
        return values if self.vertices is None else values[self.vertices]


def shaded(mesh: Mesh, hard: bool, seen: BoolArray | None = None) -> Shaded:
    """hard: with the file's hard edges, else smooth everywhere.  seen: (p,) polygons that are
    drawn, None for all."""
    outlines, vertices = mesh.outlines, None
    numbers = mesh.smooth_corners if hard else None
    if numbers is None and mesh.welded.max(initial=-1) + 1 < len(mesh.vertices):
        numbers = mesh.welded[outlines.corners]
    if numbers is not None:
        vertices = np.zeros(numbers.max() + 1, dtype=np.int64)
        vertices[numbers[::-1]] = outlines.corners[::-1]  # the first corner of each
        outlines = Polygons(outlines.sizes, numbers)
    if seen is not None:
        return Shaded(outlines.where(seen).rows(), vertices)
    return Shaded(mesh.polygons if numbers is None else outlines.rows(), vertices)
