"""The gizmo: of constant size, easy to hit, and out of the way."""

from __future__ import annotations

import numpy as np
import pytest

from app.tools.gizmo.freedoms import MoveAlong, TurnAbout, TurnFreely
from app.tools.gizmo.shape import BALL, MIDDLE, RADIUS, REACH, Gizmo, Part
from app.viewpoint.camera import FIELD_OF_VIEW, Camera, Pixel
from solver.types import FloatArray

PIVOT = np.array([1.0, 2.0, 3.0])


def seen_from(*eye: float) -> Camera:
    return Camera.look_at(PIVOT + eye, PIVOT, FIELD_OF_VIEW, (1280, 800))


def gizmo(camera: Camera) -> Gizmo:
    return Gizmo(PIVOT, np.eye(3), camera)


def beside(x: float, y: float) -> Pixel:
    """So many pixels from the pivot, in the middle of the window; y up."""
    return 640 + x, 400 - y


def ring(shape: Gizmo, name: str) -> Part:
    found = (p for p in shape.parts if isinstance(p.freedom, TurnAbout) and p.freedom.name == name)
    return next(found)


def project(camera: Camera, segments: FloatArray) -> FloatArray:
    return camera.project(segments.reshape(-1, 3)) - beside(0, 0)


@pytest.mark.parametrize("distance", [3.0, 300.0])
def test_it_has_the_same_size_from_near_and_far(distance: float) -> None:
    camera = seen_from(0, 0, distance)
    radii = np.hypot(*project(camera, ring(gizmo(camera), "z").near).T)
    np.testing.assert_allclose(radii, RADIUS, rtol=1e-9)


def test_a_part_is_hit_with_forgiveness_and_not_beyond() -> None:
    camera = seen_from(0, 0, 10)
    shape, corner = gizmo(camera), RADIUS * np.sqrt(0.5)
    for off in (0, 0.9 * REACH, -0.9 * REACH):
        part = shape.under(beside(corner + off * np.sqrt(0.5), corner + off * np.sqrt(0.5)))
        assert part is not None
        assert isinstance(part.freedom, TurnAbout)
        assert part.freedom.name == "z"
    outside = (BALL * RADIUS + 1.5 * REACH) * np.sqrt(0.5)
    assert shape.under(beside(outside, outside)) is None


def test_every_part_can_be_found() -> None:
    camera = seen_from(6, 5, 7)
    shape = gizmo(camera)
    for part in shape.parts:
        where = project(camera, part.near) + beside(0, 0)
        found = {id(shape.under((x, y))) for x, y in where}
        assert id(part) in found, part.freedom
    kinds = [type(part.freedom) for part in shape.parts]
    assert kinds == [MoveAlong] * 3 + [TurnAbout] * 3 + [TurnFreely]


def test_the_middle_is_left_to_the_handle() -> None:
    for eye in ((0, 0, 10), (6, 5, 7)):
        shape = gizmo(seen_from(*eye))
        for angle in np.linspace(0, 6, 20):
            reach = 0.95 * MIDDLE * RADIUS
            assert shape.under(beside(reach * np.cos(angle), reach * np.sin(angle))) is None


def test_what_is_hidden_behind_is_fainter_and_cannot_be_pressed() -> None:
    camera = seen_from(0, 6, 8)
    shape = gizmo(camera)
    part = ring(shape, "y")
    behind = project(camera, part.far)
    assert len(part.near) > len(part.far) > 10
    highest = behind[np.argmin(behind[:, 1])] + beside(0, 0)
    found = shape.under((highest[0], highest[1]))
    assert found is not part
    overlay = shape.overlay(part)
    opacity = {id(o.segments): o.opacity for o in overlay.outlines}
    assert opacity[id(part.far)] < opacity[id(part.near)] == 1


def test_the_hovered_part_is_bright_wide_and_on_top() -> None:
    shape = gizmo(seen_from(6, 5, 7))
    part = ring(shape, "x")
    plain, hovered = shape.overlay().outlines, shape.overlay(part).outlines
    last = hovered[-1]
    before = next(o for o in plain if o.segments is part.near)
    assert last.segments is part.near
    assert sum(last.color) > sum(before.color)
    assert last.width > before.width


def test_an_axis_towards_the_viewer_has_no_arrow() -> None:
    shape = gizmo(seen_from(0, 0, 10))
    names = [part.freedom.name for part in shape.parts if isinstance(part.freedom, MoveAlong)]
    assert names == ["x", "y"]
