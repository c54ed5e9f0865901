"""The rotation a dragged handle takes by itself, in closed form."""

from __future__ import annotations

import numpy as np

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


def procrustes(M: FloatArray) -> FloatArray:
    """R, (3, 3): argmax over rotations of tr(R M). [Kabsch 1976]"""
    S1, _, S2 = np.linalg.svd(M)
    flip = np.diag([1.0, 1.0, np.sign(np.linalg.det(S1) * np.linalg.det(S2))])
    R: FloatArray = S2.T @ flip @ S1.T
    return R


def rigid_motion(rest: FloatArray, moved: FloatArray) -> FloatArray:
    """argmin over rigid T, (4, 4), of sum ||T rest - moved||^2, for points (k, 3) each."""
    transform = np.eye(4)
    transform[:3, :3] = R = rigid_fit(rest, moved)
    transform[:3, 3] = moved.mean(axis=0) - R @ rest.mean(axis=0)
    return transform


def rigid_fit(rest: FloatArray, target: FloatArray) -> FloatArray:
    """R, (3, 3): the rotation that best takes points `rest` (k, 3) to `target` (k, 3).

    Where the points leave it open (a single point, a line) the one that turns least is taken.
    """
    p, q = rest - rest.mean(axis=0), target - target.mean(axis=0)
    M = p.T @ q
    # A touch of identity decides what the points do not.
    return procrustes(M + 1e-13 * (float(np.linalg.norm(M)) or 1.0) * np.eye(3))
