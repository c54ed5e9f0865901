"""How the mesh that is shown hangs on the surface that is solved.

    X_shown = rest_shown + E (U - U_rest)

with U the solved surface's positions and frames, and E a sparse operator that reproduces affine
motions exactly. Constraints, softness and the energy know the solved surface alone; what a person
touches is the shown mesh. Only this room maps between them.
"""

from __future__ import annotations

from typing import Protocol

from numpy.typing import ArrayLike

from solver.arrays import as_surface
from solver.geometry.topology import Topology
from solver.geometry.welding import weld
from solver.setup import Setup
from solver.surface.seams import Seams
from solver.types import FloatArray, IntArray


class Embedding(Protocol):
    """One shown mesh on one solved surface.

    shown: (n', 3) rest positions of the mesh that is shown.
    vertices, topology: of the surface that is solved, (n, 3).
    """

    shown: FloatArray
    vertices: FloatArray
    topology: Topology

    def setup(self, setup: Setup) -> Setup:
        """What the solved surface is bound to where the shown mesh is bound to `setup`."""

    def weights(self, weights: ArrayLike) -> ArrayLike:
        """(n,) a grab's weights on the solved surface, from those on the shown mesh, (n',)."""

    def targets(self, vertices: IntArray, targets: FloatArray, solved: IntArray) -> FloatArray:
        """Where a handle's solved vertices (j,) go, (j, 3).

        vertices, targets: (k,) of the shown mesh and (k, 3) where they go.
        """

    def apply(self, rows: FloatArray) -> FloatArray:
        """E rows, (n', k), for a change of U or a basis, (n + 3m, k)."""

    def apply_rigid(self, displacement: FloatArray, rotations: FloatArray) -> FloatArray:
        """(n', 3) as `apply`, with rotations in place of frames.

        displacement: (n, 3).  rotations: (a, 3, 3) rows of R' of the system's active triangles.
        """


class Identity:
    """The mesh that is shown is the surface that is solved. See Embedding."""

    def __init__(self, vertices: FloatArray, topology: Topology) -> None:
        self.shown = self.vertices = vertices
        self.topology = topology

    def setup(self, setup: Setup) -> Setup:
        return setup

    def weights(self, weights: ArrayLike) -> ArrayLike:
        return weights

    def targets(self, vertices: IntArray, targets: FloatArray, solved: IntArray) -> FloatArray:
        return targets

    def apply(self, rows: FloatArray) -> FloatArray:
        return rows[: len(self.vertices)]

    def apply_rigid(self, displacement: FloatArray, rotations: FloatArray) -> FloatArray:
        return displacement


def embed(V: ArrayLike, F: ArrayLike) -> Embedding:
    """The embedding of a mesh (n, 3), (m, 3): its seams are welded. Raises MeshError."""
    vertices, faces = as_surface(V, F)
    topology = Topology(faces, len(vertices))
    welded = weld(vertices, topology)
    if int(welded.max()) + 1 == len(vertices):
        return Identity(vertices, topology)
    return Seams(vertices, topology, welded)
