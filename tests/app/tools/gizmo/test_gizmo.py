"""The gizmo under a scripted hand: what a press on each of its parts does."""

from __future__ import annotations

import numpy as np
import pytest

from app.editor import commands as c
from app.tools.gizmo.shape import BALL
from solver.geometry.motions import motion, rotation, rotation_about
from tests.app.person import Person, state, transforms
from tests.app.tools.dragging import check_constraints
from tests.app.tools.gizmo.hand import BESIDE, at, check_one_entry, label, pivot


@pytest.mark.parametrize("way", [60.0, -100.0, 250.0, 400.0])
def test_a_ring_follows_the_cursor_around(ready: Person, way: float) -> None:
    before, entries = state(ready.editor.document), len(ready.editor.history.done)
    expected = rotation_about([0, 0, 1], way, pivot(ready))
    path = [at(ready, 1, angle) for angle in 40 + np.linspace(0, way, 9)]
    for _ in ready.hold(path):
        check_constraints(ready)
    assert label(ready) == f"z {way:.1f}°"
    assert ready.editor.dragging
    ready.frame(path[-1], "r")
    np.testing.assert_allclose(transforms(ready.editor.document)[0], expected, atol=1e-4)
    check_one_entry(ready, before, entries, "Turn handle 1")


def test_an_arrow_moves_along_its_axis_only(ready: Person) -> None:
    start = at(ready, 1.3, 90)
    ready.stroke(start, start + [0, 2, 0])
    (T,) = transforms(ready.editor.document)
    np.testing.assert_allclose(T, motion(np.eye(3), [0, 2, 0]), atol=1e-4)
    start = at(ready, 1.3, 90)
    ready.stroke(start, start + [3, 2, 0])
    (T,) = transforms(ready.editor.document)
    assert (T[0, 3], T[2, 3]) == (0, 0)
    assert T[1, 3] == pytest.approx(4, abs=0.2)


def test_the_circle_turns_freely(ready: Person) -> None:
    start = at(ready, BALL, 45)
    ready.stroke(start, start + [2, 0, 0])
    R = transforms(ready.editor.document)[0][:3, :3]
    assert R[0, 2] > 0.1, "the front goes to the right"
    np.testing.assert_allclose(R @ [0, 1, 0], [0, 1, 0], atol=1e-9)


def test_a_press_on_the_gizmo_that_goes_nowhere_leaves_nothing(ready: Person) -> None:
    before, entries = state(ready.editor.document), len(ready.editor.history.done)
    ready.stroke(at(ready, 1, 40))
    assert state(ready.editor.document) == before
    assert len(ready.editor.history.done) == entries


def test_a_number_typed_while_a_ring_is_held_sets_it(ready: Person) -> None:
    expected = rotation_about([0, 0, 1], -30, pivot(ready))
    start, end = at(ready, 1, 40), at(ready, 1, 70)
    for _ in ready.hold([start, end]):
        pass
    for key in "-30":
        ready.frame(end, "d", typed=key)
    assert label(ready) == "z -30°"
    ready.frame(end, "r")
    np.testing.assert_allclose(transforms(ready.editor.document)[0], expected, atol=1e-12)


def test_ctrl_rounds_angles_and_distances(ready: Person) -> None:
    end = at(ready, 1, 40 + 52)
    start = at(ready, 1, 40)
    ready.frame(start, "pd")
    ready.frame(end, "d", ctrl=True)
    assert label(ready) == "z 45.0°"
    ready.frame(end, "r", ctrl=True)
    ready.frame([12.0, 9.13, 0])
    ready.do(c.Undo(), c.MoveHandles())
    ready.frame([13.53, 9.13, 0], typed="x", ctrl=True)
    ready.frame([13.53, 9.13, 0], ctrl=True)
    step = 0.2  # a round hundredth of the diagonal
    moved_by = transforms(ready.editor.document)[0][:3, 3]
    assert moved_by[0] > 0
    np.testing.assert_allclose(moved_by / step, np.rint(moved_by / step), atol=1e-9)
    ready.do(c.CancelGesture())


def test_the_gizmo_shows_with_the_drag_tool_only_and_can_be_switched_off(ready: Person) -> None:
    def shown() -> bool:
        ready.frame(BESIDE)
        return bool(ready.editor.cursor.outlines)

    assert shown()
    ready.use("fixed")
    assert not shown()
    ready.use("drag")
    ready.do(c.SetPlacing(gizmo=False))
    assert not shown()
    ready.frame(at(ready, 1, 40), "pd")
    assert not ready.editor.captures
    ready.frame(None, "r")


def test_local_axes_turn_with_the_handle(ready: Person) -> None:
    ready.do(c.SetPlacing(axes="local"), c.SetRotation(2, (0.0, 0.0, 30.0)))
    (T,) = transforms(ready.editor.document)
    start = at(ready, 1.3, 30)  # the handle's own x arrow
    ready.stroke(start, start + 2 * rotation([0, 0, 1], 30)[:, 0])
    shift = transforms(ready.editor.document)[0][:3, 3] - T[:3, 3]
    np.testing.assert_allclose(shift, 2 * rotation([0, 0, 1], 30)[:, 0], atol=1e-4)
