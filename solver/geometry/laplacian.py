"""The cotangent Laplacian of a triangle mesh. [Pinkall & Polthier 1993]"""

from __future__ import annotations

import numpy as np
import scipy.sparse as sp

from solver.geometry.cotangent_weights import half_edge_cotangents, stretching_weights
from solver.geometry.topology import HALF_EDGE_END, HALF_EDGE_START, half_edge_vectors
from solver.types import FloatArray, IntArray


def cotangent_laplacian(P: FloatArray, faces: IntArray) -> sp.csr_array:
    """Cotangent Laplacian, (n, n), positive semi-definite, weights clamped to positive values.

    [Pinkall & Polthier 1993], without their factor 1/2.
    """
    lengths = np.linalg.norm(half_edge_vectors(P, faces), axis=2)
    w = stretching_weights(half_edge_cotangents(lengths)).ravel()
    a, b = faces[:, HALF_EDGE_START].ravel(), faces[:, HALF_EDGE_END].ravel()
    rows, columns = np.concatenate([a, b, a, b]), np.concatenate([a, b, b, a])
    values = np.concatenate([w, w, -w, -w])
    return sp.csr_array(sp.coo_array((values, (rows, columns)), shape=(len(P), len(P))))
