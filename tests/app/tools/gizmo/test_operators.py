"""G and R: handles that follow the mouse without a button, and the keys that say how far."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from app.editor import commands as c
from app.tools.gizmo.shape import Y_COLOR
from solver.geometry.motions import motion, rotation, rotation_about
from tests.app.person import Person, state, transforms
from tests.app.tools.dragging import check_constraints
from tests.app.tools.gizmo.hand import BESIDE, check_one_entry, label, lines, pivot, type_in


def test_a_handle_turned_by_a_quarter_is_saved_as_one(ready: Person, tmp_path: Path) -> None:
    before, entries = state(ready.editor.document), len(ready.editor.history.done)
    centre = pivot(ready)
    ready.frame(BESIDE)
    ready.do(c.TurnHandles())
    type_in(ready, "z90\n")
    assert ready.editor.interaction is None
    check_constraints(ready)
    ready.do(c.SaveSession(tmp_path / "bar.json"))
    (handle,) = json.loads((tmp_path / "bar.json").read_text())["handles"]
    T = np.array(handle["transform"])
    expected = rotation_about([0, 0, 1], 90, centre)
    np.testing.assert_allclose(T, expected, rtol=0, atol=1e-9)
    np.testing.assert_allclose(pivot(ready), centre)
    check_one_entry(ready, before, entries, "Turn handle 1")


def test_an_operator_follows_the_mouse_without_a_button(ready: Person) -> None:
    before, entries = state(ready.editor.document), len(ready.editor.history.done)
    depth = pivot(ready)[2]
    start = np.array([12.0, 9.0, depth])
    ready.frame(start)
    ready.do(c.MoveHandles())
    ready.frame(start + [1, 2, 0])
    ready.frame(start + [2, 3, 0])
    check_constraints(ready)
    np.testing.assert_allclose(
        transforms(ready.editor.document)[0], motion(np.eye(3), [2, 3, 0]), atol=1e-4
    )
    ready.frame(start + [2, 3, 0], "pd")
    assert not ready.editor.captures
    camera = ready.editor.viewpoint.camera
    ready.frame(start + [4, 5, 0], "d")
    np.testing.assert_array_equal(ready.editor.viewpoint.camera.position, camera.position)
    ready.frame(start + [4, 5, 0], "r")
    np.testing.assert_allclose(
        transforms(ready.editor.document)[0], motion(np.eye(3), [2, 3, 0]), atol=1e-4
    )
    check_one_entry(ready, before, entries, "Move handle 1")


@pytest.mark.parametrize("how", ["escape", "right button"])
def test_what_is_taken_back_is_restored_exactly(ready: Person, how: str) -> None:
    ready.stroke([19, 2, 0], [16, 8, 0])
    before, entries = state(ready.editor.document), len(ready.editor.history.done)
    positions = ready.editor.positions
    ready.frame(BESIDE)
    ready.do(c.TurnHandles())
    ready.frame(BESIDE + [-4, 3, 0])
    type_in(ready, "x12.5")
    assert state(ready.editor.document) != before
    eye = ready.editor.viewpoint.camera.position
    if how == "escape":
        ready.do(c.CancelGesture())
    else:
        ready.frame(BESIDE, "s")
        assert ready.editor.interaction is None
        ready.frame(BESIDE + [3, 3, 0], "s")
        np.testing.assert_array_equal(ready.editor.viewpoint.camera.position, eye)
    ready.frame(BESIDE)
    assert state(ready.editor.document) == before
    assert len(ready.editor.history.done) == entries
    np.testing.assert_array_equal(ready.editor.positions, positions)


def test_an_axis_is_of_the_world_then_the_handles_own_then_none(ready: Person) -> None:
    ready.frame(BESIDE)
    ready.do(c.SetRotation(2, (0.0, 0.0, 90.0)))
    (T,) = transforms(ready.editor.document)
    ready.do(c.MoveHandles())
    type_in(ready, "x3")
    (world,) = transforms(ready.editor.document)
    np.testing.assert_allclose(world, motion(np.eye(3), [3, 0, 0]) @ T, atol=1e-9)
    type_in(ready, "x")
    (local,) = transforms(ready.editor.document)
    np.testing.assert_allclose(local, motion(np.eye(3), [0, 3, 0]) @ T, atol=1e-9)
    type_in(ready, "\b")
    assert label(ready) == "x 0"
    type_in(ready, "x")
    ready.frame(BESIDE + [1, 1, 0])
    (free,) = transforms(ready.editor.document)
    assert (free[:2, 3] > T[:2, 3] + 0.5).all()
    ready.do(c.CancelGesture())
    np.testing.assert_array_equal(transforms(ready.editor.document)[0], T)


def test_the_locked_axis_shows_as_a_line(ready: Person) -> None:
    ready.frame(BESIDE)
    ready.do(c.MoveHandles())
    ready.frame(BESIDE)
    assert not lines(ready)
    type_in(ready, "y")
    (line,) = lines(ready)
    ends = line.segments.reshape(-1, 3)
    np.testing.assert_allclose(ends[:, [0, 2]] - pivot(ready)[[0, 2]], 0, atol=1e-9)
    assert line.color == Y_COLOR
    ready.do(c.CancelGesture(), c.TurnHandles())
    type_in(ready, "y")
    assert len(lines(ready)) == 2, "and a ring about it"
    ready.do(c.CancelGesture())


def test_an_axis_named_late_takes_what_the_cursor_went(ready: Person) -> None:
    ready.frame(BESIDE)
    ready.do(c.MoveHandles())
    ready.frame(BESIDE + [2, 3, 0])
    ready.frame(BESIDE + [2, 3, 0], typed="y")
    x, y, z = transforms(ready.editor.document)[0][:3, 3]
    assert (x, z) == (0, 0)
    assert y == pytest.approx(3, rel=0.05)
    ready.do(c.CancelGesture())


def test_the_camera_moves_while_an_operator_goes_on(ready: Person) -> None:
    ready.frame(BESIDE)
    ready.do(c.MoveHandles())
    ready.frame(BESIDE + [1, 0, 0])
    (T,) = transforms(ready.editor.document)
    eye = ready.editor.viewpoint.camera.position
    ready.frame(BESIDE + [1, 0, 0], "m")
    ready.frame(BESIDE + [5, 5, 0], "m")
    assert np.linalg.norm(ready.editor.viewpoint.camera.position - eye) > 1
    ready.frame(BESIDE + [5, 5, 0])
    assert ready.editor.captures
    np.testing.assert_array_equal(transforms(ready.editor.document)[0], T)
    ready.frame(BESIDE + [5, 6, 0], typed="\n")
    assert transforms(ready.editor.document)[0][1, 3] > T[1, 3] + 0.5


def test_there_must_be_something_to_place(bar: Person) -> None:
    for command in (c.MoveHandles(), c.TurnHandles(), c.PickPivot(), c.SetPosition(0, 1.0)):
        bar.do(command)
        assert bar.editor.message is not None
        assert bar.editor.message.text == "there is nothing to move: paint a handle first"
        assert bar.editor.interaction is None


def test_a_turned_handle_whose_place_follows_goes_where_the_surface_takes_it(
    ready: Person,
) -> None:
    before, entries = state(ready.editor.document), len(ready.editor.history.done)
    ready.do(c.SetPlacing(pivot="free"))
    ready.frame(BESIDE)
    ready.do(c.TurnHandles())
    type_in(ready, "z40\n")
    (T,) = transforms(ready.editor.document)
    np.testing.assert_allclose(T[:3, :3], rotation([0, 0, 1], 40), atol=1e-12)
    centre = pivot(ready)
    check_constraints(ready)
    check_one_entry(ready, before, entries, "Turn handle 1")
    assert centre[1] > pivot(ready)[1] + 2, "the bar bends towards where its end looks"
    ready.do(c.SetRotation(2, (0.0, 0.0, 40.0)))
    np.testing.assert_allclose(transforms(ready.editor.document)[0], T, atol=1e-9)
    ready.do(c.Undo(), c.MoveHandles())
    type_in(ready, "y1\n")
    np.testing.assert_array_equal(
        transforms(ready.editor.document)[0], motion(np.eye(3), [0, 1, 0])
    )
