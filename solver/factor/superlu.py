"""SuperLU, through SciPy: always there, but only singular matrices are refused. [Li 2005]"""

from __future__ import annotations

import numpy as np
import scipy.sparse as sp
from scipy.sparse.linalg import splu

from solver.errors import FactorizationError
from solver.factor.backend import Backend
from solver.types import FloatArray, IntArray


class _SuperLU:
    def __init__(
        self, rows: IntArray, columns: IntArray, size: int, order: IntArray | None
    ) -> None:
        self._rows, self._columns, self._size, self._order = rows, columns, size, order

    def factor(self, values: FloatArray) -> _SuperLUFactor:
        shape = (self._size, self._size)
        lower = sp.csc_array(sp.coo_array((values, (self._rows, self._columns)), shape=shape))
        A = sp.csc_array(lower + sp.tril(lower, -1).T)
        factor = _SuperLUFactor(A, self._order)
        if self._order is None:
            self._order = factor.order
        return factor


class _SuperLUFactor:
    def __init__(self, A: sp.csc_array, order: IntArray | None) -> None:
        given = order is not None
        if given:
            A = A[order][:, order]
        try:
            # Symmetric mode with diagonal pivots is SuperLU's way to be a Cholesky factorisation.
            self._lu = splu(
                A,
                permc_spec="NATURAL" if given else "MMD_AT_PLUS_A",
                diag_pivot_thresh=0.0,
                options={"SymmetricMode": True},
            )
        except RuntimeError as failure:
            n = A.shape[0]
            raise FactorizationError(f"the {n} x {n} system is singular ({failure})") from failure
        self._permuted = given
        self.order = order if given else np.argsort(self._lu.perm_c)

    def solve(self, B: FloatArray) -> FloatArray:
        if not self._permuted:
            return np.asarray(self._lu.solve(np.ascontiguousarray(B)))
        X = np.empty_like(B)
        X[self.order] = self._lu.solve(np.ascontiguousarray(B[self.order]))
        return X


BACKEND = Backend("splu", _SuperLU)
