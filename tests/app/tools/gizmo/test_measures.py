"""Angles and distances from the cursor: what is drawn where they say is under the cursor."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest

from app.tools.gizmo.freedoms import round_step
from app.tools.gizmo.measures import (
    EDGE_ON,
    angle_about,
    distance_along,
    shift_between,
    turn_between,
)
from app.viewpoint.camera import FIELD_OF_VIEW, Camera, Pixel
from solver.geometry.motions import moved, rotation, rotation_about
from solver.types import FloatArray

PIVOT = np.array([0.3, -0.2, 0.5])
SIZE = (1280, 800)
EYES = [(0, 0, 8), (5, 3, 6), (-4, 6, -3)]
AXES = [(1, 0, 0), (0, 1, 0), (0, 0, 1), (0.6, 0, -0.8)]


def seen_from(eye: tuple[float, ...]) -> Camera:
    return Camera.look_at(PIVOT + eye, PIVOT + [0.1, 0.2, 0], FIELD_OF_VIEW, SIZE)


def pixel(camera: Camera, point: FloatArray) -> Pixel:
    ((x, y),) = camera.project(point[None])
    return float(x), float(y)


def across(axis: FloatArray) -> FloatArray:
    side = np.cross(axis, [0.36, 0.48, 0.8])
    return np.asarray(side / np.linalg.norm(side))


def cosine(eye: tuple[float, ...], axis: tuple[float, ...]) -> float:
    """Of the angle between view and axis."""
    return abs(float(np.dot(eye, axis))) / float(np.linalg.norm(eye))


VIEWS = list(product(EYES, AXES))
FACED = [view for view in VIEWS if cosine(*view) > 1.01 * EDGE_ON]
BESIDE = [view for view in VIEWS if cosine(*view) < 0.99]


@pytest.mark.parametrize(("eye", "axis"), FACED)
@pytest.mark.parametrize("degrees", [1.0, 90.0, -170.0])
def test_a_point_that_the_cursor_carries_about_an_axis_turns_by_the_angle(
    eye: tuple[float, ...], axis: tuple[float, ...], degrees: float
) -> None:
    camera, u = seen_from(eye), np.array(axis)
    start = PIVOT + across(u)
    end = moved(rotation_about(u, degrees, PIVOT), start)
    found = angle_about(camera, PIVOT, u, pixel(camera, start), pixel(camera, end))
    assert found == pytest.approx(degrees, abs=1e-9)


def test_a_ring_seen_from_its_side_turns_as_its_near_side_goes() -> None:
    camera = Camera.look_at(PIVOT + [0, 0, 8], PIVOT, FIELD_OF_VIEW, SIZE)
    x, y = pixel(camera, PIVOT)
    about_y = angle_about(camera, PIVOT, np.array([0.0, 1, 0]), (x, y), (x + 100, y))
    about_x = angle_about(camera, PIVOT, np.array([1.0, 0, 0]), (x, y), (x, y + 100))
    assert about_y is not None
    assert about_y > 0
    assert about_x == pytest.approx(about_y)
    # What is nearest to the viewer goes to the right about y, and down about x.
    assert (rotation([0, 1, 0], 10) @ [0, 0, 1])[0] > 0
    assert (rotation([1, 0, 0], 10) @ [0, 0, 1])[1] < 0
    whole = angle_about(camera, PIVOT, np.array([0.0, 1, 0]), (x, y), (x + SIZE[1], y))
    assert whole == pytest.approx(180)
    beside = angle_about(camera, PIVOT, np.array([0.0, 1, 0]), (x, y), (x, y + 100))
    assert beside == pytest.approx(0, abs=1e-9)


def test_no_angle_where_the_cursor_does_not_see_the_plane() -> None:
    camera = Camera.look_at(PIVOT + [0, 2.5, 8], PIVOT, FIELD_OF_VIEW, SIZE)
    above_the_horizon = (640.0, 5.0)
    up = np.array([0.0, 1, 0])
    assert angle_about(camera, PIVOT, up, pixel(camera, PIVOT), above_the_horizon) is None


@pytest.mark.parametrize(("eye", "axis"), BESIDE)
@pytest.mark.parametrize("distance", [0.01, 1.0, -0.7])
def test_a_point_of_an_axis_that_the_cursor_carries_moves_by_the_distance(
    eye: tuple[float, ...], axis: tuple[float, ...], distance: float
) -> None:
    camera, u = seen_from(eye), np.array(axis)
    ends = pixel(camera, PIVOT), pixel(camera, PIVOT + distance * u)
    assert distance_along(camera, PIVOT, u, *ends) == pytest.approx(distance, abs=1e-9)


def test_ways_add_up() -> None:
    camera, u = seen_from(EYES[1]), np.array(AXES[3])
    a, b, c = (500.0, 300.0), (640.0, 420.0), (700.0, 390.0)
    for measure in (angle_about, distance_along):
        one, two, both = (measure(camera, PIVOT, u, *ends) for ends in ((a, b), (b, c), (a, c)))
        assert one is not None
        assert two is not None
        assert one + two == pytest.approx(both)


def test_an_axis_seen_from_its_end_goes_away_as_the_cursor_goes_up() -> None:
    camera = Camera.look_at(PIVOT + [0, 0, 8], PIVOT, FIELD_OF_VIEW, SIZE)
    x, y = pixel(camera, PIVOT)
    z = np.array([0.0, 0, 1])
    towards = distance_along(camera, PIVOT, z, (x, y), (x, y + 50))
    assert towards == pytest.approx(50 * camera.units_per_pixel(PIVOT))
    back = distance_along(camera, PIVOT, -z, (x, y), (x, y + 50))
    assert back == pytest.approx(-50 * camera.units_per_pixel(PIVOT))


def test_the_pivot_stays_under_a_cursor_that_shifts_it() -> None:
    camera = seen_from(EYES[1])
    before, now = pixel(camera, PIVOT), (700.0, 120.0)
    shift = shift_between(camera, PIVOT, before, now)
    assert pixel(camera, PIVOT + shift) == pytest.approx(now)
    assert shift @ camera.forward == pytest.approx(0, abs=1e-12)


def test_the_front_of_a_ball_follows_the_cursor() -> None:
    camera = seen_from(EYES[2])
    w = turn_between(camera, (100, 100), (110, 80))  # right and up
    front = rotation(w, 1.0) @ -camera.forward
    assert front @ camera.right > 0
    assert front @ camera.up > 0


@pytest.mark.parametrize(
    ("length", "step"), [(100.0, 1.0), (1.0, 0.01), (240.0, 2.0), (0.45, 0.005), (800.0, 10.0)]
)
def test_steps_are_round_and_about_a_hundredth(length: float, step: float) -> None:
    assert round_step(length) == pytest.approx(step)
