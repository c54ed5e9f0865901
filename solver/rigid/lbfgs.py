"""Limited-memory BFGS: descent that learns the curvature as it goes. [Nocedal 1980]"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable

import numpy as np

from solver.types import FloatArray

REMEMBERED = 5


def inner(a: FloatArray, b: FloatArray) -> float:
    """The sum of a * b, for (m, 3) each."""
    # Not np.vdot: threads of BLAS wait for each other longer than so short a sum takes.
    return float(np.einsum("ij,ij->", a, b))


class LBFGS:
    """Limited-memory BFGS on top of a fixed estimate of the inverse Hessian. [Nocedal 1980]"""

    def __init__(self, inverse: Callable[[FloatArray], FloatArray]) -> None:
        self._inverse = inverse
        self._pairs: deque[tuple[FloatArray, FloatArray, float]] = deque(maxlen=REMEMBERED)

    def direction(self, gradient: FloatArray) -> FloatArray:
        """A step downhill: minus the gradient through the estimated inverse Hessian."""
        q, taken = gradient, []
        for step, change, product in reversed(self._pairs):
            share = inner(step, q) / product
            taken.append(share)
            q = q - share * change
        z = self._inverse(q)
        for (step, change, product), share in zip(self._pairs, reversed(taken), strict=True):
            z = z + (share - inner(change, z) / product) * step
        return -z

    def learn(self, step: FloatArray, change: FloatArray) -> None:
        """`step` has changed the gradient by `change`; what curves downward is not kept."""
        product = inner(step, change)
        if product > 1e-9 * (inner(step, step) * inner(change, change)) ** 0.5:
            self._pairs.append((step, change, product))
