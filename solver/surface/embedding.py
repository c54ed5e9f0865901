"""How the mesh that is shown hangs on the surface that is solved.

    X_shown = rest_shown + E (U - U_rest)

with U the solved surface's positions and frames, and E a sparse operator that reproduces affine
motions exactly. Constraints, softness and the energy know the solved surface alone; what a person
touches is the shown mesh. Only this module maps between them.
"""

from __future__ import annotations

from typing import Protocol

from numpy.typing import ArrayLike

from solver.arrays import as_faces, as_vertices
from solver.setup import Setup
from solver.types import FloatArray, IntArray


class Embedding(Protocol):
    """One shown mesh on one solved surface.

    shown: (n', 3) rest positions of the mesh that is shown.
    vertices, faces: (n, 3) and (m, 3) of the surface that is solved.
    """

    shown: FloatArray
    vertices: FloatArray
    faces: IntArray

    def setup(self, setup: Setup) -> Setup:
        """What the solved surface is bound to where the shown mesh is bound to `setup`."""

    def weights(self, weights: ArrayLike) -> ArrayLike:
        """(n,) a grab's weights on the solved surface, from those on the shown mesh, (n',)."""

    def apply(self, rows: FloatArray) -> FloatArray:
        """E rows, (n', k), for a change of U or a basis, (n + 3m, k)."""

    def apply_rigid(self, displacement: FloatArray, rotations: FloatArray) -> FloatArray:
        """(n', 3) as `apply`, with rotations in place of frames.

        displacement: (n, 3).  rotations: (m, 3, 3) rows of R' of each triangle.
        """


class Identity:
    """The mesh that is shown is the surface that is solved. See Embedding."""

    def __init__(self, vertices: FloatArray, faces: IntArray) -> None:
        self.shown = self.vertices = vertices
        self.faces = faces

    def setup(self, setup: Setup) -> Setup:
        return setup

    def weights(self, weights: ArrayLike) -> ArrayLike:
        return weights

    def apply(self, rows: FloatArray) -> FloatArray:
        return rows[: len(self.vertices)]

    def apply_rigid(self, displacement: FloatArray, rotations: FloatArray) -> FloatArray:
        return displacement


def embed(V: ArrayLike, F: ArrayLike) -> Embedding:
    """The embedding of a mesh (n, 3), (m, 3). Raises MeshError."""
    vertices = as_vertices(V)
    return Identity(vertices, as_faces(F, len(vertices)))
