"""What waits for the solver: the window goes on meanwhile, and it is of the document as it was."""

from __future__ import annotations

import os
import signal
import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from app.editor import commands as c
from app.model.handles import Pose
from app.worker import pulse
from app.worker.client import ProcessWorker
from tests.app.editor.waiting import BESIDE, asked, bent, is_over, saved, text, until
from tests.app.person import IdleWorker, Person, error_of, slab, state, transforms
from tests.app.worker.work import POSIX, WAIT, frozen, is_gone, stop


@pytest.fixture
def real(tmp_path: Path, solver_process: ProcessWorker) -> Person:
    """The bar, bent, with a real process behind it."""
    return bent(tmp_path, solver_process)


@pytest.fixture
def solver_process() -> Iterator[ProcessWorker]:
    made = ProcessWorker()
    yield made
    made.close()


def test_what_is_at_rest_is_exported_without_the_solver(tmp_path: Path) -> None:
    person = Person(slab(20, 4, 2.0), worker=IdleWorker())
    person.frame(BESIDE)
    person.do(c.Export(tmp_path / "out.obj"))
    np.testing.assert_array_equal(saved(tmp_path / "out.obj"), person.editor.document.mesh.vertices)


@POSIX
@pytest.mark.parametrize("change", ["nothing", "pose", "bind", "rest", "mesh"])
def test_an_export_is_of_the_document_as_it_was(real: Person, tmp_path: Path, change: str) -> None:
    editor, worker = real.editor, real.editor.worker
    assert isinstance(worker, ProcessWorker)
    with frozen(worker):
        editor.execute(c.SetSetting("bending_length", 0.3))
        expected = asked(real)
        editor.execute(c.Export(tmp_path / "out.obj"))
        real.frame(BESIDE)
        if change == "pose":
            real.stroke([16, 8, 0], [14, 9, 0])
        elif change == "bind":
            editor.execute(c.SetSetting("bending_length", 0.01))
        elif change == "rest":
            with editor.edit("Rest") as gesture:
                gesture.change("rest", editor.document.new_rest(2 * editor.positions))
                gesture.change("pose", Pose())
        elif change == "mesh":
            editor.execute(c.OpenMesh(tmp_path / "bar.obj"))
        assert editor.tasks.now is not None
        assert not (tmp_path / "out.obj").exists()
    until(real, is_over(real))
    assert text(real) == f"Exported {tmp_path / 'out.obj'}"
    np.testing.assert_allclose(saved(tmp_path / "out.obj"), expected, atol=1e-8)
    editor.settle()
    np.testing.assert_allclose(
        editor.positions,
        asked(real) if change != "mesh" else saved(tmp_path / "bar.obj"),
        atol=1e-8,
    )


@POSIX
def test_a_stopped_solver_keeps_nobody_from_working(real: Person, tmp_path: Path) -> None:
    """Painting, dragging, asking for an export and taking that back: none of it waits."""
    editor, worker = real.editor, real.editor.worker
    assert isinstance(worker, ProcessWorker)
    with frozen(worker):
        real.use("softness", 2.0)
        real.stroke([10, 2, 0], [10, 3, 0])
        real.use("drag")
        real.stroke([16, 8, 0], [15, 9, 0])
        own = editor.document.vertices_of(editor.document.handles[0].key)
        (T,) = transforms(editor.document)
        moved = editor.document.mesh.vertices[own] @ T[:3, :3].T + T[:3, 3]
        np.testing.assert_allclose(editor.positions[own], moved, atol=1e-8)
        editor.execute(c.Export(tmp_path / "out.obj"))
        for _ in range(20):
            real.frame(BESIDE)
        assert editor.tasks.now is not None
        before = state(editor.document)
        editor.execute(c.CancelGesture())
        assert text(real) == "Exporting out.obj was cancelled"
        assert state(editor.document) == before
    real.do(c.Export(tmp_path / "out.obj"))
    np.testing.assert_allclose(saved(tmp_path / "out.obj"), asked(real), atol=1e-8)


@POSIX
def test_an_export_goes_on_with_the_solver_that_replaces_a_stopped_one(
    real: Person, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(pulse, "SILENCE", 1.0)
    worker = real.editor.worker
    assert isinstance(worker, ProcessWorker)
    stop(worker)
    real.editor.execute(c.SetSetting("bending_length", 0.3))
    real.editor.execute(c.Export(tmp_path / "out.obj"))
    until(real, lambda: real.editor.message is not None)
    assert text(real) == "The solver did not answer and was started again"
    until(real, is_over(real))
    np.testing.assert_allclose(saved(tmp_path / "out.obj"), asked(real), atol=1e-8)


@POSIX
def test_closing_waits_for_no_solver_and_says_what_was_not_done(
    real: Person, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    worker = real.editor.worker
    assert isinstance(worker, ProcessWorker)
    pid = worker.pid
    assert pid is not None
    os.kill(pid, signal.SIGSTOP)
    real.editor.execute(c.SetSetting("bending_length", 0.3))
    real.editor.execute(c.Export(tmp_path / "out.obj"))
    real.editor.close()
    assert is_gone(pid)
    assert capsys.readouterr().err == "Exporting out.obj was not finished\n"
    assert not (tmp_path / "out.obj").exists()


@POSIX
def test_a_rest_shape_is_made_of_what_was_seen_and_no_drag_is_cut_short(real: Person) -> None:
    editor, worker = real.editor, real.editor.worker
    assert isinstance(worker, ProcessWorker)
    with frozen(worker):
        editor.execute(c.SetSetting("bending_length", 0.3))
        expected = asked(real)
        editor.execute(c.MakeRest())
        drag = real.hold([[16, 8, 0], [15, 9, 0], [14, 9, 0], [13, 9, 0]])
        next(drag), next(drag)
    deadline = time.monotonic() + WAIT
    while editor.worker.busy or editor.worker.binding:
        assert time.monotonic() < deadline
        real.frame([15, 9, 0], "d")
    assert editor.captures
    assert editor.document.rest is None
    list(drag)
    real.frame([13, 9, 0], "r")
    until(real, is_over(real))
    np.testing.assert_allclose(editor.document.rest_positions, expected, atol=1e-8)
    labels = [entry.label for entry in editor.history.done[-2:]]
    assert labels == ["Drag handle 1", "Make rest shape"]
    real.do(c.Undo(), c.Undo())
    assert editor.document.rest is None


@POSIX
def test_no_rest_shape_is_made_of_another_one(real: Person) -> None:
    editor, worker = real.editor, real.editor.worker
    assert isinstance(worker, ProcessWorker)
    with frozen(worker):
        editor.execute(c.SetSetting("bending_length", 0.3))
        editor.execute(c.MakeRest())
        with editor.edit("Rest") as gesture:
            gesture.change("rest", editor.document.new_rest(2 * editor.positions))
        before = state(editor.document)
    until(real, is_over(real))
    assert error_of(real) == "the rest shape has changed meanwhile: none was made"
    assert state(editor.document) == before
