"""No file that somebody else made is replaced unasked, and some are not replaced at all."""

from __future__ import annotations

from pathlib import Path

import pytest

from app.editor import commands as c
from app.editor.files.actions import load_document
from app.model.session.files import session_name
from solver import load_mesh
from tests.app.person import Person, error_of, question_of, state

SAVES = {"session": (c.SaveSession(), "bar.json"), "mesh": (c.Export(), "bar-deformed.obj")}


@pytest.fixture(params=list(SAVES))
def foreign(request: pytest.FixtureRequest, opened: Person, tmp_path: Path) -> Path:
    """A file of the kind that is saved, where Ctrl+S or Ctrl+E would save, asked about."""
    command, name = SAVES[request.param]
    opened.do(command)
    (tmp_path / name).rename(tmp_path / "kept")
    opened.do(c.OpenMesh(tmp_path / "bar.obj"), c.AddHandle("one"))
    (tmp_path / "kept").rename(tmp_path / name)
    opened.do(command)
    return tmp_path / name


def test_cancel_leaves_a_file_byte_for_byte(opened: Person, foreign: Path) -> None:
    before, files = foreign.read_bytes(), sorted(foreign.parent.iterdir())
    assert f"{foreign} is there already" in question_of(opened)
    opened.answer("Cancel")
    assert foreign.read_bytes() == before
    assert sorted(foreign.parent.iterdir()) == files
    assert opened.editor.dirty


def test_a_file_is_replaced_once_it_was_agreed_to_and_then_without_asking(
    opened: Person, foreign: Path
) -> None:
    foreign.write_bytes(foreign.read_bytes() + b" ")
    before = foreign.read_bytes()
    opened.answer("Replace")
    assert foreign.read_bytes() != before
    again = c.SaveSession() if foreign.suffix == ".json" else c.Export()
    opened.do(c.AddHandle("two"), again)
    assert opened.editor.question is None
    assert opened.editor.message is not None
    assert str(foreign) in opened.editor.message.text, "the whole path"


def test_what_is_saved_beside_it_is_where_it_is_saved_from_then_on(
    opened: Person, foreign: Path
) -> None:
    before = foreign.read_bytes()
    other = foreign.with_stem(f"{foreign.stem}-2")
    opened.answer(f"Save as {other.name}")
    assert other.exists()
    other.unlink()
    opened.do(c.SaveSession() if foreign.suffix == ".json" else c.Export())
    assert other.exists()
    assert foreign.read_bytes() == before


@pytest.mark.parametrize("name", list(SAVES))
def test_a_file_that_changed_meanwhile_is_asked_about_again(
    name: str, opened: Person, tmp_path: Path
) -> None:
    command, file = SAVES[name]
    opened.do(command, command)
    assert opened.editor.question is None
    changed = (tmp_path / file).read_bytes() + b"\n"
    (tmp_path / file).write_bytes(changed)
    opened.do(command)
    assert f"{file} was changed by somebody else meanwhile" in question_of(opened)
    assert (tmp_path / file).read_bytes() == changed


def test_a_session_that_was_opened_is_saved_without_asking(opened: Person, tmp_path: Path) -> None:
    opened.do(c.SaveSession(tmp_path / "mine.json"), c.OpenSession(tmp_path / "mine.json"))
    opened.do(c.AddHandle("one"), c.SaveSession())
    assert opened.editor.question is None
    handles = load_document(None, tmp_path / "mine.json").handles
    assert [handle.name for handle in handles][-1] == "one"


def test_what_was_saved_of_one_mesh_is_asked_about_for_another(
    opened: Person, tmp_path: Path
) -> None:
    mine = tmp_path / "mine.json"
    opened.do(c.SaveSession(mine))
    before = mine.read_bytes()
    opened.editor.document.mesh.save(tmp_path / "b.obj", opened.editor.positions)
    opened.do(c.OpenMesh(tmp_path / "b.obj"), c.SaveSession(mine))
    assert "mine.json is there already" in question_of(opened)
    assert mine.read_bytes() == before


@pytest.mark.parametrize("replace", [False, True])
@pytest.mark.parametrize("text", ['{"name": "a package"}', "notes", "v 0 0 0\n"])
def test_a_session_never_replaces_what_is_none(
    text: str, replace: bool, opened: Person, tmp_path: Path
) -> None:
    other = tmp_path / "package.json"
    other.write_text(text)
    opened.do(c.SaveSession(other, replace))
    assert error_of(opened) == f"{other} is no session of this program; expected another name"
    assert other.read_text() == text


@pytest.mark.parametrize("replace", [False, True])
def test_a_mesh_never_replaces_a_session(replace: bool, opened: Person, tmp_path: Path) -> None:
    session = tmp_path / "pose.obj"  # whatever it is called
    opened.do(c.SaveSession(tmp_path / "pose.json"), c.KeepPose("one"))
    (tmp_path / "pose.json").rename(session)
    before = session.read_bytes()
    for command in (c.Export(session, replace), c.ExportPoses(session, replace=replace)):
        opened.do(command)
        assert error_of(opened) == f"{session} is a session; a mesh needs another name"
    assert session.read_bytes() == before


def test_the_mesh_that_is_open_is_replaced_where_that_is_meant(
    opened: Person, tmp_path: Path
) -> None:
    document = opened.editor.document
    opened.stroke([19, 2, 0], [14, 9, 0])
    before = state(document)
    opened.do(c.Export(tmp_path / "bar.obj"))
    assert f"{tmp_path / 'bar.obj'} is the mesh that is open" in question_of(opened)
    opened.answer("Replace")
    X = load_mesh(tmp_path / "bar.obj").vertices
    assert abs(X - opened.editor.positions).max() < 1e-12
    assert state(document) == before
    opened.do(c.SaveSession(), c.OpenSession(tmp_path / "bar.json"))
    assert "bar.obj has changed since" in question_of(opened), "its session is of another shape"


def test_a_broken_session_is_replaced_only_where_that_is_agreed(
    opened: Person, tmp_path: Path
) -> None:
    opened.do(c.SaveSession())
    broken = (tmp_path / "bar.json").read_bytes()[:200]
    (tmp_path / "bar.json").write_bytes(broken)
    opened.do(c.SaveSession())
    opened.answer("Cancel")
    assert (tmp_path / "bar.json").read_bytes() == broken


def test_a_session_has_the_suffix_of_sessions() -> None:
    for name, expected in (("a.json", "a.json"), ("a.JSON", "a.JSON"), ("a.v2", "a.v2.json")):
        assert session_name(Path("x") / name) == Path("x") / expected
