"""Laws of how the camera moves: what keeps its pixel, what stays upright, how close it comes."""

from __future__ import annotations

import numpy as np
import pytest

from app.viewpoint.camera import FIELD_OF_VIEW, Camera
from app.viewpoint.moves import STEEPEST, orbited, panned, zoomed
from solver.types import FloatArray

UP = np.array([0.0, 1.0, 0.0])
PIVOT = np.array([0.7, 0.9, -0.4])


@pytest.fixture
def camera() -> Camera:
    return Camera.look_at([3.0, 1.0, 5.0], [0.2, 0.5, -0.1], FIELD_OF_VIEW, (1280.0, 800.0))


def pixel(camera: Camera, point: FloatArray) -> FloatArray:
    return camera.project(point[None])[0]


@pytest.mark.parametrize("way", [(300.0, 0.0), (0.0, -120.0), (-500.0, 90.0)])
def test_the_pivot_keeps_its_pixel_and_its_distance(
    camera: Camera, way: tuple[float, float]
) -> None:
    turned = orbited(camera, PIVOT, way, UP)
    np.testing.assert_allclose(pixel(turned, PIVOT), pixel(camera, PIVOT), atol=1e-6)
    before, after = (np.linalg.norm(c.position - PIVOT) for c in (camera, turned))
    assert after == pytest.approx(before)
    assert turned.right @ UP == pytest.approx(0, abs=1e-12), "upright"
    assert np.linalg.norm(turned.forward - camera.forward) > 0.1


def test_the_near_side_follows_the_cursor(camera: Camera) -> None:
    near = PIVOT - 0.3 * camera.forward
    turned = orbited(camera, PIVOT, (20.0, 15.0), UP)
    assert (pixel(turned, near) > pixel(camera, near)).all()


@pytest.mark.parametrize("way", [-1e4, 1e4])
def test_the_view_never_passes_the_pole(camera: Camera, way: float) -> None:
    turned = orbited(camera, PIVOT, (0.0, way), UP)
    assert abs(np.arcsin(turned.forward @ UP)) == pytest.approx(STEEPEST)
    assert turned.up @ UP > 0


def test_the_grabbed_point_stays_under_the_cursor(camera: Camera) -> None:
    moved = panned(camera, PIVOT, (1000.0, 120.0))
    np.testing.assert_allclose(pixel(moved, PIVOT), (1000, 120), atol=1e-6)
    np.testing.assert_array_equal(moved.forward, camera.forward)
    assert moved.depth(PIVOT) == pytest.approx(camera.depth(PIVOT))


@pytest.mark.parametrize("notches", [-3.0, 0.5, 4.0])
def test_the_wheel_goes_towards_the_point_under_the_cursor(camera: Camera, notches: float) -> None:
    moved = zoomed(camera, PIVOT, notches, 1e-3)
    np.testing.assert_allclose(pixel(moved, PIVOT), pixel(camera, PIVOT), atol=1e-6)
    assert (moved.depth(PIVOT) < camera.depth(PIVOT)) == (notches > 0)
    back = zoomed(moved, PIVOT, -notches, 1e-3)
    np.testing.assert_allclose(back.position, camera.position)


def test_the_wheel_never_goes_through_the_point(camera: Camera) -> None:
    moved = zoomed(camera, PIVOT, 1000, 0.01)
    assert np.linalg.norm(moved.position - PIVOT) == pytest.approx(0.01)
    assert moved.depth(PIVOT) > 0
    closer = zoomed(moved, PIVOT, 1, 0.01)
    np.testing.assert_allclose(closer.position, moved.position)
