"""Another rest shape: what stays where it is, what leads there, and the way back."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from app.editor import commands as c
from app.headless import Wish, deform
from app.model.document import Document
from app.model.handles import Pose
from app.worker.requests import Result
from solver import load_mesh
from solver.geometry.motions import motion, moved, rotation
from solver.types import FloatArray
from tests.app.inline import InlineWorker
from tests.app.person import Person, error_of, slab, state
from tests.app.tools.gizmo.hand import pivot

TURNED = motion(rotation([0, 0, 1], 50), [1.0, 2, 3], centre=[19.0, 2, -1])


class HeldWorker(InlineWorker):
    """Keeps its answers to itself while `held`, and gives them one by one."""

    held = False

    def poll(self) -> list[Result]:
        if self.held:
            return []
        results, self._results = self._results[:1], self._results[1:]
        return results


def handle(document: Document) -> int:
    return document.handles[0].key


def held(person: Person) -> FloatArray:
    """Where the vertices of the handle are."""
    document = person.editor.document
    return person.editor.positions[document.vertices_of(handle(document))]


def keep(person: Person, name: str, T: FloatArray) -> None:
    document = person.editor.document
    kept = document.new_pose(Pose({handle(document): T}), name)
    document.change("poses", (*document.poses, kept))


@pytest.fixture
def bent() -> Person:
    """The bar, bent upwards by a drag, which is kept, as is another pose; its worker can wait."""
    person = Person(slab(20, 4, 2.0), worker=HeldWorker())
    person.ready_bar()
    person.stroke([19, 2, 0], [16, 8, 0])
    keep(person, "turned", TURNED)
    person.do(c.KeepPose("bent"))
    return person


def test_what_is_seen_becomes_the_rest_shape_and_stays(bent: Person) -> None:
    editor, document = bent.editor, bent.editor.document
    seen, entries, before = editor.positions, len(editor.history.done), state(document)
    bent.do(c.MakeRest())
    assert document.pose.at_rest
    np.testing.assert_array_equal(document.rest_positions, seen)
    np.testing.assert_array_equal(editor.positions, seen)
    assert len(editor.history.done) == entries + 1
    after = state(document)
    bent.do(c.Undo())
    assert state(document) == before
    np.testing.assert_allclose(editor.positions, seen, atol=1e-9)
    bent.do(c.Redo())
    assert state(document) == after
    np.testing.assert_array_equal(editor.positions, seen)


def test_kept_poses_lead_the_handle_where_they_did(bent: Person) -> None:
    document = bent.editor.document
    places = {}
    for kept in document.poses:
        bent.do(c.GoToPose(kept.key))
        places[kept.key] = held(bent)
    bent.do(c.MakeRest())
    for kept in document.poses:
        bent.do(c.GoToPose(kept.key))
        np.testing.assert_allclose(held(bent), places[kept.key], atol=1e-9)
    at_rest = {kept.name: kept.pose.at_rest for kept in document.poses}
    assert at_rest == {"turned": False, "bent": True}, "the pose that became the rest shape"


def test_the_surface_costs_nothing_at_the_new_rest_shape_and_is_dragged_from_there(
    bent: Person,
) -> None:
    bent.do(c.SetMap("strain"), c.SetPlacing(gizmo=False), c.MakeRest())
    bent.frame()
    assert bent.editor.heat.rms == 0
    document = bent.editor.document
    rest = document.rest_positions
    bent.stroke(held(bent)[0], held(bent)[0] + [2, 0, 0])
    assert bent.editor.heat.rms > 0
    T = document.pose.of(handle(document))
    expected = moved(T, rest[document.vertices_of(handle(document))])
    np.testing.assert_allclose(held(bent), expected, atol=1e-9)
    assert np.abs(T - np.eye(4)).max() > 0.1
    fixed = document.fixed
    np.testing.assert_array_equal(bent.editor.positions[fixed], document.mesh.vertices[fixed])


@pytest.mark.parametrize("stretch", [1.0, 1.5])
def test_back_at_the_files_shape_everything_leads_where_it_did(
    bent: Person, stretch: float
) -> None:
    editor, document = bent.editor, bent.editor.document
    grown = motion(stretch * rotation([0, 0, 1], 70), [-3.0, 6, 1], centre=[19.0, 2, -1])
    with editor.edit("Grow") as gesture:
        gesture.change("pose", Pose({handle(document): grown}))
    editor.settle()
    before, seen, at = document.poses, editor.positions, held(bent)
    bent.do(c.MakeRest(), c.RestoreRest())
    assert document.rest is None
    np.testing.assert_allclose(held(bent), at, atol=1e-9)
    if stretch == 1.0:  # else it is open how a flat handle was stretched across
        np.testing.assert_allclose(document.pose.of(handle(document)), grown, atol=1e-9)
        np.testing.assert_allclose(editor.positions, seen, atol=1e-6)
    vertices = document.mesh.vertices[document.vertices_of(handle(document))]
    for kept, old in zip(document.poses, before, strict=True):
        now, then = (moved(k.pose.of(handle(document)), vertices) for k in (kept, old))
        np.testing.assert_allclose(now, then, atol=1e-9)
    bent.do(c.Undo())
    np.testing.assert_array_equal(editor.positions, seen)


def test_until_the_bind_is_there_what_is_seen_stays(bent: Person) -> None:
    editor, worker = bent.editor, bent.editor.worker
    assert isinstance(worker, HeldWorker)
    seen = editor.positions
    bent.do(c.MakeRest())
    worker.held = True
    bent.do(c.Undo())
    bent.frame()
    np.testing.assert_array_equal(editor.positions, seen)
    assert not editor.surface.holds(handle(editor.document)), "no drag with the bind of another"
    bent.do(c.ResetPose())
    np.testing.assert_array_equal(editor.positions, editor.document.mesh.vertices)
    bent.do(c.Undo())
    worker.held = False
    bent.frame()
    np.testing.assert_allclose(editor.positions, seen, atol=1e-9)


def test_a_bind_of_another_rest_shape_that_comes_late_is_not_used(bent: Person) -> None:
    editor, worker = bent.editor, bent.editor.worker
    assert isinstance(worker, HeldWorker)
    worker.held = True
    bent.do(c.SetSetting("bending_length", 0.05))  # asks for a bind
    with editor.edit("Rest") as gesture:
        gesture.change("rest", editor.document.new_rest(2 * editor.document.mesh.vertices))
        gesture.change("pose", Pose())
    worker.held = False
    bent.frame()
    assert editor.surface.bound is not None
    assert editor.surface.bound.request.vertices is editor.document.rest_positions


def test_a_new_handle_starts_where_the_surface_is(bent: Person) -> None:
    bent.do(c.MakeRest(), c.AddHandle("second"))
    bent.use("handle", 1.6)
    document = bent.editor.document
    middle = np.flatnonzero(document.role == 0)[40]
    bent.stroke(bent.editor.positions[middle])
    second = document.handles[1].key
    assert len(document.vertices_of(second))
    np.testing.assert_array_equal(document.pose.of(second), np.eye(4))


def test_what_cannot_be_done_is_a_message(bent: Person) -> None:
    document = bent.editor.document
    bent.do(c.RestoreRest())
    assert "the rest shape is the file's already" in error_of(bent)
    with bent.editor.edit("Flatten") as gesture:
        gesture.change("pose", Pose({handle(document): np.diag([1.0, 1, 0, 1])}))
    before = state(document)
    bent.do(c.MakeRest())
    assert "handle 1 is flattened" in error_of(bent)
    assert state(document) == before
    bent.do(c.ResetPose(), c.MakeRest())
    assert "every handle is at rest" in error_of(bent)


def test_a_session_and_an_export_hold_it(bent: Person, tmp_path: Path) -> None:
    mesh = bent.editor.document.mesh
    mesh.save(tmp_path / "bar.obj", mesh.vertices)
    bent.do(c.OpenMesh(tmp_path / "bar.obj"))
    bent.ready_bar()
    bent.stroke([19, 2, 0], [16, 8, 0])
    bent.do(c.MakeRest(), c.SaveSession(tmp_path / "a.json"), c.Export(tmp_path / "out.obj"))
    rest = bent.editor.document.rest_positions
    np.testing.assert_allclose(load_mesh(tmp_path / "out.obj").vertices, rest, atol=1e-8)

    bent.do(c.OpenSession(tmp_path / "a.json"))
    document = bent.editor.document
    np.testing.assert_array_equal(document.rest_positions, rest)
    np.testing.assert_array_equal(bent.editor.positions, rest)
    with bent.editor.edit("Turn") as gesture:
        gesture.change("pose", Pose({handle(document): TURNED}))
    bent.do(c.SaveSession(tmp_path / "b.json"))
    deform(tmp_path / "bar.obj", tmp_path / "b.json", tmp_path / "deformed.obj", Wish())
    bent.editor.settle()
    X = load_mesh(tmp_path / "deformed.obj").vertices
    np.testing.assert_allclose(X, bent.editor.positions, atol=1e-8)


def test_what_a_handle_turns_about_stays_where_it_was(bent: Person) -> None:
    """Nothing on screen moves, so the gizmo may not; nor when that is undone."""
    for name in ("centre", "joint"):
        bent.do(c.SetPlacing(pivot=name))
        seen = pivot(bent)
        for command in (c.MakeRest(), c.Undo(), c.Redo(), c.RestoreRest(), c.Undo(), c.Undo()):
            bent.do(command)
            np.testing.assert_allclose(pivot(bent), seen, atol=1e-9)


def test_a_picked_point_is_of_the_rest_shape_it_was_picked_on(bent: Person) -> None:
    place = held(bent).mean(axis=0) + [0, 0, 1]
    bent.do(c.PickPivot())
    bent.frame(place, "pd")
    bent.frame(place, "r")
    picked = pivot(bent)
    bent.do(c.SetPlacing(pivot="centre"))
    centre = pivot(bent)
    bent.do(c.SetPlacing(pivot="point"))
    np.testing.assert_array_equal(pivot(bent), picked)
    bent.do(c.MakeRest())
    np.testing.assert_allclose(pivot(bent), centre, atol=1e-9)
    bent.do(c.Undo())
    np.testing.assert_array_equal(pivot(bent), picked)
