"""The limbs of each piece of a mesh, found where they are asked for."""

from __future__ import annotations

from app.selection.limbs import Limbs
from solver.mesh.mesh import Mesh


class PieceLimbs:
    """Finds limbs at rest, and once a piece."""

    def __init__(self, mesh: Mesh) -> None:
        self._mesh = mesh
        self._found: dict[int, Limbs] = {}

    def at(self, vertex: int) -> Limbs:
        """Those of the piece that a vertex of a face belongs to."""
        mesh, piece = self._mesh, int(self._mesh.pieces[vertex])
        if piece not in self._found:
            own = mesh.faces[mesh.pieces[mesh.faces[:, 0]] == piece]
            self._found[piece] = Limbs(mesh.vertices, own)
        return self._found[piece]
