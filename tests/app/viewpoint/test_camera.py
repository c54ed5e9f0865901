"""Laws of the camera: pixels and rays, and what a framed view shows."""

from __future__ import annotations

import numpy as np
import pytest

from app.viewpoint.camera import FIELD_OF_VIEW, Camera
from app.viewpoint.framing import framing
from solver.types import FloatArray

SIZE, INSET = (1280.0, 800.0), 310.0
BOXES = {
    "even": (1.0, 1.0, 1.0),
    "wide": (40.0, 1.0, 2.0),
    "tall": (1.0, 40.0, 2.0),
    "deep": (1.0, 2.0, 40.0),
    "flat": (3.0, 2.0, 0.0),
    "line": (3.0, 0.0, 0.0),
}


@pytest.fixture
def camera() -> Camera:
    return Camera.look_at([3.0, 1.0, 5.0], [0.2, 0.5, -0.1], FIELD_OF_VIEW, SIZE)


def corners(box: tuple[float, float, float], scale: float = 1.0) -> FloatArray:
    """The corners of a box that lies anywhere but at the origin."""
    unit = np.stack(np.meshgrid([0, 1], [0, 1], [0, 1]), axis=-1).reshape(-1, 3)
    return scale * (unit * box + [5.0, -7.0, 2.0])


def test_a_ray_passes_through_every_point_that_projects_to_its_pixel(camera: Camera) -> None:
    pixels = np.random.default_rng(0).uniform([0, 0], SIZE, (50, 2))
    for x, y in pixels:
        ray = camera.ray((x, y))
        assert np.isclose(np.linalg.norm(ray.direction), 1)
        along = np.array([ray.at(distance) for distance in (0.1, 2.0, 50.0)])
        np.testing.assert_allclose(camera.project(along), [(x, y)] * 3, atol=1e-6)


def test_right_of_and_above_on_screen_are_right_of_and_above(camera: Camera) -> None:
    centre = camera.position + 4 * camera.forward
    points = np.array([centre, centre + camera.right, centre + camera.up])
    middle, right, above = camera.project(points)
    np.testing.assert_allclose(middle, np.array(SIZE) / 2)
    assert right[0] > middle[0]
    assert np.isclose(right[1], middle[1])
    assert above[1] < middle[1]
    assert camera.up[1] > 0, "upright"


def test_what_is_behind_has_no_pixel(camera: Camera) -> None:
    behind = camera.position - camera.forward
    assert np.isnan(camera.project(behind[None])).all()


def test_a_pixel_covers_as_much_as_moves_the_picture_by_one(camera: Camera) -> None:
    point = camera.position + 3 * camera.forward + 0.5 * camera.up
    step = camera.units_per_pixel(point) * camera.right
    before, after = camera.project(np.array([point, point + step]))
    np.testing.assert_allclose(after - before, [1, 0], atol=1e-9)


@pytest.mark.parametrize("inset", [0.0, INSET])
@pytest.mark.parametrize("scale", [1e-4, 1.0, 1e5])
@pytest.mark.parametrize("box", BOXES.values(), ids=list(BOXES))
def test_a_framed_view_shows_everything_beside_the_panel(
    box: tuple[float, float, float], scale: float, inset: float
) -> None:
    points = corners(box, scale)
    pixels = framing(points, SIZE, inset).project(points)
    assert (pixels > [inset, 0]).all()
    assert (pixels < SIZE).all()
    room = np.array([SIZE[0] - inset, SIZE[1]])
    filled = np.ptp(pixels, axis=0) / room
    assert filled.max() > 0.5, "as large as it fits"


def test_a_view_is_framed_from_the_front() -> None:
    camera = framing(corners(BOXES["even"]), SIZE)
    np.testing.assert_allclose(camera.forward, [0, 0, -1], atol=1e-12)
    np.testing.assert_allclose(camera.up, [0, 1, 0], atol=1e-12)
