"""The steps and the descent that the rigid levels are made of."""

from __future__ import annotations

import numpy as np

from solver.geometry.motions import rotation
from solver.geometry.rotations import torques, turned
from solver.rigid.lbfgs import LBFGS
from solver.types import FloatArray

rng = np.random.default_rng(5)


def test_turned_rows_are_turned_about_their_axis_by_its_length() -> None:
    rows, w = rng.normal(size=(30, 3, 3)), rng.normal(size=(30, 3))
    turns = [rotation(axis, np.degrees(np.linalg.norm(axis))) for axis in w]
    expected = np.stack([row @ R.T for row, R in zip(rows, turns, strict=True)])
    np.testing.assert_allclose(turned(rows, w), expected, atol=1e-12)


def test_rows_that_do_not_turn_stay_to_the_last_bit() -> None:
    rows = rng.normal(size=(30, 3, 3))
    np.testing.assert_array_equal(turned(rows, np.zeros((30, 3))), rows)


def test_torques_are_the_slope_of_a_turn() -> None:
    rows, pull, w = (rng.normal(size=(30, 3, *shape)) for shape in ((3,), (3,), ()))
    small = 1e-6
    ahead, behind = (np.sum(pull * turned(rows, sign * small * w)) for sign in (1, -1))
    np.testing.assert_allclose(np.sum(torques(rows, pull) * w), (ahead - behind) / (2 * small))


def test_the_direction_leads_downhill_whatever_was_learnt() -> None:
    curvature = LBFGS(lambda gradient: gradient)
    for _ in range(20):
        gradient = rng.normal(size=(10, 3))
        assert np.sum(curvature.direction(gradient) * gradient) < 0
        curvature.learn(rng.normal(size=(10, 3)), rng.normal(size=(10, 3)))


def test_descent_on_a_quadratic_ends_in_its_minimum() -> None:
    A = rng.normal(size=(30, 30))
    H = A @ A.T + np.eye(30)
    lowest = rng.normal(size=(10, 3))

    def gradient(x: FloatArray) -> FloatArray:
        return np.asarray((H @ (x - lowest).ravel()).reshape(10, 3))

    curvature = LBFGS(lambda g: g / np.trace(H))
    x = np.zeros((10, 3))
    for _ in range(300):
        g = gradient(x)
        d = curvature.direction(g)
        length = -np.sum(d * g) / max(np.sum(d.ravel() * (H @ d.ravel())), 1e-300)
        curvature.learn(length * d, gradient(x + length * d) - g)
        x = x + length * d
    np.testing.assert_allclose(x, lowest, atol=1e-6)
