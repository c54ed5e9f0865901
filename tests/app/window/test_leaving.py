"""What is asked when the window is to close, and what becomes of each answer."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from app.dialogs.dialogs import Dialogs
from app.dialogs.question import Question
from app.editor import commands as c
from app.unsaved.keeper import Keeper
from app.unsaved.places import PLACE
from app.window.file_dialogs import FileDialogs
from app.window.shortcuts import WindowAction
from app.window.unsaved.leaving import Leaving
from app.workspace.tasks import Steps
from tests.app.person import Person, question_of, slab


@pytest.fixture
def person(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Person]:
    """At a mesh without changes."""
    monkeypatch.setenv(PLACE, str(tmp_path / "state"))
    person = Person(slab(3, 3, 1.0), tmp_path / "bar.obj")
    yield person
    person.editor.tasks.close()


@pytest.fixture
def leaving(person: Person) -> Iterator[Leaving]:
    keeper = Keeper(person.editor, 3600)
    yield Leaving(person.editor, keeper, FileDialogs(Dialogs(None)))
    keeper.close()


def never() -> Steps[None]:
    while True:
        yield None


def press(person: Person, leaving: Leaving, label: str) -> None:
    """Answer, and let a frame go by."""
    question = person.editor.question
    assert question is not None
    (answer,) = (answer for answer in question.answers if answer.label == label)
    action = person.editor.answer(answer)
    if action is not None:
        assert isinstance(action, WindowAction)
        command = leaving.act(action.name)
        if command is not None:
            person.editor.execute(command)
    leaving.step()


def test_without_changes_it_closes_at_once(leaving: Leaving) -> None:
    leaving.request()
    assert leaving.ended


@pytest.mark.parametrize(("label", "ends"), [("Close", True), ("Cancel", False)])
def test_what_is_under_way_is_not_given_up_unasked(
    person: Person, leaving: Leaving, label: str, ends: bool
) -> None:
    person.editor.tasks.begin("Exporting out.obj", never())
    leaving.request()
    assert question_of(person) == "Exporting out.obj is not finished yet."
    assert not leaving.ended
    press(person, leaving, label)
    assert leaving.ended == ends
    assert person.editor.tasks.now is not None, "whoever ends the window ends it"


@pytest.mark.parametrize("label", ["Save", "Discard"])
def test_changes_are_asked_about_in_the_same_question(
    person: Person, leaving: Leaving, tmp_path: Path, label: str
) -> None:
    person.do(c.AddHandle("a"))
    person.editor.tasks.begin("Exporting out.obj", never())
    leaving.request()
    assert question_of(person).split("\n") == [
        "bar.obj has changes that are not saved.",
        "Exporting out.obj is not finished yet.",
    ]
    press(person, leaving, label)
    assert leaving.ended
    assert (tmp_path / "bar.json").exists() == (label == "Save")


def test_saving_asks_for_a_name_in_place_of_another_dialog(person: Person) -> None:
    def waits(question: Question) -> list[str]:
        asked.append(question.purpose)
        return [sys.executable, "-c", "import time; time.sleep(60)"]

    asked: list[str] = []
    files = FileDialogs(Dialogs(waits))
    leaving = Leaving(person.editor, Keeper(person.editor, 3600), files)
    person.do(c.AddHandle("a"))
    assert files.act("open", person.editor) is None
    leaving.request()
    press(person, leaving, "Save")
    assert asked == ["open", "save"]
    assert files.asking
    assert not leaving.ended
    files.close()
    leaving.step()
    assert not leaving.ended, "no name was given"


def test_closing_twice_ends_it_whatever_is_under_way(person: Person, leaving: Leaving) -> None:
    person.editor.tasks.begin("Exporting out.obj", never())
    leaving.request()
    leaving.request()
    assert leaving.ended
