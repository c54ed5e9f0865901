"""Softness learned from meshes in other poses, and poses taken from them."""

from __future__ import annotations

import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from app.editor import commands as c
from solver import Deformer, Mesh, learn_softness, load_mesh
from solver.geometry.motions import motion, moved, rotation
from solver.types import FloatArray
from tests.app.person import Person, error_of, slab, state

TURNED = motion(rotation([0, 1, 0], 50), [1.0, 0, 2], centre=[10.0, 2, -1])
AWAY = motion(rotation([1, 1, 0], 70), [5.0, 0.0, 9.0])


@pytest.fixture
def person(tmp_path: Path) -> Iterator[Person]:
    """The bar, its left end fixed, the right one a handle."""
    bar = slab(20, 4, 2.0)
    bar.save(str(tmp_path / "bar.obj"), bar.vertices)
    person = Person(load_mesh(tmp_path / "bar.obj"), tmp_path / "bar.obj")
    person.ready_bar()
    yield person
    person.editor.close()


def bent(person: Person, away: FloatArray | None = None, level: int = 6) -> Path:
    """A file beside the mesh: its handle turned, soft in its middle."""
    document = person.editor.document
    V = document.rest_positions
    soft = np.clip(1 - np.abs(V[:, 0] - 10) / 3, 0, 1)
    (handle,) = document.handles
    held = document.fixed, [document.vertices_of(handle.key)]
    X = Deformer(V, document.mesh.faces, *held, soft).pose([TURNED], level)
    path = document.path.with_name("bent.obj")
    document.mesh.save(str(path), X if away is None else moved(away, X))
    return path


def begin(person: Person, path: Path) -> None:
    """Ask to learn, and wait until its process has said how far it is."""
    person.editor.execute(c.LearnSoftness((path,)))
    until = time.monotonic() + 60
    while not (person.editor.tasks.now and person.editor.tasks.now.fraction):
        assert time.monotonic() < until
        assert person.editor.tasks.now is not None, error_of(person)
        person.frame()
        time.sleep(0.005)


def test_learned_softness_is_the_documents_and_one_entry_of_undo(person: Person) -> None:
    path, document = bent(person, AWAY), person.editor.document
    before = state(document)
    person.do(c.LearnSoftness((path,)))
    handles = [document.vertices_of(handle.key) for handle in document.handles]
    poses = [load_mesh(path).vertices]
    wanted = learn_softness(
        document.rest_positions, document.mesh.faces, poses, document.fixed, handles
    )
    np.testing.assert_allclose(document.softness, wanted, atol=1e-6)
    assert document.softness.max() > 0.5
    assert person.editor.map == "softness"
    assert person.editor.history.done[-1].label == "Learn softness"
    person.use("softness", 1.0)
    person.stroke([4, 2, 0], [5, 2, 0])
    person.do(c.Undo(), c.Undo())
    assert state(document) == before


def test_a_stroke_goes_on_while_it_learns_and_another_mesh_gets_nothing(person: Person) -> None:
    person.use("softness", 1.0)
    begin(person, bent(person))
    person.stroke([4, 2, 0], [5, 2, 0])
    assert person.editor.document.softness.max() > 0
    person.editor.complete()
    labels = {entry.label for entry in person.editor.history.done[-2:]}
    assert labels == {"Paint softness", "Learn softness"}
    begin(person, bent(person))
    person.editor.execute(c.OpenMesh(person.editor.document.path, fresh=True))
    person.editor.complete()
    assert not person.editor.document.softness.any()
    assert "meanwhile" in error_of(person)


def test_cancelled_learning_changes_nothing(person: Person) -> None:
    before = state(person.editor.document)
    begin(person, bent(person))
    person.do(c.CancelTask())
    assert person.editor.tasks.now is None
    assert person.editor.message is not None
    assert person.editor.message.text == "Learning softness was cancelled"
    assert state(person.editor.document) == before


@pytest.mark.parametrize("command", [lambda path: c.LearnSoftness((path,)), c.AddPose])
@pytest.mark.parametrize(
    ("mesh", "said"),
    [
        (slab(3, 3, 1.0), "32 vertices, expected 210"),
        (Mesh.from_arrays(slab(20, 4, 2.0).vertices, [[0, 1, 2]]), "its faces are not those of"),
        (None, "cannot be read"),
    ],
)
def test_other_meshes_are_refused(
    person: Person, tmp_path: Path, command: type[c.AddPose], mesh: Mesh | None, said: str
) -> None:
    path, before = tmp_path / "other.obj", state(person.editor.document)
    if mesh is not None:
        mesh.save(str(path), mesh.vertices)
    person.do(command(path))
    assert said in error_of(person)
    assert state(person.editor.document) == before


def test_what_teaches_nothing_is_refused(person: Person, tmp_path: Path) -> None:
    person.do(c.LearnSoftness((tmp_path / "bar.obj",)))
    assert "no motion" in error_of(person)
    person.do(c.LearnSoftness(()))
    assert "expected one or more" in error_of(person)


@pytest.mark.parametrize("away", [None, AWAY])
def test_a_mesh_becomes_a_kept_pose_that_leads_where_it_is(
    person: Person, away: FloatArray | None
) -> None:
    document, path = person.editor.document, bent(person, away)
    document.change("softness", np.clip(1 - np.abs(document.rest_positions[:, 0] - 10) / 3, 0, 1))
    document.change("rigid", 6)
    pose = document.pose
    person.do(c.AddPose(path), c.AddPose(path))
    assert [kept.name for kept in document.poses] == ["bent", "bent 2"]
    assert document.pose == pose, "nothing moves by itself"
    assert person.editor.message is not None
    assert "0.00% of its size" in person.editor.message.text
    (handle,) = document.handles
    np.testing.assert_allclose(document.poses[0].pose.of(handle.key), TURNED, atol=1e-4)
    person.do(c.GoToPose(document.poses[0].key))
    person.editor.settle()
    at = bent(person)
    np.testing.assert_allclose(person.editor.positions, load_mesh(at).vertices, atol=1e-2)
    person.do(c.Undo(), c.Undo(), c.Undo())
    assert document.poses == ()


def test_a_pose_needs_a_handle(person: Person) -> None:
    path, document = bent(person), person.editor.document
    person.do(c.RemoveHandle(document.handles[0].key), c.AddPose(path))
    assert "no handle" in error_of(person)
    assert document.poses == ()
