"""The energy that the levels lower: ARAP with smooth rotations. [Levi & Gotsman 2015]"""

from __future__ import annotations

from functools import cached_property

import numpy as np
import scipy.sparse as sp

from solver.factor import Factor, factorize
from solver.geometry.rotations import torques
from solver.linear.system import System
from solver.rigid.lbfgs import inner
from solver.types import FloatArray, IntArray

# l_r, in bounding-box diagonals: how far rotations are smoothed. With a shorter one surfaces fold
# flat, with a longer one they stretch; docs/quality.md has the measurements.
ROTATION_LENGTH = 0.075
# Of a triangle's own stiffness against turning, the part that remains where positions follow.
REMAINING = 0.5
# The same part where turns spread: nearly nothing, but enough where no held triangle is linked.
SPREADING = 1e-6


class SmoothRotationEnergy:
    """The energy K stands for, with rotations for frames and l_r for the bending length:

        E(X, R) = 1/2 sum w_eT  sigma_e ||x_b - x_a - R_T (p_b - p_a)||^2
          + l_r^2 / 2 sum w_e^-1 beta_e ||R_j - R_i||^2  =  1/2 tr U' M U

    with U the rows of X (n, 3), then those of each R': three rows for each active triangle.

    vertex_count: n.  count: of active triangles, a.
    """

    def __init__(self, system: System, K: sp.csr_array, turning: IntArray, ratio: float) -> None:
        """K: of all positions and the frames of the system's active triangles.

        turning: those of the active triangles, by number, that are free to turn.
        ratio: of the bending terms with l_r for the bending length to those in K.
        """
        self._turning = turning
        self._own = system.stretching
        count = len(system.active)
        self.count, self.vertex_count = count, K.shape[0] - 3 * count
        links, weights = system.bending
        (i, j), size = links.T, (count, count)
        degree = np.bincount(links.ravel(), np.repeat(weights, 2), count)
        joined = sp.coo_array((weights, (i, j)), shape=size)
        bending = sp.diags_array(degree) - joined - joined.T
        self._bending = sp.csr_array(ratio * bending)
        extra = sp.kron((ratio - 1.0) * bending, sp.eye_array(3))
        none = sp.csr_array((self.vertex_count, self.vertex_count))
        self._M = sp.csr_array(K + sp.block_diag((none, extra)))

    def measure(self, X: FloatArray, R: FloatArray) -> tuple[float, FloatArray]:
        """E, and its gradient (turning, 3) by small turns of the triangles that can turn.

        X minimises E for these R, so that only R's own gradient counts.
        """
        U = np.vstack([X, R.reshape(-1, 3)])
        G = self._M @ U
        pull = G[self.vertex_count :].reshape(-1, 3, 3)[self._turning]
        return 0.5 * inner(U, G), torques(R[self._turning], pull)

    def slope(self, X: FloatArray, R: FloatArray) -> FloatArray:
        """M U, (n + 3a, 3): the slope of E by positions and by the rows of each R'."""
        return np.asarray(self._M @ np.vstack([X, R.reshape(-1, 3)]))

    @cached_property
    def hessian(self) -> Factor:
        """W, about the second derivative of E by small turns in world axes, positions following.

        Turns compare across an edge in world axes whatever the rotations are, so that this holds
        for the bending of any pose; it is factorised once.
        """
        own = sp.diags_array(REMAINING * self._own)
        return factorize(sp.csr_array(own + 2.0 * self._bending)[self._turning][:, self._turning])

    @cached_property
    def held(self) -> IntArray:
        """Those of the active triangles, by number, that are not free to turn."""
        return np.setdiff1d(np.arange(self.count), self._turning)

    @cached_property
    def _spread(self) -> tuple[Factor, sp.csr_array]:
        own = sp.diags_array(SPREADING * self._own)
        rows = sp.csr_array(own + 2.0 * self._bending)[self._turning]
        return factorize(sp.csr_array(rows[:, self._turning])), rows[:, self.held]

    def spread(self, turns: FloatArray) -> FloatArray:
        """Small turns (turning, 3) that are harmonic between those of the held ones (held, 3).

        argmin 1/2 sum w_e^-1 beta_e ||w_j - w_i||^2: about how everything turns with what holds it.
        """
        factor, links = self._spread
        return -factor.solve(links @ turns)
