"""How the energy's slope at a pose depends on the softness of vertices."""

from __future__ import annotations

import numpy as np

from solver.geometry.cotangent_weights import ElementWeights
from solver.geometry.topology import HALF_EDGE_END, HALF_EDGE_START
from solver.learning.sensitivity import Change
from solver.linear.rest_surface import RestSurface
from solver.rigid.levels import RigidPose
from solver.softness.material import Material
from solver.types import BoolArray, FloatArray, IntArray


class MaterialSlope:
    """d/ds of the energy's change along a small change of a pose, s the softness of vertices.

    The energy E(X, R) of SmoothRotationEnergy is a sum over elements of gain * |residual|^2 / 2;
    along a change it changes by gain * <residual, change of it>. Gains are material^s, s the mean
    over the two ends of an edge.
    """

    def __init__(self, rest: RestSurface, active: IntArray, material: Material) -> None:
        """active: (a,) the triangles whose rotations poses have."""
        topology = rest.topology
        known: BoolArray = np.zeros(len(rest.faces), dtype=bool)
        known[active] = True
        ends = topology.links[: len(topology.pairs.edge)]  # pinches have no material
        self._pairs = np.flatnonzero(known[ends].all(axis=1))
        self._ends = np.searchsorted(active, ends[self._pairs])
        self._pair_edge = topology.pairs.edge[self._pairs]
        self._half_edge_edge = topology.half_edge_edge[active]
        self._edges, self._size = topology.edges, len(rest.points)
        self._faces, self._active = rest.faces[active], active
        self._vectors = rest.energy.vectors[active]
        self._rates = np.log([material.bending, material.stretching])

    def along(
        self, pose: RigidPose, change: Change, weights: ElementWeights, ratio: float
    ) -> FloatArray:
        """(n,) for each vertex.

        weights: with gains.  ratio: of the bending terms of the energy to those of the weights.
        """
        bend = self._bends(pose.rotations), self._bends(change.rotations)
        stretch = (
            self._stretches(pose.positions, pose.rotations),
            self._stretches(change.positions, change.rotations),
        )
        bending = ratio * weights.bending[self._pairs] * np.einsum("ijk,ijk->i", *bend)
        stretching = weights.stretching[self._active] * np.einsum("tij,tij->ti", *stretch)
        count = len(self._edges)
        by_edge = self._rates[0] * np.bincount(self._pair_edge, bending, count)
        by_edge += self._rates[1] * np.bincount(
            self._half_edge_edge.ravel(), stretching.ravel(), count
        )
        at_ends = np.repeat(0.5 * by_edge, 2)
        return np.bincount(self._edges.ravel(), at_ends, self._size).astype(np.float64)

    def _bends(self, rows: FloatArray) -> FloatArray:
        """(p, 3, 3) the residuals R_j - R_i."""
        return np.asarray(rows[self._ends[:, 1]] - rows[self._ends[:, 0]])

    def _stretches(self, X: FloatArray, rows: FloatArray) -> FloatArray:
        """(a, 3, 3) the residuals x_b - x_a - R (p_b - p_a) of the half-edges."""
        ends = X[self._faces[:, HALF_EDGE_END]] - X[self._faces[:, HALF_EDGE_START]]
        return np.asarray(ends - self._vectors @ rows)
