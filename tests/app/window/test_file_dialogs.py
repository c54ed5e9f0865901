"""Which dialog a key opens, and what becomes of the answer; needs no graphics library."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from app.bundled import DEFAULT_SESSION
from app.dialogs.dialogs import Dialogs
from app.dialogs.programs import tk
from app.dialogs.question import Answer, Question
from app.editor import commands as c
from app.editor.files.actions import load_document
from app.window.file_dialogs import FileDialogs
from app.window.films.film import TakeFilm
from solver.mesh.formats.table import FORMATS
from tests.app.person import Person, slab


class Clerk(Dialogs):
    """Answers at the next poll, as told."""

    def __init__(self) -> None:
        super().__init__(tk)
        self.asked: list[Question] = []
        self.path: Path | None = None

    def ask(self, question: Question) -> None:
        self.asked.append(question)

    def poll(self) -> Answer | None:
        return Answer(self.asked[-1], self.path) if self.asked else None


@pytest.fixture
def clerk() -> Clerk:
    return Clerk()


@pytest.fixture
def person(tmp_path: Path) -> Iterator[Person]:
    person = Person(slab(3, 3, 1.0), tmp_path / "m.ply")
    yield person
    person.editor.close()


def test_opening_asks_for_meshes_and_sessions_beside_the_mesh(
    clerk: Clerk, person: Person, tmp_path: Path
) -> None:
    files = FileDialogs(clerk)
    assert files.act("open", person.editor) is None
    (question,) = clerk.asked
    assert not question.saves
    assert question.path == tmp_path
    assert set(question.kinds[0].suffixes) == {*FORMATS, ".json"}
    assert files.poll(person.editor) is None, "cancelled: nothing happens"
    clerk.path = tmp_path / "a.json"
    assert files.poll(person.editor) == c.OpenSession(tmp_path / "a.json")
    clerk.path = tmp_path / "a.glb"
    assert files.poll(person.editor) == c.OpenMesh(tmp_path / "a.glb")


def test_a_session_is_saved_where_it_is_known_else_it_asks(
    clerk: Clerk, person: Person, tmp_path: Path
) -> None:
    files, editor = FileDialogs(clerk), person.editor
    assert files.act("save", editor) is None
    assert clerk.asked[0].path == tmp_path / "m.json"
    clerk.path = tmp_path / "mine.json"
    command = files.poll(editor)
    assert command == c.SaveSession(tmp_path / "mine.json", replace=True), "the dialog has asked"
    editor.document.mesh.save(tmp_path / "m.ply", editor.positions)
    person.do(command)
    assert files.act("save", editor) == c.SaveSession(tmp_path / "mine.json")
    assert files.act("save as", editor) is None
    assert clerk.asked[-1].path == tmp_path / "mine.json"
    editor.adopt(load_document(None, DEFAULT_SESSION), DEFAULT_SESSION)
    assert files.act("save", editor) is None, "what comes with the program is not written over"


def test_an_export_goes_where_the_last_one_went_until_another_document_is_open(
    clerk: Clerk, person: Person, tmp_path: Path
) -> None:
    files = FileDialogs(clerk)
    assert files.act("export", person.editor) is None
    assert clerk.asked[0].path == tmp_path / "m-deformed.obj"
    clerk.path = tmp_path / "out.obj"
    command = files.poll(person.editor)
    assert command == c.Export(tmp_path / "out.obj", replace=True)
    person.do(command)
    assert files.act("export", person.editor) == c.Export(tmp_path / "out.obj")
    assert files.act("export as", person.editor) is None
    assert files.act("export poses", person.editor) == c.ExportPoses(tmp_path / "out.obj", 0)
    person.editor.adopt(load_document(tmp_path / "out.obj", None))
    assert files.act("export", person.editor) is None
    person.editor.export_path = tmp_path / "told.obj"
    assert files.act("export", person.editor) == c.Export(tmp_path / "told.obj")


def test_a_suffix_is_added_but_never_over_a_file_that_nobody_was_asked_about(
    clerk: Clerk, person: Person, tmp_path: Path
) -> None:
    files = FileDialogs(clerk)
    files.act("save as", person.editor)
    clerk.path = tmp_path / "name"
    assert files.poll(person.editor) == c.SaveSession(tmp_path / "name.json"), "asks if it is there"
    clerk.path = tmp_path / "name.json"  # the dialog has asked
    assert files.poll(person.editor) == c.SaveSession(tmp_path / "name.json", replace=True)
    clerk.path = tmp_path / "name.v2"  # which could not be told from a mesh
    assert files.poll(person.editor) == c.SaveSession(tmp_path / "name.v2.json")


def test_an_export_of_poses_asks_as_an_export_does_and_has_the_shapes_between(
    clerk: Clerk, person: Person, tmp_path: Path
) -> None:
    files = FileDialogs(clerk)
    person.do(c.ChooseBlend(between=3))
    assert files.act("export poses", person.editor) is None
    assert clerk.asked[0].saves
    assert clerk.asked[0].path == tmp_path / "m-deformed.obj"
    clerk.path = tmp_path / "film.glb"
    assert files.poll(person.editor) == c.ExportPoses(tmp_path / "film.glb", 3, replace=True)


@pytest.mark.parametrize(
    ("name", "command"), [("learn", lambda path: c.LearnSoftness((path,))), ("add pose", c.AddPose)]
)
def test_a_mesh_in_another_pose_is_asked_for_among_those_beside_the_mesh(
    clerk: Clerk,
    person: Person,
    tmp_path: Path,
    name: str,
    command: Callable[[Path], c.Command],
) -> None:
    files = FileDialogs(clerk)
    for _ in range(2):
        assert files.act(name, person.editor) is None, "it asks every time"
        question = clerk.asked[-1]
        assert not question.saves
        assert question.path == tmp_path
        assert set(question.kinds[0].suffixes) == set(FORMATS), "no session"
    clerk.path = tmp_path / "bent.glb"
    assert files.poll(person.editor) == command(tmp_path / "bent.glb")


@pytest.mark.parametrize(
    ("name", "proposed"), [("turntable", "m-turntable.mp4"), ("record", "m-recording.mp4")]
)
def test_a_film_goes_where_a_dialog_says_and_its_suffix_tells_its_kind(
    clerk: Clerk, person: Person, tmp_path: Path, name: str, proposed: str
) -> None:
    pytest.importorskip("av")
    files = FileDialogs(clerk)
    for _ in range(2):
        assert files.act(name, person.editor) is None, "it asks every time"
        assert clerk.asked[-1].saves
        assert clerk.asked[-1].path == tmp_path / proposed
        assert clerk.asked[-1].kinds[0].suffixes == (".gif", ".mp4")
    for typed, path in (("a.gif", "a.gif"), ("a.mp4", "a.mp4"), ("a", "a.mp4")):
        clerk.path = tmp_path / typed
        assert files.poll(person.editor) == TakeFilm(name, tmp_path / path, typed == path)
    (tmp_path / proposed).touch()
    files.act(name, person.editor)
    number = proposed.replace(".mp4", "-2.mp4")
    assert clerk.asked[-1].path == tmp_path / number, "nothing is replaced by an Enter"


def test_a_dialog_does_not_say_that_a_file_is_the_mesh_that_is_open(
    clerk: Clerk, person: Person, tmp_path: Path
) -> None:
    files = FileDialogs(clerk)
    for purpose in ("export", "export poses"):
        files.act(purpose, person.editor)
        clerk.path = tmp_path / "m.ply"
        command = files.poll(person.editor)
        assert isinstance(command, c.Export | c.ExportPoses)
        assert not command.replace


def test_a_dialog_ends_with_the_document_that_it_is_about(person: Person) -> None:
    """Else its answer, given for one document, would write another over the file."""
    shown: list[str] = []

    def program(question: Question) -> list[str]:
        shown.append(question.purpose)
        return [sys.executable, "-c", "input()"]

    files = FileDialogs(Dialogs(program))
    for purpose in ("save", "export"):
        files.act(purpose, person.editor)
        files.forget()
        assert files.poll(person.editor) is None
    files.close()
    assert shown == ["save", "export"]
