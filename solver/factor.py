"""Sparse Cholesky factorisation behind one small interface.

CHOLMOD (through cvxopt) where it is installed, SciPy's SuperLU where it is not.
An Analysis is made once for a pattern of entries, a Factor for each set of values.
"""

from __future__ import annotations

import threading
import weakref
from typing import Any, Protocol

import numpy as np
import scipy.sparse as sp
from scipy.sparse.linalg import splu

from solver.errors import FactorizationError
from solver.types import FloatArray, IntArray

try:
    import cvxopt
    import cvxopt.amd as amd
    import cvxopt.cholmod as cholmod
except ImportError:  # an optional dependency: its licence or platform may not suit everybody
    cholmod = None


class Factor(Protocol):
    """A factorised symmetric positive definite matrix A."""

    def solve(self, B: FloatArray) -> FloatArray:
        """A^-1 B for B (n, k)."""
        ...


class Analysis(Protocol):
    """What depends on the places of A's entries alone: a fill-reducing order and the fill."""

    def factor(self, values: FloatArray) -> Factor:
        """Factorise A with these values at the places analysed; FactorizationError."""
        ...


def analyse(
    rows: IntArray, columns: IntArray, size: int, order: IntArray | None, backend: str | None = None
) -> Analysis:
    """Analyse a symmetric matrix (size, size) given the places of its lower triangle.

    A place may occur several times: values there add up.
    order: (size,) a fill-reducing permutation, None to have one found.
    backend: "cholmod" or "splu"; None takes the best installed.
    """
    if size == 0:
        return _Nothing()
    if backend is None:
        backend = "cholmod" if cholmod is not None else "splu"
    if backend == "cholmod":
        return _Cholmod(rows, columns, size, order)
    return _SuperLU(rows, columns, size, order)


def factorize(A: sp.sparray, order: IntArray | None = None, backend: str | None = None) -> Factor:
    """Factor the symmetric positive definite A (n, n) once, to solve often.

    Raises FactorizationError where A is not positive definite.
    """
    lower = sp.coo_array(sp.tril(A))
    rows, columns = (np.asarray(index, dtype=np.int64) for index in lower.coords)
    return analyse(rows, columns, A.shape[0], order, backend).factor(lower.data)


def minimum_degree(rows: IntArray, columns: IntArray, size: int) -> IntArray | None:
    """A fill-reducing order of a graph, given as the lower triangle of its matrix.

    None without CHOLMOD, as SuperLU finds its own. [Amestoy, Davis & Duff 1996]
    """
    if cholmod is None:
        return None
    graph = _spmatrix(np.ones(len(rows)), rows, columns, size)
    return np.array(amd.order(graph), dtype=np.int64).ravel()


class _Nothing:
    """The analysis, and the factor, of a system without unknowns."""

    def factor(self, values: FloatArray) -> _Nothing:
        return self

    def solve(self, B: FloatArray) -> FloatArray:
        return np.zeros_like(B)


class _Cholmod:
    """CHOLMOD's factor object holds analysis and numbers in one and cannot be copied.

    All factors of one analysis share it, each with values of its own: the one that solves while
    the numbers are another's computes its own again. So a chain of rebinds, where the newest is
    the one in use, pays for memory and analysis once.
    """

    def __init__(
        self, rows: IntArray, columns: IntArray, size: int, order: IntArray | None
    ) -> None:
        places = np.arange(1.0, len(rows) + 1.0)
        self._matrix = _spmatrix(places, rows, columns, size)
        # Values stand column by column in CHOLMOD's matrix, which tells where each came to,
        # except where places occur twice: their sums stand there, and are found again here.
        self._twice = len(self._matrix) < len(rows)
        if self._twice:
            self._slot = np.unique(columns * size + rows, return_inverse=True)[1]
        else:
            self._source = np.array(self._matrix.V, dtype=np.int64).ravel() - 1
        self.shared = _symbolic(self._matrix, order)
        self.lock = threading.Lock()
        # Weak: a factor holds its analysis, and a circle would keep both until Python looks for it.
        self._owner: weakref.ref[_CholmodFactor] | None = None
        self._size = size

    def factor(self, values: FloatArray) -> _CholmodFactor:
        stored = self._summed(values) if self._twice else values[self._source]
        factor = _CholmodFactor(self, stored)
        with self.lock:
            self.load(factor)
        return factor

    def _summed(self, values: FloatArray) -> FloatArray:
        return np.bincount(self._slot, values).astype(np.float64)

    def load(self, factor: _CholmodFactor) -> None:
        """Make the numbers those of `factor`; to be called with the lock held."""
        if self._owner is not None and self._owner() is factor:
            return
        self._owner = None
        self._matrix.V = cvxopt.matrix(factor.values)
        try:
            cholmod.numeric(self._matrix, self.shared)
        except ArithmeticError as failure:
            raise FactorizationError(
                f"the {self._size} x {self._size} system is not positive definite "
                f"(column {failure})"
            ) from failure
        self._owner = weakref.ref(factor)


class _CholmodFactor:
    def __init__(self, analysis: _Cholmod, values: FloatArray) -> None:
        self._analysis = analysis
        self.values = values

    def solve(self, B: FloatArray) -> FloatArray:
        analysis = self._analysis
        with analysis.lock:
            analysis.load(self)
            # cvxopt has CHOLMOD read its factor once for each dense column, but only once for
            # four sparse ones.
            X = cholmod.spsolve(analysis.shared, cvxopt.sparse(cvxopt.matrix(B)))
        return np.array(cvxopt.matrix(X))


def _symbolic(matrix: Any, order: IntArray | None) -> Any:
    if order is None:
        return cholmod.symbolic(matrix)
    # Unless told to try one order alone, CHOLMOD looks for others all the same.
    before = dict(cholmod.options)
    cholmod.options["nmethods"] = 1
    try:
        return cholmod.symbolic(matrix, p=cvxopt.matrix(order))
    finally:
        cholmod.options.clear()
        cholmod.options.update(before)


def _spmatrix(values: FloatArray, rows: IntArray, columns: IntArray, size: int) -> Any:
    return cvxopt.spmatrix(
        cvxopt.matrix(values), cvxopt.matrix(rows), cvxopt.matrix(columns), (size, size)
    )


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
