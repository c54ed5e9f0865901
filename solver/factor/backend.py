"""What a sparse Cholesky factorisation has to offer, whichever library does it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol

from solver.types import FloatArray, IntArray


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


@dataclass(frozen=True)
class Backend:
    """One library, by the name that `analyse` knows it by.

    analyse: of (rows, columns, size, order), see `solver.factor.analyse`.
    minimum_degree: of (rows, columns, size), a fill-reducing order of a graph given as the lower
        triangle of its matrix; None where the library finds orders only by itself.
    """

    name: str
    analyse: Callable[[IntArray, IntArray, int, IntArray | None], Analysis]
    minimum_degree: Callable[[IntArray, IntArray, int], IntArray] | None = None
