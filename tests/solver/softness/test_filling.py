"""Filling between dabs: gaps are blended, and what lies beyond them stays as it was."""

from __future__ import annotations

import numpy as np
import pytest

from solver.softness.filling import fill_between
from solver.types import FloatArray, IntArray
from tests.solver import shapes

LENGTH = 40


@pytest.fixture
def strip() -> tuple[FloatArray, IntArray]:
    """A strip along x from 0 to LENGTH, five vertices wide."""
    return shapes.grid(LENGTH + 1, 5)


def dabs(V: FloatArray, values: dict[int, float]) -> tuple[IntArray, FloatArray]:
    """Whole columns at some x, and a softness that has their values and 0 elsewhere."""
    softness = np.zeros(len(V))
    for x, value in values.items():
        softness[V[:, 0] == x] = value
    return np.flatnonzero(np.isin(V[:, 0], list(values))), softness


def test_gaps_are_linear_and_the_rest_stays(strip: tuple[FloatArray, IntArray]) -> None:
    V, F = strip
    pins, softness = dabs(V, {10: 0.0, 14: 1.0, 19: 0.0})
    softness[V[:, 0] > 30] = 0.7
    filled = fill_between(V, F, softness, pins, np.ones(len(V), dtype=bool), 1.0)
    expected = np.interp(V[:, 0], [10, 14, 19], [0, 1, 0])
    between = (V[:, 0] >= 10) & (V[:, 0] <= 19)
    np.testing.assert_allclose(filled[between], expected[between], atol=1e-3)
    beyond = (V[:, 0] < 5) | (V[:, 0] > 24)
    np.testing.assert_array_equal(filled[beyond], softness[beyond])


def test_a_soft_end_fades_out_within_its_reach(strip: tuple[FloatArray, IntArray]) -> None:
    V, F = strip
    pins, softness = dabs(V, {10: 0.0, 16: 1.0})
    filled = fill_between(V, F, softness, pins, np.ones(len(V), dtype=bool), 1.0)
    along = [filled[V[:, 0] == x].mean() for x in range(16, 24)]
    assert (np.diff(along) < 0).all()
    assert np.abs(np.diff(along)).max() < 0.3, "no step"
    assert along[-1] == 0


def test_it_does_not_pass_through_what_is_held(strip: tuple[FloatArray, IntArray]) -> None:
    V, F = strip
    pins, softness = dabs(V, {10: 1.0})
    open_ = ~((V[:, 0] >= 12) & (V[:, 0] <= 14))
    filled = fill_between(V, F, softness, pins, open_, 20.0)
    assert filled[V[:, 0] == 11].min() > 0.5
    np.testing.assert_array_equal(filled[V[:, 0] >= 12], 0)


def test_what_is_pinned_keeps_its_value_and_nothing_leaves_its_bounds() -> None:
    V, F = shapes.grid(25, 25)
    rng = np.random.default_rng(3)
    pins = rng.choice(len(V), 12, replace=False)
    softness = np.zeros(len(V))
    softness[pins] = rng.uniform(0.2, 1.0, len(pins))
    filled = fill_between(V, F, softness, pins, np.ones(len(V), dtype=bool), 1.0)
    np.testing.assert_array_equal(filled[pins], softness[pins])
    assert filled.min() >= 0
    assert filled.max() <= softness.max()


def test_seams_are_no_border() -> None:
    V, F = shapes.grid(LENGTH + 1, 5)
    left = (V[F][:, :, 0] <= 20).all(axis=1)
    cut = np.vstack([V, V])
    faces = np.vstack([F[left], F[~left] + len(V)])
    twice = np.concatenate([V[:, 0] <= 20, V[:, 0] >= 20])
    pins, softness = dabs(cut, {15: 0.0, 25: 1.0})
    pins = pins[twice[pins]]
    filled = fill_between(cut, faces, softness, pins, twice, 1.0)
    np.testing.assert_allclose(filled[(cut[:, 0] == 20) & twice], 0.5, atol=1e-3)
