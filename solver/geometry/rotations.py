"""Rotations of many triangles at once: the nearest ones, and small turns of them."""

from __future__ import annotations

import numpy as np

from solver.geometry.cross_products import cross
from solver.types import FloatArray

NEWTON_STEPS = 12
# Where the best and the second best rotation come this close, the quartic's largest root is nearly
# multiple: Newton's steps, slow there, stop short of it.
AMBIGUOUS = 1e-2


def nearest_rotations(A: FloatArray) -> FloatArray:
    """R, (m, 3, 3): argmin over SO(3) of ||R - A||, for A (m, 3, 3), reflections included.

    lambda = max tr(R'A) is the largest root of the quartic of Horn's quaternion matrix,
    (lambda^2 - s)^2 - 8 d lambda - 4 t with s = ||A||^2, d = det A, t = ||cof A||^2, and R is
    its gradient in A. [Horn 1987; Higham & Noferini 2016]
    """
    a = np.ascontiguousarray(np.moveaxis(A, 0, -1))  # (3, 3, m): arithmetic on whole columns
    cof = np.stack([cross(a[1], a[2]), cross(a[2], a[0]), cross(a[0], a[1])])
    s, t = (a**2).sum(axis=(0, 1)), (cof**2).sum(axis=(0, 1))
    d = (a[0] * cof[0]).sum(axis=0)
    x = np.sqrt(3.0 * s)  # an upper bound, from which Newton's steps descend to the root
    with np.errstate(divide="ignore", invalid="ignore"):
        for _ in range(NEWTON_STEPS):
            x = x - ((x**2 - s) ** 2 - 8.0 * d * x - 4.0 * t) / (4.0 * (x * (x**2 - s) - 2.0 * d))
        slope = x * (x**2 - s) - 2.0 * d
        aaa = np.einsum("ijm,kjm,klm->ilm", a, a, a, optimize=True)
        R = ((x**2 + s) * a + 2.0 * x * cof - 2.0 * aaa) / slope
    R = np.moveaxis(R, -1, 0)
    doubtful = ~(slope > AMBIGUOUS * s**1.5)  # NaN counts as doubtful
    if doubtful.any():
        R[doubtful] = _nearest_by_svd(A[doubtful])
    return R


def _nearest_by_svd(A: FloatArray) -> FloatArray:
    U, _, Vt = np.linalg.svd(A)
    U[:, :, 2] *= np.sign(np.linalg.det(U) * np.linalg.det(Vt))[:, None]
    R: FloatArray = U @ Vt
    return R


def turned(rows: FloatArray, w: FloatArray) -> FloatArray:
    """Each row v of rows (m, 3, 3) as exp([w]) v: turned about w (m, 3) by |w| radians."""
    v, axis = _columns(rows), np.ascontiguousarray(w.T)[:, None, :]
    angle = np.sqrt((axis**2).sum(axis=0))
    once = cross(axis, v)
    twice = cross(axis, once)
    v += np.sinc(angle / np.pi) * once + 0.5 * np.sinc(0.5 * angle / np.pi) ** 2 * twice
    return v.transpose(2, 1, 0)


def torques(rows: FloatArray, pull: FloatArray) -> FloatArray:
    """(m, 3) the sum over rows of row x pull: d/dw of <pull, turned(rows, w)> at w = 0."""
    return np.ascontiguousarray(cross(_columns(rows), _columns(pull)).sum(axis=1).T)


def _columns(rows: FloatArray) -> FloatArray:
    """(3, 3, m): coordinates first, then rows, for arithmetic on whole columns."""
    return np.array(rows.transpose(2, 1, 0), order="C")
