"""What buttons and wheel do to the view, and what stays in it."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from app.viewpoint.events import Input
from app.viewpoint.viewpoint import SIDES, UPS, Motion, Viewpoint
from solver.types import FloatArray

SIZE, INSET = (1280.0, 800.0), 310.0
BOX = np.array([[x, y, z] for x in (2.0, 4.0) for y in (-1.0, 1.0) for z in (0.0, 0.5)])
CENTRE = BOX.mean(axis=0)


@pytest.fixture
def view() -> Viewpoint:
    made = Viewpoint()
    made.show(BOX)
    made.fit(SIZE, INSET)
    return made


def seen(view: Viewpoint, point: FloatArray) -> FloatArray:
    return view.camera.project(point[None])[0]


def drag(
    view: Viewpoint, *pixels: tuple[float, float], left: Motion | None = None, **mouse: Any
) -> None:
    for pixel in pixels:
        view.advance(Input(pixel, view.camera, **mouse), left, lambda: None)
    view.advance(Input(pixels[-1], view.camera), None, lambda: None)


def test_a_shown_surface_is_in_the_middle_of_what_the_panel_leaves(view: Viewpoint) -> None:
    low, high = (f(view.camera.project(BOX), axis=0) for f in (np.min, np.max))
    front = view.camera.project(BOX[BOX[:, 2] == BOX[:, 2].max()]).mean(axis=0)
    np.testing.assert_allclose(front, [(SIZE[0] + INSET) / 2, SIZE[1] / 2], atol=1e-6)
    assert (low > [INSET, 0]).all()
    assert (high < SIZE).all()
    np.testing.assert_allclose(view.pivot, CENTRE)


@pytest.mark.parametrize("how", [{"left": "orbit", "down": True}, {"middle": True}])
def test_the_view_turns_about_the_middle_of_the_mesh(view: Viewpoint, how: dict[str, Any]) -> None:
    before, forward = seen(view, CENTRE), view.camera.forward
    drag(view, (400, 300), (700, 420), **how)
    np.testing.assert_allclose(seen(view, CENTRE), before, atol=1e-6)
    assert view.camera.forward @ forward < 0.9


@pytest.mark.parametrize("how", [{"secondary": True}, {"middle": True, "shift": True}])
def test_a_pan_keeps_what_was_grabbed_under_the_mouse(view: Viewpoint, how: dict[str, Any]) -> None:
    corner = BOX[-1]
    start = tuple(seen(view, corner))
    for pixel in (start, (600.0, 200.0), (1200.0, 777.0)):
        view.advance(Input(pixel, view.camera, **how), None, lambda: corner)
    np.testing.assert_allclose(seen(view, corner), [1200, 777], atol=1e-6)


def test_the_wheel_beside_the_surface_zooms_to_the_cursor_too(view: Viewpoint) -> None:
    pixel = (1100.0, 100.0)
    beside = view.camera.at_depth(pixel, view.camera.depth(view.pivot))
    before = view.camera.depth(CENTRE)
    view.advance(Input(pixel, view.camera, wheel=3), None, lambda: None)
    np.testing.assert_allclose(seen(view, beside), pixel, atol=1e-6)
    assert view.camera.depth(CENTRE) < before


def test_over_the_panel_nothing_moves(view: Viewpoint) -> None:
    before = view.camera
    view.advance(Input(None, before, wheel=3, secondary=True), None, lambda: None)
    assert view.camera is before


def test_what_was_framed_is_framed_again_in_another_window(view: Viewpoint) -> None:
    view.fit((640.0, 900.0), INSET)
    pixels = view.camera.project(BOX)
    assert (pixels > [INSET, 0]).all()
    assert (pixels < [640, 900]).all()
    drag(view, (400, 300), (500, 420), left="orbit", down=True)
    moved = view.camera
    view.fit(SIZE, INSET)
    np.testing.assert_array_equal(view.camera.position, moved.position)


def test_framing_keeps_the_direction_and_turns_about_what_is_framed(view: Viewpoint) -> None:
    drag(view, (400, 300), (700, 420), left="orbit", down=True)
    forward = view.camera.forward
    view.frame(BOX[:2])
    np.testing.assert_array_equal(view.camera.forward, forward)
    np.testing.assert_allclose(view.pivot, BOX[:2].mean(axis=0))


@pytest.mark.parametrize("up", list(UPS))
@pytest.mark.parametrize("side", list(SIDES))
def test_every_side_shows_everything_upright(view: Viewpoint, up: str, side: str) -> None:
    view.set_up(up)
    view.view_from(side, BOX)
    camera = view.camera
    if side in ("top", "bottom"):
        assert abs(camera.forward @ UPS[up]) == pytest.approx(1)
    else:
        np.testing.assert_allclose(camera.up, UPS[up])
    assert camera.up @ camera.forward == pytest.approx(0)
    pixels = camera.project(BOX)
    assert (pixels > [INSET, 0]).all()
    assert (pixels < SIZE).all()
    forward = camera.forward
    view.view_from({"front": "back", "left": "right", "top": "bottom"}.get(side, "front"), BOX)
    assert view.camera.forward @ forward < 0.1


def test_front_has_x_at_the_right_whatever_is_up(view: Viewpoint) -> None:
    for up in UPS:
        view.set_up(up)
        view.view_from("front", BOX)
        np.testing.assert_allclose(view.camera.right, [1, 0, 0], atol=1e-12)
