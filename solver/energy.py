"""The quadratic energies E = l^2 E_f + E_x as weights on a mesh's elements.

Both forms act on U (n + 3m, 3): n positions, then three rows for each triangle, row k being
column k of the triangle's frame f_t (from the forms) or of its deformation G_t (from rest).
The world axes decouple: one matrix, three right-hand sides, E = 1/2 tr(U' K U).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import scipy.sparse as sp

from solver.forms import FundamentalForms, corner_points, manifold_pairs, transitions
from solver.topology import HALF_EDGE_END, HALF_EDGE_START, FacePairs, Topology
from solver.types import FloatArray
from solver.weights import (
    REGULAR,
    bending_weights,
    half_edge_cotangents,
    stretching_weights,
    typical_edge,
)

# The gains (beta, sigma) of each edge, (e,) each.
Gains = tuple[FloatArray, FloatArray]


@dataclass(frozen=True)
class ElementWeights:
    """Weights of the two energies.

    stretching: (m, 3) w_eT of each half-edge, times sigma_e.
    bending: (q,) w_e^-1 of each of the topology's links, times beta_e and l^2; divided by k - 1
        on an edge with k triangles.
    """

    stretching: FloatArray
    bending: FloatArray


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


def rest_weights(half_edge_lengths: FloatArray, pairs: FacePairs) -> ElementWeights:
    """The rigid weights of half-edges and pairs, from edge lengths (m, 3) alone; l = 1."""
    cotangents = half_edge_cotangents(half_edge_lengths)
    first, second = (pairs.first, pairs.half_first), (pairs.second, pairs.half_second)
    w = bending_weights(cotangents, first, second)
    return ElementWeights(stretching_weights(cotangents), 1.0 / (w * (pairs.valence - 1)))


def half_edge_vectors(P: FloatArray, faces: np.ndarray) -> FloatArray:
    """(m, 3, 3): row k of triangle t is the vector along its half-edge k."""
    return P[faces[:, HALF_EDGE_END]] - P[faces[:, HALF_EDGE_START]]


def reconstruction_residuals(
    topology: Topology, forms: FundamentalForms, bending_length: float
) -> tuple[sp.csr_array, FloatArray]:
    """(D, w) of the energy 1/2 sum_i w_i ||(D U)_i||^2 that knows a surface by its forms alone:

        l^2/2 sum w_e^-1 ||f_j - f_i R_ij||^2 + 1/2 sum w_eT ||x_b - x_a - f_T a_eT||^2

    D: (3p + 3m, n + 3m), the equations of all neighbours, then of all half-edges.
    The sums of the paper's equations 5 and 6, with the signs of its linear system mended.
    """
    pairs = manifold_pairs(topology)
    half_lengths = forms.lengths[topology.half_edge_edge]
    weights = rest_weights(half_lengths, pairs)
    bend = _frame_differences(topology, transitions(topology, forms, pairs), pairs)
    stretch = _edge_differences(topology, corner_points(half_lengths))
    w_bend = np.repeat(bending_length**2 * weights.bending, 3)
    D = sp.csr_array(sp.vstack([bend, stretch]))
    return D, np.concatenate([w_bend, weights.stretching.ravel()])


def _frame_differences(topology: Topology, R: FloatArray, pairs: FacePairs) -> sp.csr_array:
    """R3: three rows for each two neighbours, the columns of f_j - f_i R_ij."""
    n, p = topology.vertex_count, len(pairs.first)
    row = 3 * np.arange(p)[:, None] + np.arange(3)
    one = n + 3 * pairs.first[:, None] + np.arange(3)
    two = n + 3 * pairs.second[:, None] + np.arange(3)
    # Column k of f_i R is the sum over l of R[l, k] times column l of f_i.
    rows = np.concatenate([row.ravel(), np.tile(row, 3).ravel()])
    columns = np.concatenate([two.ravel(), np.repeat(one, 3, axis=1).ravel()])
    values = np.concatenate([np.ones(3 * p), -R.ravel()])
    shape = (3 * p, n + 3 * len(topology.faces))
    return sp.csr_array(sp.coo_array((values, (rows, columns)), shape=shape))


def _edge_differences(topology: Topology, points: FloatArray) -> sp.csr_array:
    """R1 | -R2: one row for each half-edge, x_b - x_a - f_T a_eT."""
    faces = topology.faces
    n, m = topology.vertex_count, len(faces)
    a = points[:, HALF_EDGE_END] - points[:, HALF_EDGE_START]
    row = np.arange(3 * m)
    frame = np.repeat(n + 3 * np.arange(m), 3)
    start, end = faces[:, HALF_EDGE_START].ravel(), faces[:, HALF_EDGE_END].ravel()
    columns = np.concatenate([end, start, frame, frame + 1])
    one = np.ones(3 * m)
    values = np.concatenate([one, -one, -a[:, :, 0].ravel(), -a[:, :, 1].ravel()])
    entries = (values, (np.tile(row, 4), columns))
    return sp.csr_array(sp.coo_array(entries, shape=(3 * m, n + 3 * m)))
