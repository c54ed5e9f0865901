"""Laws of turns: rotation vectors that count whole turns."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from solver.geometry.turns import MOST, nearest_turn, turned_by
from solver.types import FloatArray

AXIS = np.array([2.0, -1.0, 2.0]) / 3
DEGREES = (0.0, 1e-5, 30.0, 179.9, 180.0, 180.1, 359.99999, 360.0, 540.0, -725.0, 3600.0)


def matrix(turn: FloatArray) -> FloatArray:
    return Rotation.from_rotvec(turn).as_matrix()


@pytest.mark.parametrize("degrees", DEGREES)
def test_a_turn_is_its_own_nearest(degrees: float) -> None:
    turn = np.radians(degrees) * AXIS
    np.testing.assert_allclose(nearest_turn(matrix(turn), turn), turn, atol=1e-6)


@pytest.mark.parametrize("seed", range(20))
def test_it_leads_to_the_rotation_and_no_other_that_does_is_nearer(seed: int) -> None:
    random = np.random.default_rng(seed)
    R = Rotation.random(rng=random)
    near = random.normal(size=3) * 15
    turn = nearest_turn(R.as_matrix(), near)
    np.testing.assert_allclose(matrix(turn), R.as_matrix(), atol=1e-9)
    short = R.as_rotvec()
    axis = short / np.linalg.norm(short)
    others = [short + k * 2 * np.pi * axis for k in range(-9, 10)]
    least = min(float(np.linalg.norm(other - near)) for other in others)
    assert np.linalg.norm(turn - near) == pytest.approx(least)


@pytest.mark.parametrize(("start", "way"), list(product(DEGREES, DEGREES)))
def test_turns_about_one_axis_add_up(start: float, way: float) -> None:
    found = turned_by(np.radians(start) * AXIS, np.radians(way) * AXIS)
    np.testing.assert_allclose(found, np.radians(start + way) * AXIS, atol=1e-5)


def test_turns_about_different_axes_lead_where_the_rotations_do() -> None:
    turn, way = np.radians([0, 0, 400.0]), np.radians([35.0, 500, -60])
    found = turned_by(turn, way)
    np.testing.assert_allclose(matrix(found), matrix(way) @ matrix(turn), atol=1e-9)


def test_small_steps_count_whole_turns() -> None:
    turn = np.zeros(3)
    for degrees in range(0, 2000, 25):
        turn = nearest_turn(matrix(np.radians(degrees) * AXIS), turn)
    np.testing.assert_allclose(turn, np.radians(1975) * AXIS, atol=1e-9)


@pytest.mark.parametrize("degrees", [40_000.0, -1e7, 1e12])
def test_no_turn_is_too_long(degrees: float) -> None:
    for start in (np.zeros(3), 0.99 * MOST * AXIS):
        turn = turned_by(start, np.radians(degrees) * AXIS)
        assert np.linalg.norm(turn) <= MOST
        np.testing.assert_allclose(matrix(nearest_turn(matrix(turn), 1e9 * turn)), matrix(turn))
