"""The rotation of a dragged handle that costs the least energy, in closed form."""

from __future__ import annotations

import numpy as np

from solver.geometry.procrustes import procrustes
from solver.types import FloatArray

# Below this share of the system's stiffness nothing resists a turn: rounding would choose it.
NEGLIGIBLE = 1e-12


def best_rotation(
    form: FloatArray,
    handle: int,
    centre: FloatArray,
    displacement: FloatArray,
    steps: FloatArray,
    current: FloatArray,
    stiffness: float,
) -> FloatArray:
    """R, (3, 3): argmin over SO(3) of E with the handle moved by x = R (p - c) + c + d.

    With coordinates centred on c the term quadratic in R is constant on SO(3), so that E is
    least where tr(R M) is greatest, M = Q_rr - Q_rt d' - sum over other handles Q_rg (T_g - I).

    form: Q, (4k, 4k).  centre, displacement: c and d, (3,), normalised.
    steps: (4k, 3) T - I of every handle.
    current: returned where nothing resists a turn.  stiffness: the unit of the energy.
    """
    own = slice(4 * handle, 4 * handle + 4)
    others = steps.copy()
    others[own] = 0.0
    # Rows [q', 1] centred on c relate to [p', 1] = [q', 1] L.
    L = np.eye(4)
    L[3, :3] = centre
    inverse = np.linalg.inv(L)
    Q = inverse.T @ form[own, own] @ inverse
    pull = inverse.T @ (form[own] @ others)
    M = Q[:3, :3] - np.outer(Q[:3, 3], displacement) - pull[:3]
    if np.linalg.norm(M) <= NEGLIGIBLE * stiffness:
        return current
    return procrustes(M)
