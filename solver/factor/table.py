"""The libraries that factorise, best first, and the functions that use them."""

from __future__ import annotations

import numpy as np
import scipy.sparse as sp

from solver.factor import cholmod, rslab, superlu
from solver.factor.backend import Analysis, Backend, Factor
from solver.types import FloatArray, IntArray

# CHOLMOD keeps one order a mesh, RSLAB finds one a bind; SuperLU is slow, but comes with SciPy.
BACKENDS: tuple[Backend, ...] = tuple(
    backend for backend in (cholmod.BACKEND, rslab.BACKEND, superlu.BACKEND) if backend
)


def analyse(
    rows: IntArray, columns: IntArray, size: int, order: IntArray | None, backend: str | None = None
) -> Analysis:
    """Analyse a symmetric matrix (size, size) given the places of its lower triangle.

    A place may occur several times: values there add up.
    order: (size,) a fill-reducing permutation, None to have one found.
    backend: the name of one of BACKENDS; None takes the first.
    """
    if size == 0:
        return _Nothing()
    chosen = next(b for b in BACKENDS if backend in (None, b.name))
    return chosen.analyse(rows, columns, size, order)


def factorize(A: sp.sparray, order: IntArray | None = None, backend: str | None = None) -> Factor:
    """Factor the symmetric positive definite A (n, n) once, to solve often.

    Raises FactorizationError where A is not positive definite.
    """
    lower = sp.coo_array(sp.tril(A))
    rows, columns = (np.asarray(index, dtype=np.int64) for index in lower.coords)
    return analyse(rows, columns, A.shape[0], order, backend).factor(lower.data)


def minimum_degree(rows: IntArray, columns: IntArray, size: int) -> IntArray | None:
    """A fill-reducing order of a graph, given as the lower triangle of its matrix.

    None where the library in use finds its own. [Amestoy, Davis & Duff 1996]
    """
    find = BACKENDS[0].minimum_degree
    return find(rows, columns, size) if find else None


class _Nothing:
    """The analysis, and the factor, of a system without unknowns."""

    def factor(self, values: FloatArray) -> _Nothing:
        return self

    def solve(self, B: FloatArray) -> FloatArray:
        return np.zeros_like(B)
