"""The rigid levels against a plain version of themselves: loops, dense matrices, the SVD."""

from __future__ import annotations

import numpy as np
import pytest

from solver import Deformer
from solver.types import FloatArray, IntArray
from tests.solver import shapes
from tests.solver.definition import clamp, cotangent
from tests.solver.shapes import motion, rotation

ROTATION_LENGTH = 3e-4
V, F = shapes.bumpy_plane(7)


def nearest(A: FloatArray) -> FloatArray:
    U, _, Vt = np.linalg.svd(A)
    return np.asarray(U @ np.diag([1, 1, np.sign(np.linalg.det(U @ Vt))]) @ Vt)


def half_edges() -> list[tuple[int, int, int, float]]:
    """(triangle, a, b, cotangent) of every half-edge."""
    corners = [(t, f[i - 2], f[i - 1], f[i]) for t, f in enumerate(F.tolist()) for i in range(3)]
    return [(t, a, b, cotangent(V[a] - V[c], V[b] - V[c])) for t, a, b, c in corners]


def neighbours() -> list[tuple[int, int, float]]:
    """(triangle, triangle, w_e^-1) of every two that share an edge."""
    sides: dict[tuple[int, int], tuple[int, float]] = {}
    found = []
    for t, a, b, cot in half_edges():
        edge = (min(a, b), max(a, b))
        if edge in sides:
            other, cot_other = sides[edge]
            found.append((other, t, 1 / clamp((cot + cot_other) / 2)))
        sides[edge] = (t, cot)
    return found


def poisson(R: FloatArray, X: FloatArray, free: IntArray) -> FloatArray:
    """X with its free vertices where they minimise sum w ||x_b - x_a - R (p_b - p_a)||^2."""
    L, right = np.zeros((len(V), len(V))), np.zeros((len(V), 3))
    for t, a, b, cot in half_edges():
        w, pull = clamp(cot), R[t] @ (V[b] - V[a])
        L[a, a], L[b, b] = L[a, a] + w, L[b, b] + w
        L[a, b], L[b, a] = L[a, b] - w, L[b, a] - w
        right[b], right[a] = right[b] + w * pull, right[a] - w * pull
    held = np.delete(np.arange(len(V)), free)
    X = X.copy()
    X[free] = np.linalg.solve(L[free][:, free], (right - L[:, held] @ X[held])[free])
    return X


def refined(
    G: FloatArray, X: FloatArray, free: IntArray, turning: np.ndarray, k: int
) -> FloatArray:
    R = np.stack([nearest(g) for g in G])
    X = poisson(R, X, free)
    length = ROTATION_LENGTH * shapes.size(V)
    for _ in range(k - 1):
        fit = np.zeros_like(R)
        for t, a, b, cot in half_edges():
            fit[t] += clamp(cot) * np.outer(X[b] - X[a], V[b] - V[a])
        for t, u, w in neighbours():
            fit[t] += length**2 * w * R[u]
            fit[u] += length**2 * w * R[t]
        R[turning] = [nearest(A) for A in fit[turning]]
        X = poisson(R, X, free)
    return X


@pytest.mark.parametrize("handle", [[24], [31, 32, 38, 39]], ids=["a vertex", "a region"])
@pytest.mark.parametrize("rigid", [1, 2, 4])
def test_levels_are_rounds_of_rotations_and_positions(handle: list[int], rigid: int) -> None:
    fixed = np.flatnonzero(V[:, 0] < 2)
    T = motion(rotation([1, 2, 0], 80), [-1, 0, 1], V[handle].mean(axis=0))
    deformer = Deformer(V, F, fixed, [handle])
    free = np.delete(np.arange(len(V)), [*fixed, *handle])
    corners = np.isin(F, handle)
    whole = np.asarray(corners.all(axis=1))
    holding = whole if whole.any() else corners.any(axis=1)
    turning = np.logical_not(holding | np.isin(F, fixed).all(axis=1))
    expected = refined(deformer.frames([T]), deformer.pose([T]), free, turning, rigid)
    np.testing.assert_allclose(deformer.pose([T], rigid), expected, atol=1e-9)
