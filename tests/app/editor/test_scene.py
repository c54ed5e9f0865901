"""The scene that the editor makes: the same arrays while nothing changes, others once it has."""

from __future__ import annotations

from typing import ClassVar

import numpy as np
import pytest

from app.bundled import DEFAULT_MESH
from app.editor import commands as c
from app.model.handles import FIXED
from app.scene.overlay import ERASING, NOTHING, PAINTING, Outline, Overlay
from app.tools.table import TOOLS
from app.tools.tool import Tool
from app.viewpoint.camera import Pixel
from app.viewpoint.events import Input
from app.workspace.workspace import Workspace
from tests.app.person import Person, state


def test_what_has_not_changed_is_the_same_object(ready: Person) -> None:
    ready.use("softness", 2)
    ready.stroke([10, 2, 0])
    one = ready.editor.scene()
    ready.frame([12, 2, 0])
    two = ready.editor.scene()
    assert one.dots is not None
    for field in ("shaded", "positions", "colors", "dots"):
        assert getattr(one, field) is getattr(two, field), field


def test_what_has_changed_is_another_object_and_the_old_one_is_as_it_was(ready: Person) -> None:
    ready.use("softness", 2)
    ready.stroke([8, 2, 0])
    before = ready.editor.scene()
    assert before.dots is not None
    colors, centres = before.colors.copy(), before.dots.centres.copy()
    ready.stroke([12, 2, 0])
    after = ready.editor.scene()
    assert after.colors is not before.colors
    assert after.dots is not None
    assert len(after.dots.centres) > len(centres)
    np.testing.assert_array_equal(before.colors, colors)
    np.testing.assert_array_equal(before.dots.centres, centres)
    assert after.positions is before.positions
    ready.use("drag")
    ready.do(c.SetMap("softness"))
    ready.stroke([19, 2, 0], [17, 6, 0])
    moved = ready.editor.scene()
    assert moved.positions is not before.positions
    assert moved.dots is not None
    np.testing.assert_array_equal(moved.dots.centres, moved.positions[ready.editor.document.pinned])


def test_pins_are_seen_with_the_softness_only(ready: Person) -> None:
    ready.use("softness", 2)
    assert ready.editor.scene().dots is None
    ready.stroke([10, 2, 0])
    assert ready.editor.scene().dots is not None
    ready.do(c.SetMap("roles"))
    assert ready.editor.scene().dots is None
    ready.do(c.SetMap("softness"))
    assert ready.editor.scene().dots is not None
    ready.do(c.ClearPins())
    assert ready.editor.scene().dots is None


def test_looks_change_one_by_one_and_nothing_of_the_document(ready: Person) -> None:
    before, done = state(ready.editor.document), len(ready.editor.history.done)
    ready.do(c.SetLooks(shading="flat"), c.SetLooks(edges=True))
    looks = ready.editor.scene().looks
    assert (looks.edges, looks.shading, looks.rest) == (True, "flat", False)
    assert (state(ready.editor.document), len(ready.editor.history.done)) == (before, done)
    ready.do(c.OpenMesh(DEFAULT_MESH))
    assert ready.editor.scene().looks == looks, "of the person, not of the mesh"


def test_the_ghost_is_the_rest_shape_just_below_the_surface(ready: Person) -> None:
    assert ready.editor.scene().ghost is None
    ready.do(c.SetLooks(rest=True))
    ghost = ready.editor.scene().ghost
    assert ghost is not None
    document = ready.editor.document
    V = document.mesh.vertices
    inside = (ghost > V.min(axis=0)) & (ghost < V.max(axis=0))
    assert inside.all(), "where nothing has moved the surface hides it"
    np.testing.assert_allclose(ghost, V, atol=1.1e-3 * document.diagonal)
    ready.stroke([19, 2, 0], [17, 6, 0])
    assert ready.editor.scene().ghost is ghost
    ready.do(c.SetLooks(rest=False))
    assert ready.editor.scene().ghost is None


@pytest.mark.parametrize("radius", [0.2, 1.5, 2.4])
def test_the_rim_of_the_brush_is_a_circle_on_the_surface(bar: Person, radius: float) -> None:
    bar.use("fixed", radius)
    for shift, color in ((False, PAINTING), (True, ERASING)):
        bar.frame([10.2, 2.3, 0], shift=shift)
        (outline,) = bar.editor.scene().overlay.outlines
        assert outline.color == color
        away = outline.segments - [10.2, 2.3, 0]
        np.testing.assert_allclose(np.linalg.norm(away, axis=2), radius, atol=1e-4)
        np.testing.assert_allclose(away[..., 2], 0, atol=1e-4)
        assert np.ptp(np.arctan2(away[..., 1], away[..., 0])) > 5, "all around"


def test_the_rim_shows_what_a_dab_takes(bar: Person) -> None:
    """At the edge of the bar it bends over, and what lies on the far side is outside."""
    bar.use("fixed", 1.7)
    place = [10.2, 0.4, 0.0]
    bar.frame(place)
    (outline,) = bar.editor.scene().overlay.outlines
    bar.stroke(place)
    taken = bar.editor.document.role == FIXED
    mesh = bar.editor.document.mesh
    top = np.flatnonzero(mesh.vertices[:, 2] == 0)
    away = np.linalg.norm(mesh.vertices[top] - place, axis=1)
    np.testing.assert_array_equal(taken[top], away < 1.7)
    ends = np.linalg.norm(outline.segments - place, axis=2)
    np.testing.assert_allclose(ends, 1.7, atol=1e-3)
    assert (outline.segments[..., 2] > -1e-6).all(), "what faces away is not drawn"


class Loop:
    """Notes where the cursor has been."""

    drags: ClassVar[bool] = False

    def __init__(self, press: Input) -> None:
        self.pixels: list[Pixel | None] = [press.pixel]

    def move(self, frame: Input) -> None:
        self.pixels.append(frame.pixel)

    def finish(self) -> None:
        pass

    def cancel(self) -> None:
        pass


def test_a_tool_may_begin_beside_the_surface_and_draw_where_it_has_been(
    bar: Person, monkeypatch: pytest.MonkeyPatch
) -> None:
    loops: list[Loop] = []

    def begin(work: Workspace, press: Input) -> Loop:
        loops.append(Loop(press))
        return loops[-1]

    def line(work: Workspace, frame: Input) -> Overlay:
        rays = [frame.camera.ray(pixel) for loop in loops for pixel in loop.pixels if pixel]
        corners = np.array([ray.at(1.0) for ray in rays])
        return Overlay((Outline.through(corners, PAINTING, closed=False),))

    monkeypatch.setitem(TOOLS, "lasso", Tool("Lasso", "6", begin, line))
    bar.use("lasso")
    for count, _ in enumerate(bar.hold([[-3, -3, 0], [24, -3, 0], [24, 7, 0]]), start=1):
        assert bar.editor.captures
        (outline,) = bar.editor.scene().overlay.outlines
        assert outline.segments.shape == (count - 1, 2, 3)
    bar.frame(None, "r")
    assert not bar.editor.captures
    assert len(loops) == 1
    assert all(pixel is not None for pixel in loops[0].pixels[:3])


def test_the_rest_shape_can_be_drawn_in_place_of_the_surface(ready: Person) -> None:
    ready.use("softness", 3)
    ready.stroke([10, 2, 0])
    ready.use("drag")
    ready.stroke([19, 2, 0], [12, 8, 0])
    ready.use("softness")
    editor = ready.editor
    ready.frame([12, 8, 0])
    before, shown = state(editor.document), editor.scene()
    rest = editor.scene(rest=True)
    assert rest.positions is editor.document.mesh.vertices
    assert rest.overlay == NOTHING
    assert rest.dots is not None
    assert shown.dots is not None
    pinned = editor.document.mesh.vertices[editor.document.pinned]
    np.testing.assert_array_equal(rest.dots.centres, pinned)
    after = editor.scene()
    assert after.dots is not None
    assert after.positions is shown.positions
    np.testing.assert_array_equal(after.dots.centres, shown.dots.centres)
    assert state(editor.document) == before
