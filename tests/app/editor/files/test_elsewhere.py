"""Where a file cannot be written, another folder is proposed, and nothing is lost."""

from __future__ import annotations

from pathlib import Path

import pytest

from app.editor import commands as c
from tests.app.person import Person, slab


@pytest.fixture
def bar(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Person:
    """A bar of a folder that is gone; the person stands in another."""
    monkeypatch.chdir(tmp_path)
    person = Person(slab(20, 4, 2.0), tmp_path / "gone" / "bar.obj")
    person.ready_bar()
    return person


@pytest.mark.parametrize(
    ("command", "name"),
    [(c.SaveSession(), "bar.json"), (c.Export(), "bar-deformed.obj")],
)
def test_it_is_saved_in_another_folder_where_a_person_says_so(
    bar: Person, tmp_path: Path, command: c.Command, name: str
) -> None:
    (tmp_path / name).write_text("somebody else's")
    spare = (tmp_path / name).with_stem(f"{Path(name).stem}-2")
    bar.do(command)
    question = bar.editor.question
    assert question is not None
    assert f"{tmp_path / 'gone' / name}: cannot be written" in question.text
    assert f"Save it as {spare} instead?" in question.text
    assert not spare.exists()
    bar.answer("Save there")
    assert spare.exists()
    assert (tmp_path / name).read_text() == "somebody else's"


def test_where_they_do_not_it_stays_unsaved(bar: Person, tmp_path: Path) -> None:
    bar.do(c.SaveSession())
    bar.answer("Cancel")
    assert bar.editor.dirty
    assert list(tmp_path.iterdir()) == []


def test_without_another_folder_it_is_an_error(
    bar: Person, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("cwd", "home"):
        monkeypatch.setattr(Path, name, lambda: tmp_path / "nowhere")
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path / "nowhere"))
    bar.do(c.SaveSession())
    message = bar.editor.message
    assert message is not None
    assert message.kind == "error"
    assert "bar.json: cannot be written" in message.text
    assert bar.editor.question is None
