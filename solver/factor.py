"""Sparse Cholesky factorisation behind one small interface.

CHOLMOD (through cvxopt) where it is installed, SciPy's SuperLU where it is not.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol

import numpy as np
import scipy.sparse as sp
from scipy.sparse.linalg import splu

from solver.errors import FactorizationError
from solver.types import FloatArray, IntArray

try:
    import cvxopt
    import cvxopt.cholmod as cholmod
except ImportError:  # an optional dependency: its licence or platform may not suit everybody
    cholmod = None


class Factor(Protocol):
    """A factorised symmetric positive definite matrix A."""

    permutation: IntArray
    """(n,) the fill-reducing order used; pass it on to factorise another A of the same pattern."""

    def solve(self, B: FloatArray) -> FloatArray:
        """A^-1 B for B (n, k)."""
        ...


def factorize(
    A: sp.csc_array, permutation: IntArray | None = None, backend: str | None = None
) -> Factor:
    """Factor the symmetric positive definite A (n, n) once, to solve often.

    permutation: an order from an earlier factor of the same pattern, which saves finding one.
    backend: "cholmod" or "splu"; None takes the best installed.
    Raises FactorizationError where A is not positive definite.
    """
    if A.shape[0] == 0:
        return _Empty()
    if backend is None:
        backend = "cholmod" if cholmod is not None else "splu"
    return BACKENDS[backend](A, permutation)


class _Empty:
    """The factor of a system without unknowns."""

    permutation = np.empty(0, dtype=np.int64)

    def solve(self, B: FloatArray) -> FloatArray:
        return np.zeros_like(B)


class _Cholmod:
    # CHOLMOD's code for "apply the permutation".
    PERMUTE = 7

    def __init__(self, A: sp.csc_array, permutation: IntArray | None) -> None:
        n = A.shape[0]
        lower = sp.tril(A, format="coo")
        matrix = cvxopt.spmatrix(
            cvxopt.matrix(lower.data),
            cvxopt.matrix(lower.row.astype(np.int64)),
            cvxopt.matrix(lower.col.astype(np.int64)),
            (n, n),
        )
        given = {} if permutation is None else {"p": cvxopt.matrix(permutation.astype(np.int64))}
        self._factor = cholmod.symbolic(matrix, **given)
        try:
            cholmod.numeric(matrix, self._factor)
        except ArithmeticError as failure:
            raise FactorizationError(
                f"the {n} x {n} system is not positive definite (column {failure})"
            ) from failure
        count = cvxopt.matrix(np.arange(n, dtype=np.float64))
        cholmod.solve(self._factor, count, sys=self.PERMUTE)
        self.permutation = np.array(count, dtype=np.int64).ravel()

    def solve(self, B: FloatArray) -> FloatArray:
        X = cvxopt.matrix(B)
        cholmod.solve(self._factor, X)
        return np.array(X)


class _SuperLU:
    def __init__(self, A: sp.csc_array, permutation: IntArray | None) -> None:
        A = sp.csc_array(A)
        self._order = permutation
        if permutation is not None:
            A = A[permutation][:, permutation]
        method = "MMD_AT_PLUS_A" if permutation is None else "NATURAL"
        try:
            # Symmetric mode with diagonal pivots is SuperLU's way to be a Cholesky factorisation.
            self._lu = splu(
                A, permc_spec=method, diag_pivot_thresh=0.0, options={"SymmetricMode": True}
            )
        except RuntimeError as failure:
            n = A.shape[0]
            raise FactorizationError(f"the {n} x {n} system is singular ({failure})") from failure
        if permutation is None:
            self.permutation = np.argsort(self._lu.perm_c).astype(np.int64)
        else:
            self.permutation = permutation

    def solve(self, B: FloatArray) -> FloatArray:
        if self._order is None:
            return np.asarray(self._lu.solve(np.ascontiguousarray(B)))
        X = np.empty_like(B)
        X[self._order] = self._lu.solve(np.ascontiguousarray(B[self._order]))
        return X


BACKENDS: dict[str, Callable[[sp.csc_array, IntArray | None], Factor]] = {
    "cholmod": _Cholmod,
    "splu": _SuperLU,
}
