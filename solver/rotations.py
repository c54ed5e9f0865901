"""Nearest rotations, and the Poisson problem that turns rotations into positions."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import scipy.sparse as sp

from solver.constraints import Constraints
from solver.factor import factorize
from solver.shape import RestShape
from solver.soft import Moments, SoftHandle
from solver.system import System
from solver.types import FloatArray, IntArray

NEWTON_STEPS = 12
# Where the best and the second best rotation come this close, the quartic's largest root is nearly
# multiple: Newton's steps, slow there, stop short of it.
AMBIGUOUS = 1e-2
# l_r, the weight of neighbouring rotations in a round, in bounding-box diagonals.
ROTATION_LENGTH = 3e-4


def nearest_rotations(A: FloatArray) -> FloatArray:
    """R, (m, 3, 3): argmin over SO(3) of ||R - A||, for A (m, 3, 3), reflections included.

    lambda = max tr(R'A) is the largest root of the quartic of Horn's quaternion matrix,
    (lambda^2 - s)^2 - 8 d lambda - 4 t with s = ||A||^2, d = det A, t = ||cof A||^2, and R is
    its gradient in A. [Horn 1987; Higham & Noferini 2016]
    """
    a = np.ascontiguousarray(np.moveaxis(A, 0, -1))  # (3, 3, m): arithmetic on whole columns
    cof = np.stack([_cross(a[1], a[2]), _cross(a[2], a[0]), _cross(a[0], a[1])])
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


def _cross(u: FloatArray, v: FloatArray) -> FloatArray:
    return np.stack(
        [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
    )


def _nearest_by_svd(A: FloatArray) -> FloatArray:
    U, _, Vt = np.linalg.svd(A)
    U[:, :, 2] *= np.sign(np.linalg.det(U) * np.linalg.det(Vt))[:, None]
    R: FloatArray = U @ Vt
    return R


class Rigidity:
    """Positions from rotations, and rounds of both.

        argmin_X 1/2 sum w_eT sigma_e ||x_b - x_a - R_T (p_b - p_a)||^2

    with held vertices at their targets and the moments of soft handles met. Its matrix is the
    vertex block of K, its right-hand side the vertex-frame block: no second assembly.
    """

    def __init__(
        self,
        shape: RestShape,
        constraints: Constraints,
        system: System,
        grabs: Sequence[SoftHandle],
        bending_length: float,
    ) -> None:
        n = len(shape.vertices)
        K = system.matrix()
        self._n = n
        self._free = constraints.free[constraints.free < n]
        # Rotations are wanted where they matter: on triangles that something can strain.
        active = system.active
        self._frames = (n + 3 * active[:, None] + np.arange(3)).ravel()
        rows = K[self._free]
        self._factor = factorize(rows[:, self._free])
        self._rows = sp.csr_array(sp.hstack([rows[:, :n], rows[:, self._frames]]))
        # Held, carried and resting frames are right already: a round leaves them alone.
        turning = constraints.free[constraints.free >= n]
        self._turning = np.searchsorted(active, (turning[::3] - n) // 3)
        self._local = -K[turning][:, :n]
        self._neighbours = _neighbour_weights(
            K[turning[::3]][:, self._frames[::3]], self._turning, bending_length
        )
        C = np.hstack(
            [np.empty((len(self._free), 0)), *(g.moments[: len(self._free)] for g in grabs)]
        )
        self._moments = Moments(C, self._factor.solve(C))

    def refine(self, U: FloatArray, rounds: int) -> FloatArray:
        """Rows U (n + 3m, 3) of the linear result become positions (n, 3).

        One round takes the nearest rotation of every frame and solves for positions; each
        further round fits the rotations to those positions first.
        """
        n = self._n
        moments = self._moments.of(U[self._free])
        R = nearest_rotations(U[self._frames].reshape(-1, 3, 3))
        X = self._positions(U[:n], R, moments)
        for _ in range(rounds - 1):
            fit = (self._local @ X).reshape(-1, 3, 3)
            fit += (self._neighbours @ R.reshape(-1, 9)).reshape(-1, 3, 3)
            R[self._turning] = nearest_rotations(fit)
            X = self._positions(X, R, moments)
        return X

    def _positions(self, X: FloatArray, R: FloatArray, moments: FloatArray) -> FloatArray:
        X = X.copy()
        X[self._free] = 0.0
        rows = np.vstack([X, R.reshape(-1, 3)])
        X[self._free] = self._moments.meet(-self._factor.solve(self._rows @ rows), moments)
        return X


def _neighbour_weights(
    frame_rows: sp.csr_array, own: IntArray, bending_length: float
) -> sp.csr_array:
    """l_r^2 w_e^-1 beta_e between some triangles and their neighbours.

    frame_rows: one axis of the frames in K.  own: the column of each row's own triangle.
    """
    across = sp.coo_array(frame_rows)
    row, column = across.coords
    across.data[own[row] == column] = 0.0
    return sp.csr_array(across * -((ROTATION_LENGTH / bending_length) ** 2))
