"""Kept poses: the list, going there, and the slider between two of them."""

from __future__ import annotations

import numpy as np
import pytest

from app.editor import commands as c
from app.model.handles import Pose
from app.model.poses import REST
from app.worker.service import bind
from app.worker.snapshot import bind_request
from solver.geometry.motions import motion, moved, rotation
from solver.types import FloatArray
from tests.app.person import Person, error_of, state


def names(person: Person) -> list[str]:
    return [kept.name for kept in person.editor.document.poses]


def key(person: Person, name: str) -> int:
    return next(kept.key for kept in person.editor.document.poses if kept.name == name)


def transform(person: Person) -> FloatArray:
    document = person.editor.document
    return document.pose.of(document.handles[0].key)


def bend(person: Person, T: FloatArray) -> None:
    """Put the handle of the bar there, as a drag would."""
    document = person.editor.document
    with person.editor.edit("Drag") as gesture:
        gesture.change("pose", document.pose.moved(document.handles[0].key, T))


@pytest.fixture
def two(ready: Person) -> Person:
    """The bar with a pose "up", dragged, and a pose "turned"; at "turned" now."""
    ready.stroke([19, 2, 0], [16, 8, 0])
    ready.do(c.KeepPose(" up "))
    bend(ready, motion(rotation([0, 0, 1], 100), [1.0, 2, 3], centre=[19.0, 2, -1]))
    ready.do(c.KeepPose("turned"))
    return ready


def test_a_kept_pose_is_gone_back_to_bit_for_bit(two: Person) -> None:
    document = two.editor.document
    turned, at = document.pose, two.editor.positions
    two.do(c.GoToPose(REST))
    np.testing.assert_array_equal(two.editor.positions, document.mesh.vertices)
    two.do(c.GoToPose(key(two, "up")))
    assert document.pose != turned
    two.do(c.GoToPose(key(two, "turned")))
    assert document.pose == turned
    np.testing.assert_allclose(two.editor.positions, at, atol=1e-9)
    entries = len(two.editor.history.done)
    two.do(c.GoToPose(key(two, "turned")))
    assert len(two.editor.history.done) == entries, "nothing to undo where nothing changed"


def test_names_are_proposed_and_free(ready: Person) -> None:
    ready.do(c.KeepPose(), c.KeepPose(), c.KeepPose())
    ready.do(c.DeletePose(key(ready, "pose 2")), c.KeepPose())
    assert names(ready) == ["pose 1", "pose 3", "pose 2"]
    ready.do(c.DuplicatePose(key(ready, "pose 1")), c.DuplicatePose(key(ready, "pose 1")))
    assert names(ready) == ["pose 1", "pose 1 3", "pose 1 2", "pose 3", "pose 2"]


def test_the_list_is_ordered_renamed_and_shortened(two: Person) -> None:
    two.do(c.MovePose(key(two, "turned"), -1))
    assert names(two) == ["turned", "up"]
    two.do(c.MovePose(key(two, "turned"), -1), c.MovePose(key(two, "up"), 1))
    assert names(two) == ["turned", "up"], "at its end already"
    two.do(c.RenamePose(key(two, "up"), " fist "))
    assert names(two) == ["turned", "fist"]
    two.do(c.DeletePose(key(two, "turned")))
    assert names(two) == ["fist"]


def test_a_kept_pose_takes_the_pose_of_now(two: Person) -> None:
    document = two.editor.document
    two.do(c.GoToPose(key(two, "up")), c.ReplacePose(key(two, "turned")), c.GoToPose(REST))
    two.do(c.GoToPose(key(two, "turned")))
    assert document.pose == document.poses[0].pose
    assert not document.pose.at_rest


def test_everything_about_the_list_is_undone_and_done_again(two: Person) -> None:
    document = two.editor.document
    for command in (
        c.KeepPose("third"),
        c.RenamePose(key(two, "up"), "fist"),
        c.MovePose(key(two, "turned"), -1),
        c.DuplicatePose(key(two, "turned")),
        c.DeletePose(key(two, "turned")),
        c.GoToPose(REST),
        c.ReplacePose(key(two, "up")),
    ):
        before, entries = state(document), len(two.editor.history.done)
        two.do(command)
        after = state(document)
        assert after != before, command
        assert len(two.editor.history.done) == entries + 1, command
        two.do(c.Undo())
        assert state(document) == before, command
        two.do(c.Redo())
        assert state(document) == after, command


WRONG = [
    (c.KeepPose("up"), "another pose is called 'up', expected another name"),
    (c.RenamePose(1, "turned"), "another pose is called 'turned'"),
    (c.RenamePose(1, " "), "a pose's name must not be empty"),
    (c.GoToPose(99), "no kept pose with key 99"),
    (c.DeletePose(REST), "no kept pose with key 0"),
    (c.RenamePose(99, "a"), "no kept pose with key 99"),
    (c.BlendPoses(REST, 99, 0.5), "no kept pose with key 99"),
    (c.BlendPoses(REST, 1, float("nan")), "share of a blend must be a number, got nan"),
    (c.ChooseBlend(start=99), "no kept pose with key 99"),
    (c.ChooseBlend(between=-1), "shapes between two poses must be 0 to 100, got -1"),
]


@pytest.mark.parametrize(("command", "text"), WRONG, ids=[repr(w[0]) for w in WRONG])
def test_what_is_wrong_is_a_message(two: Person, command: c.Command, text: str) -> None:
    before, entries = state(two.editor.document), len(two.editor.history.done)
    two.do(command)
    assert text in error_of(two)
    assert state(two.editor.document) == before
    assert len(two.editor.history.done) == entries


def slide(person: Person, *shares: float) -> None:
    """Hold the mouse on the slider from "up" to "turned" and let it go."""
    for share in shares:
        person.frame(None, "d")
        person.do(c.BlendPoses(key(person, "up"), key(person, "turned"), share))
    person.frame(None, "r")


def test_a_slide_is_one_entry_and_ends_exactly_at_both_poses(two: Person) -> None:
    document = two.editor.document
    up, turned = (kept.pose for kept in document.poses)
    entries, before = len(two.editor.history.done), state(document)
    slide(two, 0.9, 0.5, 0.0)
    assert document.pose == up
    slide(two, 0.2, 1.0, 2.0)
    assert document.pose == turned
    assert len(two.editor.history.done) == entries + 2
    two.do(c.Undo(), c.Undo())
    assert state(document) == before
    slide(two, 0.5, 1.0)  # there and back
    assert len(two.editor.history.done) == entries


def test_what_is_between_is_the_equilibrium_of_a_handle_on_its_screw(two: Person) -> None:
    document = two.editor.document
    bend(two, np.eye(4))
    slide(two, 0.3, 0.5)
    A, B = (kept.pose.of(document.handles[0].key) for kept in document.poses)
    half = transform(two)
    step = half @ np.linalg.inv(A)
    np.testing.assert_allclose(step @ step @ A, B, atol=1e-9)
    held = document.vertices_of(document.handles[0].key)
    expected = moved(half, document.mesh.vertices[held])
    np.testing.assert_allclose(two.editor.positions[held], expected, atol=1e-9)
    solved = bind(bind_request(document)).pose([half], rigid=document.rigid)
    np.testing.assert_allclose(two.editor.positions, solved, atol=1e-9)


def test_a_handle_that_grows_about_its_middle_keeps_its_middle(ready: Person) -> None:
    document = ready.editor.document
    centre = document.handle_centres()[document.handles[0].key]
    bend(ready, motion(2.0 * rotation([0, 0, 1], 90), centre=centre))
    ready.do(c.KeepPose("large"))
    ready.do(c.BlendPoses(REST, key(ready, "large"), 0.5))
    np.testing.assert_allclose(moved(transform(ready), centre[None])[0], centre, atol=1e-12)
    expected = 1.5 * rotation([0, 0, 1], 45)
    np.testing.assert_allclose(transform(ready)[:3, :3], expected, atol=1e-12)


def test_the_first_kept_pose_is_what_the_slider_leads_to(ready: Person) -> None:
    assert (ready.editor.blend.start, ready.editor.blend.end) == (REST, REST)
    ready.do(c.KeepPose("a"), c.KeepPose("b"))
    assert ready.editor.blend.end == key(ready, "a")
    ready.do(c.ChooseBlend(start=key(ready, "b"), between=3))
    assert (ready.editor.blend.start, ready.editor.blend.end) == (key(ready, "b"), key(ready, "a"))
    assert ready.editor.blend.between == 3


def test_removing_a_handle_takes_it_out_of_kept_poses_and_undo_brings_it_back(two: Person) -> None:
    document = two.editor.document
    before, kept = state(document), document.poses
    two.do(c.RemoveHandle(document.handles[0].key))
    assert all(not pose.pose.transforms for pose in document.poses)
    assert names(two) == ["up", "turned"]
    two.do(c.Undo())
    assert state(document) == before
    assert document.poses == kept


def test_a_pose_keeps_its_meaning_when_its_handle_is_painted_larger(two: Person) -> None:
    document = two.editor.document
    handle = document.handles[0].key
    two.do(c.GoToPose(REST))
    fewer = document.vertices_of(handle)
    two.use("handle", 2.5)
    two.stroke([18, 0, 0], [18, 4, 0])
    more = document.vertices_of(handle)
    assert len(more) > len(fewer)
    two.do(c.GoToPose(key(two, "turned")))
    expected = moved(document.poses[1].pose.of(handle), document.mesh.vertices[more])
    np.testing.assert_allclose(two.editor.positions[more], expected, atol=1e-9)


def test_a_handle_painted_later_is_at_rest_in_the_poses_before(two: Person) -> None:
    two.do(c.GoToPose(REST), c.AddHandle("second"))
    two.use("handle", 1.6)
    two.stroke([10, 0, 0])
    two.do(c.GoToPose(key(two, "turned")))
    document = two.editor.document
    second = document.vertices_of(document.handles[1].key)
    assert len(second)
    np.testing.assert_array_equal(two.editor.positions[second], document.mesh.vertices[second])
    assert document.pose.of(document.handles[1].key).tolist() == np.eye(4).tolist()
    assert document.pose != Pose()
