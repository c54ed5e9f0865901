"""Laws of screw motions and of what lies between two affine maps."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from solver.geometry.motions import motion, moved, rotation, rotation_about
from solver.geometry.screws import blended, screw, wound
from solver.types import FloatArray

AXIS = np.array([1.0, -2.0, 0.5])
SHARES = (0.0, 0.1, 0.5, 0.8, 1.0)
ANGLES = (0.0, 1e-9, 1e-4, 1.0, 90.0, 179.9999, 180.0)


def rigid(seed: int) -> FloatArray:
    """Any rigid motion."""
    random = np.random.default_rng(seed)
    return motion(Rotation.random(rng=random).as_matrix(), random.normal(size=3))


def affine(seed: int) -> FloatArray:
    """Any affine map that mirrors nothing, close to a rigid motion."""
    random = np.random.default_rng(seed)
    T = rigid(seed)
    T[:3, :3] += random.normal(size=(3, 3)) / 8
    return T


@pytest.mark.parametrize("angle", ANGLES)
def test_shares_of_a_screw_add_up_and_the_whole_is_the_motion(angle: float) -> None:
    D = rotation_about(AXIS, angle, [3, 1, 2]) @ motion(np.eye(3), 0.7 * AXIS)
    np.testing.assert_allclose(screw(D, 1.0), D, atol=1e-9)
    np.testing.assert_allclose(screw(D, 0.0), np.eye(4), atol=1e-12)
    for s, t in ((0.3, 0.7), (0.25, 0.25), (1.5, -0.6)):
        np.testing.assert_allclose(screw(D, s) @ screw(D, t), screw(D, s + t), atol=1e-9)


def test_a_point_of_a_screw_moves_at_even_speed_along_a_helix() -> None:
    D = rotation_about([0, 0, 1], 120, [2, 0, 0]) @ motion(np.eye(3), [0, 0, 6.0])
    for share in SHARES:
        place = moved(screw(D, share), np.array([[3.0, 0, 0]]))[0]
        angle = np.radians(120 * share)
        expected = [2 + np.cos(angle), np.sin(angle), 6 * share]
        np.testing.assert_allclose(place, expected, atol=1e-12)


def test_a_shift_is_a_straight_line_and_a_turn_keeps_its_centre() -> None:
    shift = motion(np.eye(3), [3.0, -1, 2])
    np.testing.assert_allclose(screw(shift, 0.25)[:3, 3], [0.75, -0.25, 0.5], atol=1e-15)
    turn = rotation_about(AXIS, 100, [5, 4, -3])
    expected = rotation_about(AXIS, 25, [5, 4, -3])
    np.testing.assert_allclose(screw(turn, 0.25), expected, atol=1e-13)


def test_half_of_180_degrees_is_a_quarter_turn_either_way() -> None:
    D = rotation_about([0, 0, 1], 180, [1, 0, 0])
    half = screw(D, 0.5)
    ways = [rotation_about([0, 0, 1], angle, [1, 0, 0]) for angle in (90, -90)]
    assert min(np.abs(half - way).max() for way in ways) < 1e-9


@pytest.mark.parametrize("seed", range(5))
def test_what_lies_between_ends_exactly_at_its_ends(seed: int) -> None:
    A, B = affine(seed), affine(seed + 50)
    np.testing.assert_array_equal(blended(A, B, 0.0), A)
    np.testing.assert_array_equal(blended(A, B, 1.0), B)
    for share, end in ((1e-9, A), (1 - 1e-9, B)):  # and comes from there without a step
        np.testing.assert_allclose(blended(A, B, share), end, atol=1e-6)


@pytest.mark.parametrize("seed", range(5))
def test_between_rigid_motions_all_are_rigid_and_lie_on_the_screw(seed: int) -> None:
    A, B = rigid(seed), rigid(seed + 50)
    for share in SHARES[1:-1]:
        T = blended(A, B, share, centre=[9.0, 8, 7])
        np.testing.assert_allclose(T, screw(B @ np.linalg.inv(A), share) @ A, atol=1e-9)
        np.testing.assert_allclose(T[:3, :3] @ T[:3, :3].T, np.eye(3), atol=1e-9)
        np.testing.assert_allclose(T, A @ screw(np.linalg.inv(A) @ B, share), atol=1e-9)


@pytest.mark.parametrize("seed", range(5))
def test_another_frame_and_a_motion_of_everything_make_no_difference(seed: int) -> None:
    A, B, g = affine(seed), affine(seed + 50), rigid(seed + 99)
    back, centre = np.linalg.inv(g), np.array([1.0, 2, 3])
    for share in SHARES[1:-1]:
        T = blended(A, B, share, centre)
        there = moved(g, centre[None])[0]
        np.testing.assert_allclose(
            blended(g @ A @ back, g @ B @ back, share, there), g @ T @ back, atol=1e-9
        )
        np.testing.assert_allclose(blended(g @ A, g @ B, share, centre), g @ T, atol=1e-9)
        np.testing.assert_allclose(blended(B, A, 1 - share, centre), T, atol=1e-9)
        np.testing.assert_array_equal(T[3], [0, 0, 0, 1])


def test_a_scaled_and_turned_handle_keeps_its_centre_on_the_screw_and_grows_evenly() -> None:
    centre = np.array([4.0, 0, 0])
    grown = motion(3.0 * np.eye(3), centre=centre)
    B = rotation_about([0, 0, 1], 90) @ grown
    for share in SHARES:
        T = blended(np.eye(4), B, share, centre)
        place = moved(T, centre[None])[0]
        expected = rotation([0, 0, 1], 90 * share) @ centre
        np.testing.assert_allclose(place, expected, atol=1e-12)
        sizes = np.linalg.svd(T[:3, :3], compute_uv=False)
        np.testing.assert_allclose(sizes, 1 + 2 * share, atol=1e-12)


@pytest.mark.parametrize("diagonal", [(0, 1, 1), (0, 0, 1), (0, 0, 0), (-1, 1, 1)])
def test_maps_that_flatten_or_mirror_have_something_between_too(
    diagonal: tuple[float, float, float],
) -> None:
    B = np.diag([*diagonal, 1.0])
    for share in SHARES:
        expected = (1 - share) * np.eye(4) + share * B
        np.testing.assert_allclose(blended(np.eye(4), B, share), expected, atol=1e-9)


@pytest.mark.parametrize("angle", [200.0, 269.0, 271.0, 360.0, 540.0, -725.0])
def test_a_wound_motion_turns_evenly_all_the_way_and_ends_at_the_whole(angle: float) -> None:
    turn = np.radians(angle) * AXIS / np.linalg.norm(AXIS)
    D = motion(Rotation.from_rotvec(turn).as_matrix(), [0.3, 2.0, -1.0])
    np.testing.assert_allclose(wound(D, 0.0, turn, [1, 2, 3]), np.eye(4), atol=1e-12)
    np.testing.assert_allclose(wound(D, 1.0, turn, [1, 2, 3]), D, atol=1e-9)
    for share in SHARES:
        R = wound(D, share, turn, [1, 2, 3])[:3, :3]
        np.testing.assert_allclose(R, Rotation.from_rotvec(share * turn).as_matrix(), atol=1e-9)


@pytest.mark.parametrize("angle", [200.0, 260.0])
def test_far_swings_keep_their_line_and_twists_their_centre(angle: float) -> None:
    hinge = np.array([1.0, -1.0, 2.0])
    turn = np.radians(angle) * AXIS / np.linalg.norm(AXIS)
    half = wound(rotation_about(AXIS, angle, hinge), 0.5, turn, [5, 5, 5])
    np.testing.assert_allclose(half, rotation_about(AXIS, angle / 2, hinge), atol=1e-9)
    twist = wound(rotation_about(AXIS, 3 * angle, hinge), 0.5, 3 * turn, hinge)
    np.testing.assert_allclose(twist, rotation_about(AXIS, 1.5 * angle, hinge), atol=1e-9)
