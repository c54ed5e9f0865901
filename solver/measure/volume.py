"""Volume inside a surface, closed or with holes that are capped."""

from __future__ import annotations

import numpy as np

from solver.geometry.topology import HALF_EDGE_END, HALF_EDGE_START, Topology, components
from solver.types import FloatArray, IntArray


def volume(X: FloatArray, F: IntArray) -> float:
    """Inside a closed surface; positive where its normals point outward.

    The sum over its triangles of the volume of the tetrahedron with the origin.
    """
    a, b, c = (X[corner] for corner in F.T)
    return float(np.einsum("ij,ij->", a, np.cross(b, c)) / 6)


class CappedSolid:
    """The inside of a surface with holes, each closed by a fan around the mean of its boundary.

    faces: (m, 3) triangles over `vertex_count` vertices.
    """

    def __init__(self, faces: IntArray, vertex_count: int) -> None:
        topology = Topology(faces, vertex_count)
        valence = np.bincount(topology.half_edge_edge.ravel(), minlength=len(topology.edges))
        face, half = np.nonzero(valence[topology.half_edge_edge] == 1)
        sides = np.column_stack(
            [faces[face, HALF_EDGE_START[half]], faces[face, HALF_EDGE_END[half]]]
        )
        loop = components(sides, vertex_count)[sides[:, 0]]
        self._loops = [sides[loop == label] for label in np.unique(loop)]
        fans = [
            np.column_stack([side[:, ::-1], np.full(len(side), vertex_count + number)])
            for number, side in enumerate(self._loops)
        ]
        self._faces = np.concatenate([faces, *fans])

    def volume(self, X: FloatArray) -> float:
        """Of the pose X, (n, 3)."""
        middles = (X[loop[:, 0]].mean(axis=0) for loop in self._loops)
        return volume(np.vstack([X, *middles]), self._faces)
