"""The energy that rounds lower: a shell whose triangles carry rotations."""

from __future__ import annotations

from functools import cached_property

import numpy as np
import scipy.sparse as sp

from solver.factor import Factor, factorize
from solver.geometry.rotations import torques
from solver.rigid.lbfgs import inner
from solver.types import FloatArray, IntArray

# l_r, in bounding-box diagonals: how thick a shell the surface is taken for. Thinner shells fold
# flat, thicker ones stretch; docs/quality.md has the measurements.
ROTATION_LENGTH = 0.075
# Of a triangle's own stiffness against turning, the part that remains where positions follow.
REMAINING = 0.5


class SmoothRotationEnergy:
    """The energy K stands for, with rotations for frames and l_r for the bending length:

        E(X, R) = 1/2 sum w_eT  sigma_e ||x_b - x_a - R_T (p_b - p_a)||^2
          + l_r^2 / 2 sum w_e^-1 beta_e ||R_j - R_i||^2  =  1/2 tr U' M U

    with U the rows of X (n, 3), then those of each R': three rows a triangle, as in K.
    """

    def __init__(self, K: sp.csr_array, n: int, turning: IntArray, ratio: float) -> None:
        """K: positions, then frames. turning: numbers of the triangles that are free to turn.

        ratio: of the bending terms with l_r for the bending length to those in K.
        """
        self._n = n
        self._turning = turning
        stiffness = K.diagonal()[n:].reshape(-1, 3).sum(axis=1)
        links = sp.coo_array(K[n::3][:, n::3])
        i, j = links.coords
        weights, i, j = -links.data[i != j], i[i != j], j[i != j]
        degree = np.bincount(i, weights, len(stiffness))
        self._own = np.maximum(stiffness - 3.0 * degree, 0.0)  # rounding may go below
        size = (len(degree), len(degree))
        bending = sp.diags_array(degree) - sp.coo_array((weights, (i, j)), shape=size)
        self._bending = sp.csr_array(ratio * bending)
        extra = sp.kron((ratio - 1.0) * bending, sp.eye_array(3))
        self._M = sp.csr_array(K + sp.block_diag((sp.csr_array((n, n)), extra)))

    def measure(self, X: FloatArray, R: FloatArray) -> tuple[float, FloatArray]:
        """E, and its gradient (turning, 3) by small turns of the triangles that can turn.

        X minimises E for these R, so that only R's own gradient counts.
        """
        U = np.vstack([X, R.reshape(-1, 3)])
        G = self._M @ U
        pull = G[self._n :].reshape(-1, 3, 3)[self._turning]
        return 0.5 * inner(U, G), torques(R[self._turning], pull)

    @cached_property
    def hessian(self) -> Factor:
        """W, about the second derivative of E by small turns in world axes, positions following.

        Turns compare across an edge in world axes whatever the rotations are, so that this holds
        for the bending of any pose; it is factorised once.
        """
        own = sp.diags_array(REMAINING * self._own)
        return factorize(sp.csr_array(own + 2.0 * self._bending)[self._turning][:, self._turning])
