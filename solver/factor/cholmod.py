"""CHOLMOD, through cvxopt or its fork kvxopt: an optional dependency.

[Chen, Davis, Hager & Rajamanickam 2008]
"""

from __future__ import annotations

import threading
import weakref
from typing import Any

import numpy as np

from solver.errors import FactorizationError
from solver.factor.backend import Backend
from solver.types import FloatArray, IntArray

try:
    import cvxopt
    from cvxopt import amd, cholmod
except ImportError:  # its licence or platform may not suit everybody
    try:  # the fork has wheels for systems where cvxopt has none
        import kvxopt as cvxopt
        from kvxopt import amd, cholmod
    except ImportError:
        cholmod = None


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
            _numeric(self._matrix, self.shared)
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


def _numeric(matrix: Any, factor: Any) -> None:
    """Raises ArithmeticError, with the column that fails, where there is no Cholesky factor."""
    cholmod.numeric(matrix, factor)
    try:
        cholmod.diag(factor)
    except ValueError as failure:  # kvxopt's numeric is silent about it
        raise ArithmeticError("unknown") from failure


def _spmatrix(values: FloatArray, rows: IntArray, columns: IntArray, size: int) -> Any:
    return cvxopt.spmatrix(
        cvxopt.matrix(values), cvxopt.matrix(rows), cvxopt.matrix(columns), (size, size)
    )


def _minimum_degree(rows: IntArray, columns: IntArray, size: int) -> IntArray:
    graph = _spmatrix(np.ones(len(rows)), rows, columns, size)
    return np.array(amd.order(graph), dtype=np.int64).ravel()


BACKEND = None if cholmod is None else Backend("cholmod", _Cholmod, _minimum_degree)
