"""Handles turned and moved exactly: by the gizmo, by G and R, about a pivot, several at once."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from app.editor import commands as c
from app.model.handles import FREE, Handle
from app.tools.gizmo.shape import BALL, RADIUS, Y_COLOR
from app.workspace.overlay import Outline
from solver.geometry.motions import from_euler_angles, motion, moved, rotation, rotation_about
from solver.types import FloatArray
from tests.app.person import Person, state, transforms
from tests.app.tools.dragging import check_constraints

# The person looks from above: the ring about z is a circle, x to the right, y up.
BESIDE = np.array([12.0, 9.0, 0.0])


def pivot(person: Person) -> FloatArray:
    found = person.editor.pivot
    assert found is not None
    return found


def at(person: Person, radii: float, degrees: float) -> FloatArray:
    """A point of the pivot's height, so many radii of the gizmo's rings away from it."""
    person.frame(BESIDE)  # so that the camera is the person's
    reach = radii * RADIUS * person.editor.viewpoint.camera.units_per_pixel(pivot(person))
    angle = np.radians(degrees)
    return pivot(person) + reach * np.array([np.cos(angle), np.sin(angle), 0])


def type_in(person: Person, keys: str) -> None:
    for key in keys:
        person.frame(BESIDE, typed=key)


def label(person: Person) -> str:
    (found,) = person.editor.cursor.labels
    return found.text


def lines(person: Person) -> tuple[Outline, ...]:
    return person.editor.cursor.outlines


def check_one_entry(person: Person, before: tuple[object, ...], count: int, name: str) -> None:
    """What was done is one step, and undone exactly."""
    history = person.editor.history
    assert [entry.label for entry in history.done[count:]] == [name]
    person.do(c.Undo())
    assert state(person.editor.document) == before


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


def test_a_handle_turned_about_its_joint_keeps_the_joint_in_place(ready: Person) -> None:
    ready.use("handle", 4.2)
    ready.stroke([20, 0, 0], [20, 4, 0])
    ready.use("drag")
    ready.do(c.SetPlacing(pivot="joint"), c.SetSetting("rigid", 0))
    document = ready.editor.document
    key, edges = document.handles[0].key, ready.editor.neighbours.edges
    both = np.concatenate([edges, edges[:, ::-1]])
    role = document.role[both]
    border = np.unique(both[(role[:, 0] == key) & (role[:, 1] == FREE), 0])
    joint = ready.editor.positions[border].mean(axis=0)
    for kind, keys in ((c.TurnHandles(), "y70\n"), (c.TurnHandles(), "z-25\n")):
        ready.do(kind)
        type_in(ready, keys)
    ready.editor.settle()
    np.testing.assert_allclose(ready.editor.positions[border].mean(axis=0), joint, atol=1e-9)
    check_constraints(ready)
    assert np.abs(ready.editor.positions[border] - document.mesh.vertices[border]).max() > 1


def test_a_picked_point_is_what_a_handle_turns_about_and_goes_with_it(ready: Person) -> None:
    ready.do(c.PickPivot())
    ready.frame([14, 2, 0])
    assert "Click" in label(ready)
    ready.frame([14, 2, 0], "pd")
    ready.frame([14, 2, 0], "r")
    np.testing.assert_allclose(pivot(ready), [14, 2, 0], atol=1e-3)
    point = pivot(ready)
    ready.do(c.SetRotation(2, (0.0, 0.0, 40.0)))
    np.testing.assert_allclose(pivot(ready), point, atol=1e-9)
    ready.do(c.SetPosition(0, 12.5))
    np.testing.assert_allclose(pivot(ready), [12.5, *point[1:]], atol=1e-9)
    ready.do(c.PickPivot())
    ready.frame([30, 30, 0], "pd")  # beside the surface: as it was
    np.testing.assert_allclose(pivot(ready), [12.5, *point[1:]], atol=1e-9)


def test_numbers_place_a_handle_exactly_and_are_one_step_each(ready: Person) -> None:
    entries = len(ready.editor.history.done)
    start = pivot(ready)
    for x in (20.5, 21.25, 22.0):  # a field that is dragged
        ready.do(c.SetPosition(0, x))
    ready.frame(BESIDE, "r")
    for angle in (10.0, 90.0):
        ready.do(c.SetRotation(1, (0.0, angle, 0.0)))
    ready.do(c.SetRotation(2, (0.0, 90.0, 15.0)))
    assert len(ready.editor.history.done) == entries + 3
    R = from_euler_angles([0, 90, 15])
    np.testing.assert_allclose(transforms(ready.editor.document)[0][:3, :3], R, atol=1e-12)
    np.testing.assert_allclose(pivot(ready), [22.0, *start[1:]], atol=1e-12)


def two_handles(person: Person) -> None:
    """One more handle, in the middle of the bar; both are selected, the first is active."""
    person.do(c.AddHandle("middle"))
    person.use("handle", 1.2)
    person.stroke([10, 2, 0])
    person.editor.settle()
    person.use("drag")
    person.do(c.SelectHandle(person.editor.document.handles[0].key))


def test_selected_handles_move_as_one_about_a_common_pivot(ready: Person) -> None:
    two_handles(ready)
    document = ready.editor.document
    before, entries = state(document), len(ready.editor.history.done)
    rest = document.mesh.vertices
    both = np.concatenate([document.vertices_of(handle.key) for handle in document.handles])
    centre = rest[both].mean(axis=0)
    np.testing.assert_allclose(pivot(ready), centre)
    ready.do(c.TurnHandles())
    type_in(ready, "z90\n")
    T = rotation_about([0, 0, 1], 90, centre)
    for transform in transforms(document):
        np.testing.assert_allclose(transform, T, atol=1e-12)
    np.testing.assert_allclose(ready.editor.positions[both], moved(T, rest[both]), atol=1e-9)
    check_one_entry(ready, before, entries, "Turn 2 handles")
    ready.do(c.SetPosition(1, centre[1] + 2))
    for transform in transforms(document):
        np.testing.assert_allclose(transform, motion(np.eye(3), [0, 2, 0]), atol=1e-12)


def test_ctrl_click_in_the_scene_selects(ready: Person) -> None:
    two_handles(ready)
    editor = ready.editor
    first, second = editor.document.handles
    ready.do(c.SetPlacing(gizmo=False), c.ActivateHandle(first.key))
    before = state(editor.document)

    def selected() -> list[Handle]:
        return list(editor.selected)

    def ctrl_click(x: float) -> None:
        ready.frame([x, 2, 0], "pd", ctrl=True)
        ready.frame([x + 1, 2, 0], "d", ctrl=True)
        ready.frame([x + 1, 2, 0], "r", ctrl=True)

    assert selected() == [first]
    ctrl_click(10)
    assert selected() == [second, first]
    assert editor.active == second
    ctrl_click(10)
    assert selected() == [first]
    ctrl_click(19)
    assert selected() == [first], "the last one stays"
    ctrl_click(10)
    ready.stroke([19, 2, 0])
    assert selected() == [first, second], "a press keeps a selection that holds it"
    assert state(editor.document) == before
    ready.do(c.RemoveHandle(second.key))
    assert selected() == [first]


def test_one_handle_is_reset_and_the_other_stays(ready: Person) -> None:
    two_handles(ready)
    ready.do(c.SetPosition(2, 3.0))
    first, second = ready.editor.document.handles
    ready.do(c.ResetHandle(first.key))
    pose = ready.editor.document.pose
    np.testing.assert_array_equal(pose.of(first.key), np.eye(4))
    assert not np.array_equal(pose.of(second.key), np.eye(4))
    assert ready.editor.history.done[-1].label == "Reset handle 1"


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


def test_there_must_be_something_to_place(bar: Person) -> None:
    for command in (c.MoveHandles(), c.TurnHandles(), c.PickPivot(), c.SetPosition(0, 1.0)):
        bar.do(command)
        assert bar.editor.message is not None
        assert bar.editor.message.text == "there is nothing to move: paint a handle first"
        assert bar.editor.interaction is None


def test_a_transform_that_flattens_can_still_be_placed(ready: Person) -> None:
    """Session files may hold such transforms."""
    document = ready.editor.document
    flat = np.diag([1.0, 1.0, 0.0, 1.0])
    document.change("pose", document.pose.moved(document.handles[0].key, flat))
    ready.do(c.SetPlacing(axes="local"), c.SetRotation(0, (90.0, 0.0, 0.0)))
    (T,) = transforms(document)
    np.testing.assert_allclose(T[:3, :3], rotation([1, 0, 0], 90) @ flat[:3, :3], atol=1e-12)


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
