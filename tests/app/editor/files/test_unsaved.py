"""What was not saved is kept, whatever a person was doing, and wherever there is room."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from app.editor import commands as c
from app.editor.file_actions import load_document
from app.editor.unsaved import keep_unsaved
from solver.errors import FileError
from tests.app.person import Person, slab, transforms


@pytest.fixture
def bar(tmp_path: Path) -> Person:
    """A bar whose session is saved."""
    mesh = slab(20, 4, 2.0)
    mesh.save(tmp_path / "bar.obj", mesh.vertices)
    person = Person(mesh, tmp_path / "bar.obj")
    person.ready_bar()
    person.do(c.SaveSession())
    return person


def test_work_kept_before_is_never_replaced(bar: Person, tmp_path: Path) -> None:
    for count in (1, 2, 3):
        bar.do(c.AddHandle(f"handle {count}"))
        keep_unsaved(bar.editor)
        assert len(list(tmp_path.glob("bar-unsaved*.json"))) == count


def test_a_move_that_no_button_holds_is_kept(bar: Person) -> None:
    bar.frame([10, 2, 0])
    bar.do(c.MoveHandles())
    bar.frame([10, 4, 0])
    (moved,) = transforms(bar.editor.document)
    assert not np.array_equal(moved, np.eye(4))
    kept = keep_unsaved(bar.editor)
    assert kept is not None
    np.testing.assert_allclose(transforms(load_document(None, kept))[0], moved, atol=1e-12)


def test_what_is_saved_is_not_kept_twice(bar: Person, tmp_path: Path) -> None:
    before = sorted(tmp_path.iterdir())
    assert keep_unsaved(bar.editor) is None
    assert sorted(tmp_path.iterdir()) == before


def test_where_the_folder_takes_none_another_one_does(
    bar: Person, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    bar.do(c.AddHandle("one"))
    bar.editor.session_path = tmp_path / "gone" / "mine.json"
    assert keep_unsaved(bar.editor) == tmp_path / "mine-unsaved.json"


def test_where_nothing_can_be_written_it_says_so(
    bar: Person, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(Path, "cwd", lambda: tmp_path / "gone")
    monkeypatch.setattr(Path, "home", lambda: tmp_path / "gone")
    bar.do(c.AddHandle("one"))
    bar.editor.session_path = tmp_path / "gone" / "mine.json"
    with pytest.raises(FileError, match=r"unsaved work could not be kept: .*gone"):
        keep_unsaved(bar.editor)
