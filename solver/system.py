"""The factorised system of one bind: K restricted to the rows that can move."""

from __future__ import annotations

from functools import cached_property

import numpy as np
import scipy.sparse as sp

from solver.constraints import Constraints
from solver.factor import Factor, factorize
from solver.types import FloatArray, IntArray


class System:
    """K, its free rows, and their factor.

    permutation: the fill-reducing order of an earlier system with the same free rows.
    """

    def __init__(
        self, K: sp.csc_array, constraints: Constraints, permutation: IntArray | None = None
    ) -> None:
        self.K = K
        self.free = constraints.free
        self._free_rows = K.tocsr()[self.free]
        self.factor: Factor = factorize(
            sp.csc_array(self._free_rows[:, self.free]), permutation=permutation
        )

    def respond(self, U: FloatArray) -> FloatArray:
        """U (n + 3m, k) with its free rows moved to where they minimise the energy."""
        U = U.copy()
        U[self.free] = 0.0
        U[self.free] = -self.factor.solve(self._free_rows @ U)
        return U

    @cached_property
    def stiffness(self) -> float:
        """The largest entry of K: the unit in which an energy counts as zero."""
        return float(np.abs(self.K.data).max(initial=0.0))
