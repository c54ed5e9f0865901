"""The place of a turned handle that costs the least energy, in closed form."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from solver.linear.best_rotation import NEGLIGIBLE
from solver.types import FloatArray


def best_shifts(
    form: FloatArray, handles: Sequence[int], steps: FloatArray, stiffness: float
) -> FloatArray:
    """d, (k, 3): argmin of E over shifts of k handles together, their linear parts kept.

    E(T + d) = E(T) + tr d' (Q (T - I))_t + 1/2 tr d' Q_tt d with the rows t of the translations of
    the k handles: Q_tt d = -(Q (T - I))_t. In directions that nothing resists d is zero.

    form: Q, (4h, 4h).  steps: (4h, 3) T - I of every handle, normalised, as d is.
    stiffness: the unit of the energy.
    """
    rows = 4 * np.asarray(handles, dtype=np.int64) + 3
    values, vectors = np.linalg.eigh(form[np.ix_(rows, rows)])
    stiff = values > NEGLIGIBLE * stiffness
    values, vectors = values[stiff], vectors[:, stiff]
    return np.asarray(-(vectors / values) @ (vectors.T @ (form[rows] @ steps)))
