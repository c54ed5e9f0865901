"""What of unsaved work is found again, and what is tidied up."""

from __future__ import annotations

import json
import multiprocessing
import os
import time
from pathlib import Path

import pytest

from app.model.document import Document
from app.model.schema import SessionError
from app.model.session.unsaved import holds
from app.unsaved import places
from app.unsaved.lock import Lock
from app.unsaved.places import PLACE, clean_up, kept_work, lock_path, new_file, read_unsaved
from solver.storage import write_atomically
from tests.app.person import slab

UNSAVED = {"at": "2026-01-01T12:00", "mesh": "/m.obj", "holds": "1 handle"}
DAY = 24 * 3600


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv(PLACE, str(tmp_path / "state"))
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path / "temporary"))
    (tmp_path / "state").mkdir()
    return tmp_path / "state"


def put(folder: Path, days: float, name: str = "") -> Path:
    path = folder / (name or f"m-{days}.json")
    path.write_text(f'{{\n "format": "f",\n "unsaved": {json.dumps(UNSAVED)}\n}}\n')
    os.utime(path, (time.time() - days * DAY,) * 2)
    return path


def found() -> list[Path]:
    """What is kept; nobody holds it afterwards."""
    kept = kept_work()
    for one in kept:
        one.lock.release()
    return [one.path for one in kept]


def test_the_last_work_comes_first(folder: Path) -> None:
    paths = [put(folder, days) for days in (3, 1, 2)]
    assert found() == [paths[1], paths[2], paths[0]]


def test_only_what_is_old_and_one_of_many_is_removed(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(places, "MOST", 3)
    old = [put(folder, days) for days in (40, 50)]
    clean_up()
    assert found() == old, "few are kept for ever"
    young = [put(folder, days) for days in (1, 2, 3, 29)]
    clean_up()
    assert found() == young, "never a younger one"


def test_work_that_a_running_window_holds_is_neither_found_nor_removed(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(places, "MOST", 0)
    path = put(folder, 60)
    lock = Lock.take(lock_path(path))
    assert lock is not None
    clean_up()
    assert found() == []
    assert path.exists()
    lock.release()
    clean_up()
    assert not path.exists()


def test_what_is_no_unsaved_work_is_left_alone(folder: Path) -> None:
    for name, text in (("a.json", "{"), ("b.json", '{\n "format": "f"\n}'), ("c.txt", "")):
        (folder / name).write_text(text)
    (folder / "d.json").write_bytes(b"\xff" * 100)
    clean_up()
    assert found() == []
    assert len(list(folder.iterdir())) == 4
    with pytest.raises(SessionError, match=r"b.json: expected unsaved work"):
        read_unsaved(folder / "b.json")


@pytest.mark.skipif(not hasattr(os, "getuid"), reason="folders have no owners there")
def test_a_folder_of_somebody_else_is_not_read(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    put(folder, 1)
    monkeypatch.setattr(os, "getuid", lambda: folder.stat().st_uid + 1)
    assert found() == []


def test_locks_and_half_written_files_of_windows_that_were_killed_go(folder: Path) -> None:
    process = multiprocessing.get_context("spawn").Process(target=_die_holding, args=(folder,))
    process.start()
    process.join()
    assert sorted(path.suffix for path in folder.iterdir()) == [".lock", ".tmp"]
    clean_up()
    assert list(folder.iterdir()) == []


def _die_holding(folder: Path) -> None:
    path, _lock = new_file(folder, "m")
    os.replace = lambda *_: os.kill(os.getpid(), 9) if os.name == "posix" else os._exit(1)
    write_atomically(path, b"half")


def test_a_lock_has_one_holder_at_a_time(tmp_path: Path) -> None:
    first = Lock.take(tmp_path / "lock")
    assert first is not None
    assert Lock.take(tmp_path / "lock") is None
    first.release()
    second = Lock.take(tmp_path / "lock")
    assert second is not None
    second.release()
    assert not (tmp_path / "lock").exists()


def test_what_a_document_holds_in_words() -> None:
    document = Document(slab(3, 3, 1.0), Path("m.obj"))
    assert holds(document) == "settings only"
    pin, hand = document.new_handle(pin=True), document.new_handle("hand")
    document.change("handles", (pin, hand))
    document.role[:2] = 1
    document.softness[:] = 0.5
    document.change("poses", (document.new_pose(document.pose),))
    document.change("rest", document.new_rest(document.mesh.vertices))
    assert holds(document) == (
        "1 handle, 1 pin, 2 fixed vertices, 1 kept pose, softness, a rest shape"
    )
