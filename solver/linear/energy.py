"""The quadratic energies E = l^2 E_f + E_x as weights on a mesh's elements.

Both forms act on U (n + 3m, 3): n positions, then three rows for each triangle, row k being
column k of the triangle's orthonormal frame f_t (from the forms) or of its frame G_t (from rest).
The world axes decouple: one matrix, three right-hand sides, E = 1/2 tr(U' K U).
"""

from __future__ import annotations

import numpy as np

from solver.geometry.cotangent_weights import (
    REGULAR,
    ElementWeights,
    rest_weights,
    typical_edge,
)
from solver.geometry.topology import Topology, half_edge_vectors
from solver.types import FloatArray

# The gains (beta, sigma) of each edge, (e,) each.
Gains = tuple[FloatArray, FloatArray]


class RestEnergy:
    """What the energy relative to the rest surface P (n, 3) takes from P, before any material:

        1/2 sum over links  l^2 w_e^-1 beta_e  ||G_j - G_i||^2
            + 1/2 sum over half-edges  w_eT sigma_e  ||x_b - x_a - G_T (p_b - p_a)||^2

    G = I, X = P is a minimiser with E = 0.

    vectors: (m, 3, 3), row k of triangle t being p_b - p_a along its half-edge k.
    """

    def __init__(self, P: FloatArray, topology: Topology) -> None:
        self._topology = topology
        self.vectors = half_edge_vectors(P, topology.faces)
        self._lengths = np.linalg.norm(self.vectors, axis=2)
        self._rest = rest_weights(self._lengths, topology.pairs)

    def resolved(self, bending_length: float) -> float:
        """The bending length that this mesh can tell from zero: at least an edge.

        Frames are constant on a triangle. With a shorter l the step between a held frame and
        the next costs too little, and a coarse mesh shears where a fine one bends.
        """
        return max(bending_length, typical_edge(self._lengths))

    def weights(self, bending_length: float, gains: Gains) -> ElementWeights:
        """With l and the material. A pinch joins with the weight of a regular, rigid edge."""
        beta, sigma = gains
        topology = self._topology
        pinches = np.full(len(topology.pinches), 1.0 / REGULAR)
        bending = np.concatenate([self._rest.bending * beta[topology.pairs.edge], pinches])
        stretching = self._rest.stretching * sigma[topology.half_edge_edge]
        return ElementWeights(stretching, bending_length**2 * bending)
