"""Sparse Cholesky factorisation behind one small interface.

An Analysis is made once for a pattern of entries, a Factor for each set of values. table.py lists
the libraries that can do it.
"""

from solver.factor.accuracy import check_factor
from solver.factor.backend import Analysis, Factor
from solver.factor.table import BACKENDS, analyse, factorize, minimum_degree

__all__ = [
    "BACKENDS",
    "Analysis",
    "Factor",
    "analyse",
    "check_factor",
    "factorize",
    "minimum_degree",
]
