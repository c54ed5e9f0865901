"""The energy written out term by term from its definition, to hold the solver against.

    E = l^2/2 sum w_e^-1 beta_e  ||G_j - G_i||^2
        + 1/2 sum w_eT   sigma_e ||x_b - x_a - G_T (p_b - p_a)||^2

    w_e >= 2 / (sum of all six cotangents of the two triangles)

Plain loops, angles from coordinates, nothing of the solver's own.
"""

from __future__ import annotations

from collections import defaultdict
from itertools import combinations

import numpy as np
import scipy.sparse as sp

from solver.types import FloatArray, IntArray

Gains = dict[tuple[int, int], tuple[float, float]]
REGULAR = 3**-0.5


class Definition:
    """E of (V, F) with the bending length in the units of V and gains {(a, b): (beta, sigma)}."""

    def __init__(
        self, V: FloatArray, F: IntArray, bending_length: float, gains: Gains | None = None
    ) -> None:
        self.n, self.m = len(V), len(F)
        self._rows: list[tuple[list[int], list[float]]] = []
        self._weights: list[float] = []
        gains = gains or {}
        sides: dict[tuple[int, int], list[tuple[int, float]]] = defaultdict(list)
        total = [sum_of_cotangents(*V[f]) for f in F]
        for t, (i, j, k) in enumerate(F.tolist()):
            for a, b, c in ((i, j, k), (j, k, i), (k, i, j)):
                cot = cotangent(V[a] - V[c], V[b] - V[c])
                edge = (min(a, b), max(a, b))
                sides[edge].append((t, cot))
                self._stretch(V, t, a, b, clamp(cot) * gains.get(edge, (1.0, 1.0))[1])
        for edge, around in sides.items():
            for (t, cot_t), (u, cot_u) in combinations(around, 2):
                w = clamp(max((cot_t + cot_u) / 2, 2 / (total[t] + total[u]))) * (len(around) - 1)
                self._bend(t, u, bending_length**2 / w * gains.get(edge, (1.0, 1.0))[0])
        rows = np.repeat(np.arange(len(self._rows)), [len(r[0]) for r in self._rows])
        columns = [column for row in self._rows for column in row[0]]
        values = [value for row in self._rows for value in row[1]]
        shape = (len(self._rows), self.n + 3 * self.m)
        self.D = sp.csr_array(sp.coo_array((values, (rows, columns)), shape=shape))
        self.w = np.array(self._weights)

    def _stretch(self, V: FloatArray, t: int, a: int, b: int, weight: float) -> None:
        frame = [self.n + 3 * t + axis for axis in range(3)]
        self._rows.append(([b, a, *frame], [1.0, -1.0, *(V[a] - V[b]).tolist()]))
        self._weights.append(weight)

    def _bend(self, t: int, u: int, weight: float) -> None:
        for axis in range(3):
            columns = [self.n + 3 * t + axis, self.n + 3 * u + axis]
            self._rows.append((columns, [-1.0, 1.0]))
            self._weights.append(weight)

    def energy(self, U: FloatArray) -> float:
        """E of U (n + 3m, 3), see `stack`."""
        return float(0.5 * (self.w[:, None] * (self.D @ U) ** 2).sum())

    def slope(self, U: FloatArray, direction: FloatArray) -> float:
        """dE along `direction` by central differences, exact for a quadratic E."""
        return 0.5 * (self.energy(U + direction) - self.energy(U - direction))


def stack(X: FloatArray, G: FloatArray) -> FloatArray:
    """U (n + 3m, 3): positions, then the columns of every G as rows."""
    return np.vstack([X, G.transpose(0, 2, 1).reshape(-1, 3)])


def cotangent(u: FloatArray, v: FloatArray) -> float:
    area = float(np.linalg.norm(np.cross(u, v)))
    return float(u @ v) / area


def resolved(V: FloatArray, F: IntArray, bending_length: float = 0.01) -> float:
    """l in the units of V: in diagonals as given, at least the edge of a typical triangle."""
    squares = [sum(float(e @ e) for e in V[f] - V[np.roll(f, 1)]) / 3 for f in F]
    diagonal = np.linalg.norm(np.ptp(V, axis=0))
    return float(max(bending_length * diagonal, np.sqrt(np.median(squares))))


def sum_of_cotangents(a: FloatArray, b: FloatArray, c: FloatArray) -> float:
    return cotangent(b - a, c - a) + cotangent(c - b, a - b) + cotangent(a - c, b - c)


def clamp(weight: float) -> float:
    return min(max(weight, 1e-3 * REGULAR), 1e3 * REGULAR)
