"""A session beside a mesh is never passed over unseen."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np
import pytest

from app.bundled import DEFAULT_SESSION
from app.editor import commands as c
from app.editor.files.actions import load_document
from app.editor.start import open_editor
from solver.errors import FileError
from tests.app.inline import InlineWorker
from tests.app.person import Person, error_of, question_of, state


@pytest.fixture
def left(opened: Person, tmp_path: Path) -> Person:
    """What was painted and dragged is saved beside the mesh, and another mesh is open."""
    opened.use("softness", 2.0)
    opened.stroke([10, 2, 0])
    opened.use("drag")
    opened.stroke([19, 2, 0], [14, 9, 0])
    opened.do(c.KeepPose("up"), c.SaveSession())
    mesh = opened.editor.document.mesh
    mesh.save(tmp_path / "other.obj", mesh.vertices)
    opened.do(c.OpenMesh(tmp_path / "other.obj"))
    return opened


def test_it_asks_and_says_what_is_there(left: Person, tmp_path: Path) -> None:
    before = left.editor.document
    left.do(c.OpenMesh(tmp_path / "bar.obj"))
    text = question_of(left)
    assert str(tmp_path / "bar.json") in text
    for word in ("1 handle", "1 kept pose", "fixed vertices", "painted softness", " 20"):
        assert word in text
    left.answer("Cancel")
    assert left.editor.document is before


def test_to_continue_is_to_have_all_of_it_again(left: Person, tmp_path: Path) -> None:
    saved = load_document(None, tmp_path / "bar.json")
    left.do(c.OpenMesh(tmp_path / "bar.obj"))
    left.answer("Continue where you left off")
    document = left.editor.document
    np.testing.assert_array_equal(document.role, saved.role)
    np.testing.assert_array_equal(document.softness, saved.softness)
    assert document.softness.any()
    assert document.pose == saved.pose
    assert document.path == tmp_path / "bar.obj"
    assert left.editor.session_path == tmp_path / "bar.json"
    assert [kept.name for kept in document.poses] == ["up"]
    left.do(c.AddHandle("one"), c.SaveSession())
    assert left.editor.question is None


def test_to_start_fresh_still_spares_the_session(left: Person, tmp_path: Path) -> None:
    saved = (tmp_path / "bar.json").read_bytes()
    left.do(c.OpenMesh(tmp_path / "bar.obj"))
    left.answer("Start fresh")
    assert not left.editor.document.handles
    left.do(c.SaveSession())
    assert "bar.json is there already" in question_of(left)
    left.answer("Cancel")
    assert (tmp_path / "bar.json").read_bytes() == saved


def test_the_last_one_of_several_is_continued(left: Person, tmp_path: Path) -> None:
    left.do(c.OpenSession(tmp_path / "bar.json"), c.AddHandle("more"))
    left.do(c.SaveSession(tmp_path / "bar-2.json"))
    for name, hour in (("bar.json", 1), ("bar-2.json", 2), ("bar-x.json", 3)):
        (tmp_path / name).touch()
        os.utime(tmp_path / name, (3600 * hour,) * 2)
    left.do(c.OpenMesh(tmp_path / "bar.obj"))
    assert f"{tmp_path / 'bar-2.json'} holds work" in question_of(left)
    assert question_of(left).endswith("Also there: bar.json.")
    left.answer("Cancel")
    os.utime(tmp_path / "bar.json")
    left.do(c.OpenMesh(tmp_path / "bar.obj"))
    assert f"{tmp_path / 'bar.json'} holds work" in question_of(left)


def test_a_session_of_another_mesh_with_a_number_is_none_of_this_one(
    left: Person, tmp_path: Path
) -> None:
    left.editor.document.mesh.save(tmp_path / "bar-2.obj", left.editor.positions)
    left.do(c.OpenMesh(tmp_path / "bar-2.obj"), c.SaveSession())
    left.do(c.OpenMesh(tmp_path / "bar.obj"))
    assert "bar-2" not in question_of(left)


def test_a_session_of_another_mesh_says_so(left: Person, tmp_path: Path) -> None:
    (tmp_path / "bar.json").rename(tmp_path / "other.json")
    left.do(c.OpenMesh(tmp_path / "other.obj"))
    assert f"It was saved of {tmp_path / 'bar.obj'}" in question_of(left)
    left.answer("Continue where you left off")
    assert left.editor.document.path == tmp_path / "other.obj"


def test_one_that_cannot_be_read_is_told_and_left_alone(left: Person, tmp_path: Path) -> None:
    broken = (tmp_path / "bar.json").read_bytes()[:300]
    (tmp_path / "bar.json").write_bytes(broken)
    left.do(c.OpenMesh(tmp_path / "bar.obj"))
    assert "left alone, it cannot be read" in error_of(left)
    assert str(tmp_path / "bar.json") in error_of(left)
    assert left.editor.document.path == tmp_path / "bar.obj"
    left.do(c.SaveSession())
    assert "bar.json is there already" in question_of(left)
    left.answer("Cancel")
    assert (tmp_path / "bar.json").read_bytes() == broken


def test_what_is_no_session_is_nobodys_business(left: Person, tmp_path: Path) -> None:
    (tmp_path / "bar.json").write_text('{"frames": 12}')
    left.do(c.OpenMesh(tmp_path / "bar.obj"))
    assert left.editor.question is None
    assert left.editor.document.path == tmp_path / "bar.obj"


def test_a_window_begins_with_the_question(left: Person, tmp_path: Path) -> None:
    for answer, handles in (("Continue where you left off", 1), ("Start fresh", 0)):
        person = Person.of(open_editor(tmp_path / "bar.obj", None, InlineWorker()))
        assert not person.editor.document.handles
        assert "1 handle" in question_of(person)
        person.answer(answer)
        assert len(person.editor.document.handles) == handles


def test_a_session_that_is_named_is_opened_unasked(left: Person, tmp_path: Path) -> None:
    for mesh in (None, tmp_path / "bar.obj"):
        editor = open_editor(mesh, tmp_path / "bar.json", InlineWorker())
        assert editor.question is None
        assert len(editor.document.handles) == 1
    assert open_editor(None, DEFAULT_SESSION, InlineWorker()).question is None


def test_another_document_is_shown_only_after_this_one_was_left(
    left: Person, tmp_path: Path
) -> None:
    editor, told = left.editor, list[str]()
    left.do(c.AddHandle("one"))
    before, inside = editor.document, state(editor.document)
    editor.leaving = lambda: told.append(editor.document.path.name)
    left.do(c.OpenMesh(tmp_path / "nowhere.obj"), c.OpenMesh(tmp_path / "bar.obj"))
    assert told == [], "nothing was shown yet"

    def refuse() -> None:
        raise FileError("it cannot be kept")

    editor.leaving = refuse
    left.answer("Start fresh")
    assert error_of(left) == "it cannot be kept"
    assert editor.document is before
    assert state(before) == inside
    editor.leaving = lambda: told.append(editor.document.path.name)
    left.do(c.OpenMesh(tmp_path / "bar.obj", fresh=True))
    assert told == ["other.obj"]
    np.testing.assert_array_equal(editor.document.role, 0)
