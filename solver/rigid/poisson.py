"""Positions from rotations: one Poisson problem, the global step of ARAP. [Sorkine & Alexa 2007]"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import scipy.sparse as sp

from solver.factor import factorize
from solver.linear.grab import Grab, Moments
from solver.types import FloatArray, IntArray


class PoissonProblem:
    """Free positions that suit given rotations:

        argmin_X 1/2 sum w_eT sigma_e ||x_b - x_a - R_T (p_b - p_a)||^2

    with held vertices at their targets and the moments of soft handles met. Its matrix is the
    vertex block of K, its right-hand side the vertex-frame block: no second assembly.
    """

    def __init__(self, K: sp.csr_array, free: IntArray, grabs: Sequence[Grab]) -> None:
        """K: of n positions and three rows a triangle.  free: the vertices to solve for."""
        self._free = free
        self._rows = K[free]
        self._factor = factorize(self._rows[:, free])
        C = np.hstack([np.empty((len(free), 0)), *(g.moments[: len(free)] for g in grabs)])
        self._conditions = Moments(C, self._factor.solve(C))

    def moments(self, X: FloatArray) -> FloatArray:
        """The moments of positions X (n, 3), which `positions` is to keep."""
        return self._conditions.of(X[self._free])

    def positions(self, X: FloatArray, R: FloatArray, moments: FloatArray) -> FloatArray:
        """X (n, 3) with its free vertices where they suit R, (a, 3, 3) rows of each R'."""
        X = X.copy()
        X[self._free] = 0.0
        rows = np.vstack([X, R.reshape(-1, 3)])
        X[self._free] = self._conditions.meet(-self._factor.solve(self._rows @ rows), moments)
        return X

    def answer(self, forces: FloatArray) -> FloatArray:
        """(n, 3) how positions give way to forces (n, 3) on them; moments of grabs stay."""
        X = np.zeros_like(forces)
        given = self._factor.solve(forces[self._free])
        X[self._free] = self._conditions.meet(given, np.zeros_like(self._conditions.of(given)))
        return X
