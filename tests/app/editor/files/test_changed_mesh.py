"""A session on a mesh that has changed since: said, asked about, carried over by nearest vertex."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from app.editor import commands as c
from app.editor.files.actions import load_document
from app.editor.start import open_editor
from app.model.document import Document
from app.model.handles import FIXED
from solver import Mesh
from solver.types import FloatArray
from tests.app.inline import InlineWorker
from tests.app.person import Person, error_of, question_of, slab, state


@pytest.fixture
def saved(opened: Person, tmp_path: Path) -> Document:
    """bar.json: the ends held, softness in the middle, a pin, two kept poses, somewhere else."""
    opened.use("softness", 2.0)
    opened.stroke([10, 2, 0])
    opened.use("drag")
    opened.click([5, 2, 0])
    opened.stroke([19, 2, 0], [14, 9, 0])
    opened.do(c.KeepPose("up"), c.ResetPose(), c.KeepPose("down"), c.GoToPose(1))
    opened.do(c.SaveSession())
    document = load_document(None, tmp_path / "bar.json")
    assert [handle.pin for handle in document.handles] == [False, True]
    assert document.softness.any()
    return document


def rewrite(path: Path, mesh: Mesh, X: FloatArray | None = None) -> None:
    mesh.save(path, mesh.vertices if X is None else X)


def by_place(document: Document) -> dict[tuple[float, ...], tuple[int, float]]:
    """Role and softness at each place."""
    values = zip(document.role.tolist(), document.softness.tolist(), strict=True)
    return dict(zip(map(tuple, document.mesh.vertices.round(6).tolist()), values, strict=True))


def test_a_mesh_that_is_numbered_anew_is_painted_where_it_was(
    opened: Person, saved: Document, tmp_path: Path
) -> None:
    mesh, order = saved.mesh, np.random.default_rng(1).permutation(len(saved.mesh.vertices))
    number = np.argsort(order)
    rewrite(tmp_path / "bar.obj", Mesh.from_arrays(mesh.vertices[order], number[mesh.faces]))
    before = opened.editor.document
    opened.do(c.OpenSession(tmp_path / "bar.json"))
    assert "its vertices are others" in question_of(opened)
    assert opened.editor.document is before
    opened.answer("Carry to the nearest")
    document = opened.editor.document
    assert by_place(document) == by_place(saved)
    assert document.pose == saved.pose
    assert [(kept.name, kept.pose) for kept in document.poses] == [
        (kept.name, kept.pose) for kept in saved.poses
    ]
    assert document.handles == saved.handles
    before_saving = (tmp_path / "bar.json").read_bytes()
    opened.do(c.SaveSession())
    assert "bar.json is there already" in question_of(opened), "it holds what was painted before"
    assert (tmp_path / "bar.json").read_bytes() == before_saving


def test_a_finer_mesh_is_painted_without_holes_and_nothing_else_is(
    opened: Person, saved: Document, tmp_path: Path
) -> None:
    fine = slab(80, 16, 2.0)
    fine = Mesh.from_arrays(fine.vertices * [0.25, 0.25, 1.0], fine.faces)
    rewrite(tmp_path / "bar.obj", fine)
    opened.do(c.OpenSession(tmp_path / "bar.json"))
    opened.answer("Carry to the nearest")
    document = opened.editor.document
    for key in (FIXED, saved.handles[0].key):
        old = saved.mesh.vertices[saved.vertices_of(key)]
        (low, high) = old.min(axis=0) - 0.51, old.max(axis=0) + 0.51
        inside = ((fine.vertices > low) & (fine.vertices < high)).all(axis=1)
        new = document.role == key
        assert new.sum() > 4 * len(old), "no holes"
        assert not (new & ~inside).any()
    assert 0 < document.softness.max() <= saved.softness.max()


def test_a_pin_that_is_nearest_to_nothing_keeps_a_vertex(
    opened: Person, saved: Document, tmp_path: Path
) -> None:
    coarse = slab(4, 1, 2.0)
    rewrite(tmp_path / "bar.obj", Mesh.from_arrays(coarse.vertices * [5.0, 4.0, 1.0], coarse.faces))
    opened.do(c.OpenSession(tmp_path / "bar.json"))
    opened.answer("Carry to the nearest")
    document = opened.editor.document
    pin = document.handles[1]
    assert len(document.vertices_of(pin.key)) >= 1
    np.testing.assert_allclose(document.handle_centres()[pin.key][0], 5.0)


def test_what_has_no_vertex_left_is_named(opened: Person, saved: Document, tmp_path: Path) -> None:
    mesh = saved.mesh
    kept = mesh.vertices[mesh.faces][:, :, 0].max(axis=1) < 15
    V, F = np.unique(mesh.faces[kept], return_inverse=True)
    cut = Mesh.from_arrays(mesh.vertices[V], F.reshape(-1, 3))
    rewrite(tmp_path / "bar.obj", cut)
    opened.do(c.OpenSession(tmp_path / "bar.json"))
    assert "of the mesh's size away" in question_of(opened)
    opened.answer("Carry to the nearest")
    assert opened.editor.message is not None
    assert f"Carried over to {tmp_path / 'bar.obj'}" in opened.editor.message.text
    assert "Without vertices now: handle 1" in opened.editor.message.text
    assert saved.handles[1].name not in opened.editor.message.text


def test_vertices_that_have_moved_keep_their_numbers_or_not_as_is_chosen(
    opened: Person, saved: Document, tmp_path: Path
) -> None:
    rewrite(tmp_path / "bar.obj", saved.mesh, saved.mesh.vertices[:, [1, 0, 2]] * 100.0)
    opened.do(c.OpenSession(tmp_path / "bar.json"))
    assert "its vertices have moved" in question_of(opened)
    opened.answer("Keep by vertex number")
    np.testing.assert_array_equal(opened.editor.document.role, saved.role)
    np.testing.assert_array_equal(opened.editor.document.softness, saved.softness)
    opened.do(c.OpenSession(tmp_path / "bar.json"))
    opened.answer("Carry to the nearest")
    assert (opened.editor.document.role != saved.role).any()


def test_a_mesh_that_is_only_split_otherwise_keeps_its_numbers(
    opened: Person, saved: Document, tmp_path: Path
) -> None:
    rewrite(tmp_path / "bar.obj", Mesh.from_arrays(saved.mesh.vertices, saved.mesh.faces[::-1]))
    opened.do(c.OpenSession(tmp_path / "bar.json"))
    assert "where they were, but joined otherwise" in question_of(opened)
    opened.answer("Keep by vertex number")
    np.testing.assert_array_equal(opened.editor.document.role, saved.role)


def test_the_same_shape_in_another_file_is_no_change(
    opened: Person, saved: Document, tmp_path: Path
) -> None:
    text = (tmp_path / "bar.obj").read_text()
    (tmp_path / "bar.obj").write_text("# of somebody\nmtllib a.mtl\n" + text)
    saved.mesh.save(tmp_path / "bar.ply", saved.mesh.vertices)
    opened.do(c.OpenSession(tmp_path / "bar.json"))
    assert opened.editor.question is None
    assert load_document(tmp_path / "bar.ply", tmp_path / "bar.json").handles


def test_a_session_that_does_not_say_where_its_vertices_were_cannot_be_carried(
    opened: Person, saved: Document, tmp_path: Path
) -> None:
    data = json.loads((tmp_path / "bar.json").read_text())
    del data["places"]
    (tmp_path / "bar.json").write_text(json.dumps(data))
    small = slab(3, 3, 1.0)
    rewrite(tmp_path / "bar.obj", small)
    before = state(opened.editor.document)
    opened.do(c.OpenSession(tmp_path / "bar.json"))
    assert "painting cannot be carried over" in question_of(opened)
    opened.answer("Cancel")
    opened.do(c.OpenSession(tmp_path / "bar.json", carry="nearest"))
    assert "places: missing" in error_of(opened)
    assert state(opened.editor.document) == before


def test_a_window_begins_with_the_mesh_and_the_question(saved: Document, tmp_path: Path) -> None:
    rewrite(tmp_path / "bar.obj", slab(10, 2, 2.0))
    person = Person.of(open_editor(None, tmp_path / "bar.json", InlineWorker()))
    assert len(person.editor.document.role) == 11 * 3 * 2
    assert "has changed since" in question_of(person)
    person.answer("Carry to the nearest")
    assert len(person.editor.document.handles) == 2
