"""The rest shape as it is seen beside the deformed one."""

from __future__ import annotations

from solver.mesh.mesh import Mesh
from solver.mesh.normals import smooth_normals
from solver.types import FloatArray

DEPTH = 1e-3  # in diagonals: much less than what is worth comparing, much more than rounding


def ghost(mesh: Mesh, diagonal: float) -> FloatArray:
    """Positions (n, 3) a little below the surface: where nothing has moved, nothing is seen."""
    V = mesh.vertices
    return V - DEPTH * diagonal * smooth_normals(V, mesh.faces)
