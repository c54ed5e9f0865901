"""Unsaved work is kept in time, whatever a person is doing, and wherever there is room."""

from __future__ import annotations

import json
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from app.editor import commands as c
from app.model.session.reading import read_session
from app.unsaved import file as unsaved_file
from app.unsaved.keeper import MANY, Keeper
from app.unsaved.places import PLACE, kept_work
from solver.errors import FileError
from solver.storage import write_atomically
from tests.app.person import Person, slab, transforms


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Where unsaved work is kept."""
    monkeypatch.setenv(PLACE, str(tmp_path / "state"))
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path / "temporary"))
    return tmp_path / "state"


@pytest.fixture
def bar(tmp_path: Path) -> Person:
    """A bar whose session is saved."""
    mesh = slab(20, 4, 2.0)
    mesh.save(tmp_path / "bar.obj", mesh.vertices)
    person = Person(mesh, tmp_path / "bar.obj")
    person.ready_bar()
    person.do(c.SaveSession())
    return person


@pytest.fixture
def keeper(bar: Person, folder: Path) -> Iterator[Keeper]:
    """Of the bar, with all the patience in the world."""
    keeper = Keeper(bar.editor, 3600)
    yield keeper
    keeper.close()


def step_until_kept(keeper: Keeper, folder: Path) -> dict[str, Any]:
    """What the only file of unsaved work holds, once it is there."""
    deadline = time.monotonic() + 20
    while not (files := list(folder.glob("*.json"))):
        assert time.monotonic() < deadline
        keeper.step()
    return dict(json.loads(files[0].read_text()))


def names(folder: Path) -> list[str]:
    return sorted(path.name for path in folder.glob("*"))


def test_changes_are_kept_after_a_while_and_say_what_they_are(bar: Person, folder: Path) -> None:
    keeper = Keeper(bar.editor, 0.01)
    keeper.step()
    assert not folder.exists()
    bar.do(c.AddHandle("one"), c.SetSetting("rigid", 2))
    held = step_until_kept(keeper, folder)
    mesh = bar.editor.document.path.resolve()
    assert held["unsaved"].pop("at")
    assert held["unsaved"] == {
        "mesh": str(mesh),
        "session": str(mesh.with_suffix(".json")),
        "holds": f"2 handles, {len(bar.editor.document.fixed)} fixed vertices",
    }
    assert [handle["name"] for handle in held["handles"]] == ["handle 1", "one"]
    assert held["settings"]["rigid"] == 2
    keeper.close()


def test_much_work_is_kept_before_its_time(bar: Person, keeper: Keeper, folder: Path) -> None:
    for number in range(MANY - 1):
        bar.do(c.SetSetting("rigid", number % 2 + 2), c.KeepPose())
        keeper.step()
        keeper.step()
        bar.editor.history.seal()
    assert not folder.exists()
    bar.do(c.AddHandle())
    step_until_kept(keeper, folder)


def test_a_move_that_no_button_holds_is_kept(bar: Person, keeper: Keeper) -> None:
    bar.frame([10, 2, 0])
    bar.do(c.MoveHandles())
    bar.frame([10, 4, 0])
    (moved,) = transforms(bar.editor.document)
    assert not np.array_equal(moved, np.eye(4))
    kept = keeper.keep()
    assert kept is not None
    handles = read_session(kept).data["handles"]
    np.testing.assert_allclose(handles[0]["transform"], moved, atol=1e-12)


def test_what_is_saved_is_not_kept(bar: Person, keeper: Keeper, folder: Path) -> None:
    assert keeper.keep() is None
    bar.do(c.AddHandle("one"))
    kept = keeper.keep()
    assert kept is not None
    assert kept.parent == folder
    bar.do(c.SaveSession())
    keeper.step()
    assert names(folder) == []
    assert keeper.keep() is None
    bar.do(c.Undo())
    assert keeper.keep() is not None, "the saved session holds something else now"


def test_what_was_dismissed_is_gone_until_more_is_done(
    bar: Person, keeper: Keeper, folder: Path
) -> None:
    bar.do(c.AddHandle("one"))
    keeper.keep()
    keeper.dismiss()
    assert names(folder) == []
    assert keeper.keep() is None
    bar.do(c.AddHandle("two"))
    assert keeper.keep() is not None


def test_nobody_else_gets_what_a_window_has_open(bar: Person, keeper: Keeper, folder: Path) -> None:
    bar.do(c.AddHandle("one"))
    kept = keeper.keep()
    assert kept_work() == []
    keeper.close()
    (found,) = kept_work()
    assert found.path == kept
    assert kept_work() == [], "it is held already"
    found.lock.release()
    assert names(folder) == [found.path.name]


def test_work_that_is_gone_on_with_is_unsaved_and_stays_one_file(
    bar: Person, keeper: Keeper, folder: Path
) -> None:
    bar.do(c.AddHandle("one"))
    keeper.keep()
    keeper.close()
    (found,) = kept_work()
    before = bar.editor.document.role.tolist()
    bar.do(c.ContinueWork(found.path))
    keeper.follow(found)
    assert bar.editor.dirty
    assert bar.editor.session_path == bar.editor.document.path.with_suffix(".json")
    assert bar.editor.document.role.tolist() == before
    bar.do(c.AddHandle("two"))
    assert keeper.keep() == found.path
    bar.do(c.SaveSession())
    keeper.step()
    assert names(folder) == []


def test_a_mesh_that_is_gone_is_named_and_the_work_stays(
    bar: Person, keeper: Keeper, folder: Path
) -> None:
    bar.do(c.AddHandle("one"))
    kept = keeper.keep()
    assert kept is not None
    mesh = bar.editor.document.path
    mesh.rename(mesh.with_name("away.obj"))
    before = bar.editor.document
    bar.do(c.ContinueWork(kept))
    assert bar.editor.document is before
    message = bar.editor.message
    assert message is not None
    assert message.kind == "error"
    assert str(mesh.resolve()) in message.text
    assert kept.exists()


def test_a_mesh_that_has_changed_is_asked_about(bar: Person, keeper: Keeper) -> None:
    bar.do(c.AddHandle("one"))
    kept = keeper.keep()
    assert kept is not None
    mesh = slab(20, 4, 3.0)
    mesh.save(bar.editor.document.path, mesh.vertices)
    bar.do(c.ContinueWork(kept))
    assert bar.editor.question is not None
    assert "has changed since" in bar.editor.question.text
    bar.answer("Keep by vertex number")
    assert [handle.name for handle in bar.editor.document.handles] == ["handle 1", "one"]
    assert bar.editor.dirty


def test_where_the_folder_takes_none_another_one_does_and_is_named(
    bar: Person, folder: Path, tmp_path: Path
) -> None:
    folder.write_text("no folder")
    (tmp_path / "temporary").mkdir()
    keeper = Keeper(bar.editor, 1e-9)
    bar.do(c.AddHandle("one"))
    deadline = time.monotonic() + 20
    while bar.editor.message is None or "kept in" not in bar.editor.message.text:
        assert time.monotonic() < deadline
        keeper.step()
    keeper.close()
    (found,) = kept_work()
    assert found.path.is_relative_to(tmp_path / "temporary")
    assert str(folder) in bar.editor.message.text
    assert str(found.path) in bar.editor.message.text
    found.lock.release()


def test_a_disk_that_is_full_moves_the_work_and_loses_none(
    bar: Person, keeper: Keeper, folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "temporary").mkdir()
    bar.do(c.AddHandle("one"))
    keeper.keep()

    def full(path: Path, data: bytes) -> None:
        if path.is_relative_to(folder):
            raise FileError(f"{path}: cannot be written: No space left on device")
        write_atomically(path, data)

    monkeypatch.setattr(unsaved_file, "write_atomically", full)
    bar.do(c.AddHandle("two"))
    kept = keeper.keep()
    assert kept is not None
    assert kept.is_relative_to(tmp_path / "temporary")
    assert len(read_session(kept).data["handles"]) == 3
    assert names(folder) == [], "what is older is not offered beside it"


def test_where_nothing_can_be_written_it_says_so(
    bar: Person, keeper: Keeper, folder: Path, tmp_path: Path
) -> None:
    folder.write_text("no folder")
    (tmp_path / "temporary").write_text("nor here")
    bar.do(c.AddHandle("one"))
    with pytest.raises(FileError, match=r"unsaved work cannot be kept: .*state"):
        keeper.keep()
