"""The equations that know a surface by its fundamental forms alone. [Wang, Liu & Tong 2012]"""

from __future__ import annotations

import numpy as np
import scipy.sparse as sp

from solver.forms.fundamental_forms import (
    FundamentalForms,
    corner_points,
    transitions,
)
from solver.geometry.cotangent_weights import rest_weights
from solver.geometry.topology import HALF_EDGE_END, HALF_EDGE_START, FacePairs, Topology
from solver.types import FloatArray


def reconstruction_residuals(
    topology: Topology, forms: FundamentalForms, bending_length: float
) -> tuple[sp.csr_array, FloatArray]:
    """(D, w) of the energy 1/2 sum_i w_i ||(D U)_i||^2 that knows a surface by its forms alone:

        l^2/2 sum w_e^-1 ||f_j - f_i R_ij||^2 + 1/2 sum w_eT ||x_b - x_a - f_T a_eT||^2

    D: (3p + 3m, n + 3m), the equations of all neighbours, then of all half-edges.
    The sums of the paper's equations 5 and 6, with the signs of its linear system mended.
    """
    pairs = topology.manifold_pairs
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
