"""The rest shape as it is seen beside the deformed one."""

from __future__ import annotations

from solver.mesh.normals import smooth_normals
from solver.types import FloatArray, IntArray

DEPTH = 1e-3  # in diagonals: much less than what is worth comparing, much more than rounding


def ghost(V: FloatArray, F: IntArray, diagonal: float) -> FloatArray:
    """(n, 3) a little below the surface (V, F): where nothing has moved, nothing is seen."""
    return V - DEPTH * diagonal * smooth_normals(V, F)
