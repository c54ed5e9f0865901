"""Laws of rotations about an axis and of rigid motions."""

from __future__ import annotations

import numpy as np
import pytest

from solver.geometry.motions import (
    euler_angles,
    from_euler_angles,
    motion,
    moved,
    rotation,
    rotation_about,
)

AXIS = np.array([1.0, -2.0, 0.5])


def test_a_rotation_keeps_its_axis_lengths_and_handedness() -> None:
    R = rotation(AXIS, 50)
    np.testing.assert_allclose(R @ AXIS, AXIS, atol=1e-15)
    np.testing.assert_allclose(R @ R.T, np.eye(3), atol=1e-15)
    np.testing.assert_allclose(np.linalg.det(R), 1, atol=1e-15)


def test_angles_about_one_axis_add_up() -> None:
    np.testing.assert_allclose(
        rotation(AXIS, 50) @ rotation(AXIS, -80), rotation(AXIS, -30), atol=1e-15
    )
    np.testing.assert_allclose(rotation(AXIS, 360), np.eye(3), atol=1e-15)


def test_a_quarter_turn_about_z_takes_x_to_y() -> None:
    np.testing.assert_allclose(rotation([0, 0, 7], 90) @ [1, 0, 0], [0, 1, 0], atol=1e-15)


def test_a_rotation_about_a_line_keeps_the_line() -> None:
    T = rotation_about(AXIS, 130, [3, 1, 2])
    line = np.array([3.0, 1, 2]) + np.linspace(-2, 2, 5)[:, None] * AXIS
    np.testing.assert_allclose(moved(T, line), line, atol=1e-14)


def test_a_motion_turns_first_and_then_moves() -> None:
    T = motion(rotation([0, 0, 1], 90), [10, 0, 0], [1, 0, 0])
    np.testing.assert_allclose(moved(T, np.array([[2.0, 0, 0]])), [[11, 1, 0]], atol=1e-14)
    np.testing.assert_array_equal(T[3], [0, 0, 0, 1])


@pytest.mark.parametrize(
    "degrees",
    [(0, 0, 0), (30, -40, 170), (-179, 89.9, 12), (90, 0, 0), (0, 90, 0), (20, -90, 0)],
)
def test_euler_angles_are_those_a_rotation_was_made_of(degrees: tuple[float, ...]) -> None:
    np.testing.assert_allclose(euler_angles(from_euler_angles(degrees)), degrees, atol=1e-9)


def test_where_two_euler_angles_turn_about_one_axis_the_rotation_is_still_found() -> None:
    for y in (90, -90):
        R = from_euler_angles([25, y, 60])
        np.testing.assert_allclose(from_euler_angles(euler_angles(R)), R, atol=1e-12)


def test_euler_angles_turn_about_x_first() -> None:
    R = from_euler_angles([90, 0, 90])
    np.testing.assert_allclose(R @ [0, 1, 0], [0, 0, 1], atol=1e-15)
    np.testing.assert_allclose(R @ [0, 0, 1], [1, 0, 0], atol=1e-15)
