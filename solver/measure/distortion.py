"""How a deformed surface differs from its rest shape: lengths, bends and areas."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import scipy.sparse as sp

from solver.geometry.cross_products import cross
from solver.geometry.topology import Topology
from solver.types import BoolArray, FloatArray, IntArray


@dataclass(frozen=True, eq=False)
class DistortionField:
    """One measure of a deformed surface.

    elements: one value for each edge, inner edge or triangle, in the order of `Distortion`.
    vertices: (n,) the same gathered at the vertices, to colour them by.
    rms: root of the mean square over the elements that have a counted vertex, 0 without any.
    """

    elements: FloatArray
    vertices: FloatArray
    rms: float


class Distortion:
    """Measures of a surface X (n, 3) against the rest shape V, all 0 for a rigid motion of it.

    edges: (e, 2) that `strain` measures.  hinges: (p, 2) the ends of the edges with exactly two
    triangles, which `dihedral` measures.  `area` measures the triangles, (m,).
    What had no length or area at rest counts as unchanged.
    """

    def __init__(self, V: FloatArray, F: IntArray) -> None:
        topology = Topology(F, len(V))
        pairs = topology.manifold_pairs
        self.edges = topology.edges
        self.hinges = topology.edges[pairs.edge]
        self._faces = F
        self._sides = pairs.first, pairs.second
        # The sine of a dihedral angle changes sign with the direction its edge is run through.
        forward = topology.half_edge_forward[pairs.first, pairs.half_first]
        self._along = np.where(forward[:, None], self.hinges, self.hinges[:, ::-1])
        self._lengths = _lengths(V, self.edges)
        self._angles = self._dihedral_angles(V)
        self._areas = self._face_normals(V)[1]
        self._area_mean = _gather(F, self._areas, len(V))
        self._edge_stars = _Stars(self.edges, len(V))
        self._hinge_stars = _Stars(self.hinges, len(V))

    def strain(self, X: FloatArray, counted: BoolArray | None = None) -> DistortionField:
        """l' / l - 1 of each edge; at a vertex that of the edge which has changed most.

        counted: (n,) the vertices whose elements make the rms, None for all.
        """
        relative = _relative(_lengths(X, self.edges), self._lengths)
        most, least = (self._edge_stars.reduce(f, relative) for f in (np.maximum, np.minimum))
        vertices = np.where(most >= -least, most, least)
        return DistortionField(relative, vertices, _rms(relative, self.edges, counted))

    def dihedral(self, X: FloatArray, counted: BoolArray | None = None) -> DistortionField:
        """|theta' - theta| in [0, pi] of each hinge; at a vertex the largest around it."""
        turn = np.abs(self._dihedral_angles(X) - self._angles)
        turn = np.minimum(turn, 2 * np.pi - turn)
        vertices = self._hinge_stars.reduce(np.maximum, turn)
        return DistortionField(turn, vertices, _rms(turn, self.hinges, counted))

    def area(self, X: FloatArray, counted: BoolArray | None = None) -> DistortionField:
        """A' / A - 1 of each triangle; at a vertex the same of its triangles together."""
        relative = _relative(self._face_normals(X)[1], self._areas)
        return DistortionField(
            relative, self._area_mean @ relative, _rms(relative, self._faces, counted)
        )

    def _face_normals(self, X: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Unit normals (m, 3), zero where there is no area, and areas (m,)."""
        a, b, c = (X[corner] for corner in self._faces.T)
        normals = cross((b - a).T, (c - a).T).T
        double = np.sqrt(np.einsum("ij,ij->i", normals, normals))
        normals /= np.where(double > 0, double, 1.0)[:, None]
        return normals, 0.5 * double

    def _dihedral_angles(self, X: FloatArray) -> FloatArray:
        normals = self._face_normals(X)[0]
        one, two = (normals[side] for side in self._sides)
        along = X[self._along[:, 1]] - X[self._along[:, 0]]
        length = np.sqrt(np.einsum("ij,ij->i", along, along))
        sine = np.einsum("ij,ij->i", along, cross(one.T, two.T).T)
        return np.arctan2(sine, length * np.einsum("ij,ij->i", one, two))


def _lengths(X: FloatArray, edges: IntArray) -> FloatArray:
    d = X[edges[:, 1]] - X[edges[:, 0]]
    return np.sqrt(np.einsum("ij,ij->i", d, d))


def _relative(now: FloatArray, rest: FloatArray) -> FloatArray:
    return np.where(rest > 0, now / np.where(rest > 0, rest, 1.0) - 1.0, 0.0)


def _rms(values: FloatArray, corners: IntArray, counted: BoolArray | None) -> float:
    if counted is not None:
        values = values[counted[corners].any(axis=1)]
    return float(np.sqrt(np.mean(values**2))) if len(values) else 0.0


def _gather(corners: IntArray, weights: FloatArray, vertex_count: int) -> sp.csr_array:
    """(n, k): the mean, by weight, of the elements that have a vertex as a corner."""
    element = np.repeat(np.arange(len(corners)), corners.shape[1])
    weight = np.repeat(weights, corners.shape[1])
    total = np.bincount(corners.ravel(), weight, vertex_count)
    share = weight / np.where(total > 0, total, 1.0)[corners.ravel()]
    shape = (vertex_count, len(corners))
    return sp.csr_array(sp.coo_array((share, (corners.ravel(), element)), shape=shape))


class _Stars:
    """The edges around each vertex."""

    def __init__(self, edges: IntArray, vertex_count: int) -> None:
        degree = np.bincount(edges.ravel(), minlength=vertex_count)
        self._around = np.argsort(edges.ravel(), kind="stable") // 2
        self._some = np.flatnonzero(degree)
        self._starts = (np.cumsum(degree) - degree)[self._some]
        self._vertex_count = vertex_count

    def reduce(self, function: np.ufunc, values: FloatArray) -> FloatArray:
        """(n,) from one value an edge; 0 at a vertex without edges."""
        result = np.zeros(self._vertex_count)
        if len(values):
            result[self._some] = function.reduceat(values[self._around], self._starts)
        return result
