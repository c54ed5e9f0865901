"""Frames go on while a file is written, which can be cancelled, and is whole or as before."""

from __future__ import annotations

import threading
from pathlib import Path

import numpy as np
import pytest

from app.editor import commands as c
from solver import Mesh
from tests.app.editor.waiting import bent, is_over, saved, text, until
from tests.app.inline import SlowWorker
from tests.app.person import Person, error_of
from tests.app.worker.work import WAIT


@pytest.fixture
def slow(tmp_path: Path) -> Person:
    """The bar, bent; its worker takes its time with what is asked beside the surface."""
    return bent(tmp_path, SlowWorker())


class HeldSave:
    """Saves a mesh, once it may."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.begun, self.may = threading.Event(), threading.Event()
        save = Mesh.save

        def held(mesh: Mesh, *arguments: object, **more: object) -> None:
            self.begun.set()
            assert self.may.wait(WAIT)
            save(mesh, *arguments, **more)  # type: ignore[arg-type]

        monkeypatch.setattr(Mesh, "save", held)


def test_frames_go_on_while_a_file_is_written(
    slow: Person, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    shown, held = slow.editor.positions, HeldSave(monkeypatch)
    slow.editor.execute(c.Export(tmp_path / "out.obj", replace=True))
    assert held.begun.wait(WAIT)
    slow.stroke([16, 8, 0], [14, 9, 0])
    assert not np.array_equal(slow.editor.positions, shown)
    held.may.set()
    until(slow, is_over(slow))
    np.testing.assert_allclose(saved(tmp_path / "out.obj"), shown, atol=1e-8)


def test_a_file_that_is_being_written_is_whole_when_the_window_is_closed(
    slow: Person, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    shown, held = slow.editor.positions, HeldSave(monkeypatch)
    slow.editor.execute(c.Export(tmp_path / "out.obj", replace=True))
    assert held.begun.wait(WAIT)
    held.may.set()
    slow.editor.close()
    np.testing.assert_allclose(saved(tmp_path / "out.obj"), shown, atol=1e-8)


def test_one_that_is_cancelled_while_it_is_written_leaves_the_old_file(
    slow: Person, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "out.obj").write_text("old")
    held = HeldSave(monkeypatch)
    slow.editor.execute(c.Export(tmp_path / "out.obj", replace=True))
    assert held.begun.wait(WAIT)
    slow.editor.execute(c.CancelGesture())
    held.may.set()
    until(slow, is_over(slow))
    assert text(slow) == "Exporting out.obj was cancelled"
    assert [path.name for path in tmp_path.iterdir() if path.name != "bar.obj"] == ["out.obj"]
    assert (tmp_path / "out.obj").read_text() == "old"


def test_escape_takes_back_a_drag_first_and_the_button_the_export(
    slow: Person, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    held, pose = HeldSave(monkeypatch), slow.editor.document.pose
    slow.editor.execute(c.Export(tmp_path / "out.obj", replace=True))
    for _ in slow.hold([[16, 8, 0], [14, 9, 0]]):
        pass
    slow.editor.execute(c.CancelGesture())
    assert slow.editor.document.pose == pose
    assert slow.editor.tasks.now is not None
    for _ in slow.hold([[16, 8, 0], [14, 9, 0]]):
        pass
    slow.editor.execute(c.CancelTask())
    assert slow.editor.captures
    held.may.set()
    until(slow, is_over(slow))
    assert text(slow) == "Exporting out.obj was cancelled"


@pytest.mark.parametrize("command", [c.Export, c.ExportPoses])
def test_what_is_no_mesh_is_refused_before_anybody_waits_or_is_asked(
    slow: Person, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, command: type[c.Export]
) -> None:
    slow.do(c.KeepPose())
    (tmp_path / "notes.txt").write_text("mine")
    held = HeldSave(monkeypatch)
    slow.editor.execute(c.Export(tmp_path / "out.obj"))
    slow.editor.execute(command(tmp_path / "notes.txt"))
    assert slow.editor.question is None
    assert "unknown mesh format '.txt'" in error_of(slow)
    held.may.set()
    until(slow, is_over(slow))
    assert (tmp_path / "notes.txt").read_text() == "mine"
