"""The quadratic energies E = l^2 E_f + E_x as sparse matrices.

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
from solver.types import FloatArray, IntArray
from solver.weights import (
    REGULAR,
    bending_weights,
    half_edge_cotangents,
    stretching_weights,
)


@dataclass(frozen=True)
class RestWeights:
    """Weights of the rest surface, before material gains.

    stretching: (m, 3) w_eT of each half-edge.
    bending: (p,) w_e^-1 of each two neighbours, divided by k - 1 on an edge with k triangles.
    """

    stretching: FloatArray
    bending: FloatArray


def rest_weights(half_edge_lengths: FloatArray, pairs: FacePairs) -> RestWeights:
    """The weights of both energies, from edge lengths (m, 3) opposite each corner alone."""
    cotangents = half_edge_cotangents(half_edge_lengths)
    first, second = (pairs.first, pairs.half_first), (pairs.second, pairs.half_second)
    w = bending_weights(cotangents, first, second)
    return RestWeights(stretching_weights(cotangents), 1.0 / (w * (pairs.valence - 1)))


def deformation_matrix(
    P: FloatArray,
    topology: Topology,
    bending_length: float,
    gains: tuple[FloatArray, FloatArray],
) -> sp.csc_array:
    """K, (n + 3m, n + 3m), of the energy kept relative to the rest surface P (n, 3):

        l^2/2 sum w_e^-1 beta_e ||G_j - G_i||^2
            + 1/2 sum w_eT sigma_e ||x_b - x_a - G_T (p_b - p_a)||^2

    gains: (beta, sigma), one value an edge. G = I, X = P is a minimiser with E = 0.
    """
    beta, sigma = gains
    pairs = topology.pairs
    d = half_edge_vectors(P, topology.faces)
    weights = rest_weights(np.linalg.norm(d, axis=2), pairs)
    stretching = weights.stretching * sigma[topology.half_edge_edge]
    bending = bending_length**2 * weights.bending * beta[pairs.edge]
    joint = np.full(len(topology.pinches), bending_length**2 / REGULAR)
    links = np.concatenate([np.column_stack([pairs.first, pairs.second]), topology.pinches])
    return _assemble(topology, d, stretching, links, np.concatenate([bending, joint]))


def cotangent_laplacian(P: FloatArray, faces: IntArray) -> sp.csc_array:
    """Cotangent Laplacian, (n, n), positive semi-definite, weights clamped to positive values.

    [Pinkall & Polthier 1993], without their factor 1/2.
    """
    d = half_edge_vectors(P, faces)
    weights = stretching_weights(half_edge_cotangents(np.linalg.norm(d, axis=2)))
    rows, columns, values = _vertex_entries(faces, weights)
    return sp.csc_array(sp.coo_array((values, (rows, columns)), shape=(len(P), len(P))))


def half_edge_vectors(P: FloatArray, faces: IntArray) -> FloatArray:
    """(m, 3, 3): row k of triangle t is the vector along its half-edge k."""
    return P[faces[:, HALF_EDGE_END]] - P[faces[:, HALF_EDGE_START]]


def _assemble(
    topology: Topology, d: FloatArray, w: FloatArray, links: IntArray, link_weights: FloatArray
) -> sp.csc_array:
    """The symmetric matrix, block by block: vertex-vertex, vertex-frame, frame-frame."""
    n, m = topology.vertex_count, len(topology.faces)
    frame_row = n + 3 * np.arange(m)[:, None] + np.arange(3)
    vertex = _vertex_entries(topology.faces, w)
    wd = w[:, :, None] * d
    # Corner k starts half-edge k+2 and ends half-edge k+1.
    mixed_values = (wd[:, HALF_EDGE_END] - wd[:, HALF_EDGE_START]).ravel()
    mixed_rows = np.repeat(topology.faces.ravel(), 3)
    mixed_columns = np.repeat(frame_row[:, None, :], 3, axis=1).ravel()
    own = np.einsum("tki,tkj->tij", wd, d)
    degree = np.bincount(links.ravel(), weights=np.repeat(link_weights, 2), minlength=m)
    own[:, np.arange(3), np.arange(3)] += degree[:, None]
    own_rows, own_columns = np.repeat(frame_row, 3, axis=1), np.tile(frame_row, 3)
    one, two = frame_row[links[:, 0]].ravel(), frame_row[links[:, 1]].ravel()
    across = -np.repeat(link_weights, 3)
    rows = [vertex[0], mixed_rows, mixed_columns, own_rows.ravel(), one, two]
    columns = [vertex[1], mixed_columns, mixed_rows, own_columns.ravel(), two, one]
    values = [vertex[2], mixed_values, mixed_values, own.ravel(), across, across]
    entries = (np.concatenate(values), (np.concatenate(rows), np.concatenate(columns)))
    return sp.csc_array(sp.coo_array(entries, shape=(n + 3 * m, n + 3 * m)))


def _vertex_entries(faces: IntArray, w: FloatArray) -> tuple[IntArray, IntArray, FloatArray]:
    a, b = faces[:, HALF_EDGE_START].ravel(), faces[:, HALF_EDGE_END].ravel()
    values = w.ravel()
    return (
        np.concatenate([a, b, a, b]),
        np.concatenate([a, b, b, a]),
        np.concatenate([values, values, -values, -values]),
    )


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
