"""Pivots, numbers in the panel, several handles at once."""

from __future__ import annotations

from collections.abc import Collection

import numpy as np
import pytest

from app.editor import commands as c
from app.model.handles import FREE, Handle, Pose
from app.scene.overlay import Overlay
from app.viewpoint.camera import FIELD_OF_VIEW, Camera
from app.viewpoint.events import Input
from solver.geometry.motions import from_euler_angles, motion, moved, rotation, rotation_about
from tests.app.person import Person, state, transforms
from tests.app.tools.dragging import check_constraints
from tests.app.tools.gizmo.hand import BESIDE, check_one_entry, label, pivot, type_in


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


def test_a_transform_that_flattens_can_still_be_placed(ready: Person) -> None:
    """Session files may hold such transforms."""
    document = ready.editor.document
    flat = np.diag([1.0, 1.0, 0.0, 1.0])
    document.change("pose", document.pose.moved(document.handles[0].key, flat))
    ready.do(c.SetPlacing(axes="local"), c.SetRotation(0, (90.0, 0.0, 0.0)))
    (T,) = transforms(document)
    np.testing.assert_allclose(T[:3, :3], rotation([1, 0, 0], 90) @ flat[:3, :3], atol=1e-12)


def test_a_place_that_follows_is_found_once_as_long_as_the_cursor_rests(
    ready: Person, monkeypatch: pytest.MonkeyPatch
) -> None:
    surface, asked = ready.editor.surface, []
    real = surface.placed

    def counted(pose: Pose, keys: Collection[int]) -> Pose:
        asked.append(keys)
        return real(pose, keys)

    monkeypatch.setattr(surface, "placed", counted)
    ready.frame(BESIDE)
    ready.do(c.SetPlacing(pivot="free"), c.TurnHandles())
    for _ in range(4):
        ready.frame(BESIDE, typed="")
    assert not asked, "it is not turned yet"
    type_in(ready, "z4")
    for _ in range(4):
        ready.frame(BESIDE, typed="")
    assert len(asked) == 1
    type_in(ready, "0\n")
    assert len(asked) == 2


def test_the_gizmo_is_made_anew_only_where_it_has_moved(ready: Person) -> None:
    camera = Camera.look_at(ready.eye, ready.centre, FIELD_OF_VIEW, (1280, 800))

    def seen() -> Overlay:
        ready.editor.step(Input((5.0, 5.0), camera))
        return ready.editor.cursor

    first = seen()
    assert seen() is first
    ready.do(c.SetPosition(1, 6.0))
    moved_up = seen()
    assert moved_up is not first
    assert moved_up.outlines[0].segments[..., 1].mean() > first.outlines[0].segments[..., 1].mean()
    ready.do(c.SetPlacing(axes="local"), c.SetRotation(2, (0.0, 0.0, 30.0)))
    assert seen() is not moved_up
