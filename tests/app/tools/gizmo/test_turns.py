"""How far a handle was turned is kept: more than once round, by undo, poses, mirror and files."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from app.editor import commands as c
from app.model.handles import FIXED
from app.model.poses import REST
from app.model.session.reading import read_session, to_document
from solver.types import FloatArray
from tests.app.person import Person, state
from tests.app.tools.gizmo.hand import at, check_one_entry, type_in


def turn(person: Person, place: int = 0) -> FloatArray:
    """(3,) degrees."""
    document = person.editor.document
    return np.degrees(document.pose.turn(document.handles[place].key))


def check_turn(person: Person, expected: list[float], place: int = 0) -> None:
    np.testing.assert_allclose(turn(person, place), expected, atol=1e-3)


def turn_by(person: Person, keys: str) -> None:
    person.do(c.TurnHandles())
    type_in(person, f"{keys}\n")


@pytest.mark.parametrize("pivot", ["centre", "joint", "free"])
def test_a_typed_turn_may_be_more_than_once_round(ready: Person, pivot: str) -> None:
    before, entries = state(ready.editor.document), len(ready.editor.history.done)
    ready.do(c.SetPlacing(pivot=pivot))
    turn_by(ready, "x540")
    check_turn(ready, [540, 0, 0])
    check_one_entry(ready, before, entries, "Turn handle 1")
    ready.do(c.Redo())
    check_turn(ready, [540, 0, 0])
    turn_by(ready, "x-90")
    turn_by(ready, "x-460")
    check_turn(ready, [-10, 0, 0])


def test_a_ring_that_is_followed_round_counts(ready: Person) -> None:
    ready.stroke(*(at(ready, 1, angle) for angle in 40 + np.linspace(0, -400, 9)))
    check_turn(ready, [0, 0, -400])


def test_once_round_is_a_step_of_undo(ready: Person) -> None:
    before, entries = state(ready.editor.document), len(ready.editor.history.done)
    turn_by(ready, "z360")
    check_turn(ready, [0, 0, 360])
    check_one_entry(ready, before, entries, "Turn handle 1")


def test_numbers_in_the_panel_go_on_from_where_they_are(ready: Person) -> None:
    for angle in (90.0, 170.0, -170.0, -100.0):  # on through 180
        ready.do(c.SetRotation(1, (0.0, angle, 0.0)))
    check_turn(ready, [0, 260, 0])


def test_a_drag_goes_on_from_where_it_is(ready: Person) -> None:
    ready.do(c.SetTurn(False))
    turn_by(ready, "x300")
    ready.do(c.SetPlacing(gizmo=False))
    ready.stroke([19, 2, 0], [18, 5, 0])
    check_turn(ready, [300, 0, 0])


def test_poses_keep_turns_and_a_new_rest_shape_takes_them_away(ready: Person) -> None:
    turn_by(ready, "x450")
    ready.do(c.KeepPose("twisted"), c.ResetPose())
    check_turn(ready, [0, 0, 0])
    (kept,) = ready.editor.document.poses
    ready.do(c.GoToPose(kept.key))
    check_turn(ready, [450, 0, 0])
    turn_by(ready, "x30")
    ready.do(c.MakeRest())
    check_turn(ready, [0, 0, 0])
    ready.do(c.GoToPose(kept.key))
    check_turn(ready, [-30, 0, 0])
    ready.do(c.ResetHandle(ready.editor.document.handles[0].key))
    check_turn(ready, [0, 0, 0])


@pytest.mark.parametrize(("keys", "half"), [("x540", 270), ("x-200", -100), ("x170", 85)])
def test_a_blend_goes_the_way_the_handle_was_turned(ready: Person, keys: str, half: float) -> None:
    turn_by(ready, keys)
    ready.do(c.KeepPose("twisted"), c.ResetPose())
    (kept,) = ready.editor.document.poses
    for share in (0.1, 0.5):
        ready.do(c.BlendPoses(REST, kept.key, share))
        check_turn(ready, [2 * share * half, 0, 0])
    ready.do(c.BlendPoses(REST, kept.key, 1.0))
    check_turn(ready, [2 * half, 0, 0])


def mirrored(bar: Person) -> Person:
    """The middle of a bar is fixed and both ends are handles, mirror images across x."""
    bar.do(c.SetSymmetry("x"))
    middle = np.abs(bar.editor.document.mesh.vertices[:, 0] - 10) < 2
    with bar.editor.edit("Fix the middle") as gesture:
        gesture.change("role", FIXED, np.flatnonzero(middle))
    bar.do(c.AddHandle("wing.L"))
    bar.use("handle", 1.5)
    bar.stroke([19, 0, 0], [19, 4, 0])
    bar.use("drag")
    bar.editor.settle()
    return bar


@pytest.mark.parametrize("pivot", ["centre", "free"])
def test_what_mirrors_a_handle_turns_the_other_way_as_far(bar: Person, pivot: str) -> None:
    person = mirrored(bar)
    person.do(c.SetPlacing(pivot=pivot))
    turn_by(person, "x30")
    turn_by(person, "z-400")
    first = turn(person)
    np.testing.assert_allclose(turn(person, 1), first * [1, -1, -1], atol=1e-6)
    assert np.linalg.norm(first) > 180
    pose, mirror = person.editor.document.pose, person.editor.symmetry
    assert mirror is not None
    one, two = (pose.of(handle.key) for handle in person.editor.document.handles)
    np.testing.assert_allclose(two, mirror.transform(one), atol=1e-12)
    turn_by(person, "z50")
    person.do(c.SetSymmetry("off"))
    turn_by(person, "z100")
    second = turn(person), turn(person, 1)
    person.do(c.MirrorPose())
    np.testing.assert_allclose(turn(person, 1), second[0] * [1, -1, -1], atol=1e-6)
    np.testing.assert_allclose(turn(person), second[1] * [1, -1, -1], atol=1e-6)


@pytest.mark.parametrize("keys", ["x540", "y-180", "z360", "z90", "x99999"])
def test_a_session_keeps_turns(ready: Person, tmp_path: Path, keys: str) -> None:
    ready.do(c.SetPlacing(pivot="free"))
    turn_by(ready, keys)
    ready.do(c.KeepPose("twisted"))
    path = tmp_path / "a.json"
    ready.do(c.SaveSession(path))
    document, session = ready.editor.document, read_session(path)
    (entry,) = session.data["handles"]
    pose = document.pose
    np.testing.assert_array_equal(entry["turn"], pose.turn(document.handles[0].key))
    again = to_document(session, document.mesh, path)
    for old, new in ((pose, again.pose), (document.poses[0].pose, again.poses[0].pose)):
        np.testing.assert_allclose(
            new.turn(again.handles[0].key), old.turn(document.handles[0].key), atol=1e-12
        )


def test_a_handle_that_is_not_turned_has_no_turn_in_a_session(
    ready: Person, tmp_path: Path
) -> None:
    ready.do(c.SetPosition(1, 5.0), c.KeepPose(), c.SaveSession(tmp_path / "a.json"))
    data = read_session(tmp_path / "a.json").data
    assert "turn" not in data["handles"][0]
    assert "turns" not in data["poses"][0]
