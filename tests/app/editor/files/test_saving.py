"""Opening, saving and exporting through the editor."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pytest

from app.editor import commands as c
from app.editor.files.actions import load_document, open_command
from app.worker.service import bind
from app.worker.snapshot import bind_request
from solver import load_mesh
from tests.app.person import Person, error_of, question_of, slab, state


@pytest.fixture
def saved(tmp_path: Path) -> Person:
    """The bar, opened from bar.obj, its handle dragged."""
    slab(20, 4, 2.0).save(tmp_path / "bar.obj", slab(20, 4, 2.0).vertices)
    person = Person(load_mesh(tmp_path / "bar.obj"), tmp_path / "bar.obj")
    person.ready_bar()
    person.stroke([19, 2, 0], [14, 9, 0])
    return person


def test_export_goes_beside_the_mesh_and_holds_what_is_on_screen(saved: Person) -> None:
    source = saved.editor.document.path
    before = source.read_bytes()
    saved.do(c.Export())
    out = load_mesh(source.with_name("bar-deformed.obj"))
    np.testing.assert_allclose(out.vertices, saved.editor.positions, atol=1e-12)
    np.testing.assert_array_equal(out.faces, saved.editor.document.mesh.faces)
    assert source.read_bytes() == before


def test_export_goes_where_the_program_was_told(saved: Person, tmp_path: Path) -> None:
    saved.editor.export_path = tmp_path / "told.obj"
    saved.do(c.Export())
    assert (tmp_path / "told.obj").exists()
    saved.do(c.Export(tmp_path / "asked.ply"))
    assert (tmp_path / "asked.ply").exists()


def test_saving_never_replaces_the_open_mesh_unasked(saved: Person, tmp_path: Path) -> None:
    before = (tmp_path / "bar.obj").read_bytes()
    names = ["bar.obj", f"../{tmp_path.name}/bar.obj"]
    if sys.platform != "win32":  # where links take a privilege
        (tmp_path / "link.obj").symlink_to(tmp_path / "bar.obj")
        names.append("link.obj")
    for name in names:
        saved.do(c.Export(tmp_path / name))
        assert f"{Path(name).name} is the mesh that is open" in question_of(saved)
        saved.answer("Cancel")
        saved.do(c.SaveSession(tmp_path / name))
        assert "is the mesh that is open" in error_of(saved)
    assert (tmp_path / "bar.obj").read_bytes() == before


def test_export_waits_for_the_bind_that_is_running(saved: Person, tmp_path: Path) -> None:
    document = saved.editor.document
    saved.do(c.SetSetting("bending_length", 0.2), c.Export(tmp_path / "out.obj"))
    transforms = [document.pose.of(document.handles[0].key)]
    expected = bind(bind_request(document)).pose(transforms, rigid=document.rigid)
    np.testing.assert_allclose(load_mesh(tmp_path / "out.obj").vertices, expected, atol=1e-8)


def test_a_session_opens_as_it_was_saved_and_is_not_dirty(saved: Person) -> None:
    editor, path = saved.editor, saved.editor.document.path.with_suffix(".json")
    shown = editor.positions
    assert editor.dirty
    saved.do(c.SaveSession())
    assert not editor.dirty
    assert editor.session_path == path
    saved.do(c.Undo())
    assert editor.dirty
    saved.do(c.Redo())
    assert not editor.dirty
    role, softness, *_ = state(editor.document)
    saved.do(c.OpenSession(path))
    assert not editor.dirty
    assert not editor.history.done
    assert state(editor.document)[:2] == (role, softness)
    editor.settle()
    np.testing.assert_allclose(editor.positions, shown, atol=1e-8)


def test_saving_goes_back_to_the_session_that_was_opened(saved: Person, tmp_path: Path) -> None:
    saved.do(c.SaveSession(tmp_path / "mine.json"), c.SetSetting("rigid", 0), c.SaveSession())
    assert load_document(None, tmp_path / "mine.json").rigid == 0
    assert not (tmp_path / "bar.json").exists()


def test_a_change_merged_after_a_save_is_dirty(saved: Person) -> None:
    saved.do(c.SetSetting("bending_length", 0.02), c.SaveSession())
    saved.do(c.SetSetting("bending_length", 0.03))
    assert saved.editor.dirty
    saved.do(c.Undo())
    assert not saved.editor.dirty
    assert saved.editor.document.bending_length == 0.02


def test_opening_a_mesh_starts_anew(saved: Person, tmp_path: Path) -> None:
    other = slab(3, 3, 1.0)
    other.save(tmp_path / "other.off", other.vertices)
    old = saved.editor.document
    positions = saved.editor.positions_version
    saved.do(c.OpenMesh(tmp_path / "other.off"))
    editor = saved.editor
    assert editor.document is not old
    assert len(editor.positions) == len(other.vertices)
    assert editor.positions_version != positions
    assert editor.active is None
    editor.settle()
    np.testing.assert_array_equal(editor.positions, other.vertices)
    assert len(editor.colors) == len(other.vertices)


def test_a_session_of_another_mesh_leaves_the_document_alone(saved: Person, tmp_path: Path) -> None:
    saved.do(c.SaveSession(tmp_path / "a.json"))
    small = slab(3, 3, 1.0)
    small.save(tmp_path / "bar.obj", small.vertices)
    document, before = saved.editor.document, state(saved.editor.document)
    saved.do(c.OpenSession(tmp_path / "a.json"))
    assert "bar.obj has changed since" in question_of(saved)
    saved.answer("Cancel")
    assert saved.editor.document is document
    assert state(document) == before


def test_a_session_can_be_put_on_another_file_of_the_same_mesh(
    saved: Person, tmp_path: Path
) -> None:
    saved.do(c.SaveSession(tmp_path / "a.json"))
    copy = tmp_path / "copy.obj"
    (tmp_path / "bar.obj").rename(copy)
    document = load_document(copy, tmp_path / "a.json")
    assert document.path == copy
    np.testing.assert_array_equal(document.role, saved.editor.document.role)


def test_dropped_files_open_by_their_suffix() -> None:
    assert open_command(Path("a.JSON")) == c.OpenSession(Path("a.JSON"))
    assert open_command(Path("a.obj")) == c.OpenMesh(Path("a.obj"))


def test_an_export_says_what_its_format_does_not_keep(tmp_path: Path) -> None:
    path = tmp_path / "quad.obj"
    path.write_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1 4/1\n")
    person = Person(load_mesh(path), path)
    for name, words in (
        ("a.obj", ""),
        ("a.ply", "; PLY keeps no texture coordinates"),
        ("a.stl", "; STL keeps no texture coordinates, polygons (1 quad became triangles)"),
    ):
        person.do(c.Export(tmp_path / name))
        assert person.editor.message is not None
        assert person.editor.message.text == f"Exported {tmp_path / name}{words}"
