"""An export is on its way while other things happen: each gets what it was asked for."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from app.editor import commands as c
from app.editor.question import CANCEL, Answer, Question
from solver import Mesh
from solver.errors import FileError
from tests.app.editor.waiting import is_over, saved, text, until
from tests.app.person import Person, error_of, question_of, slab
from tests.app.worker.work import WAIT

REPLACE = Question("Replace it?", (Answer("Yes", c.SetTool("fixed")), CANCEL))


@pytest.fixture
def gate(monkeypatch: pytest.MonkeyPatch) -> Iterator[threading.Event]:
    """As long as it is shut, meshes take their time to be written."""
    gate, save = threading.Event(), Mesh.save

    def slowly(*arguments: Any) -> None:
        gate.wait(WAIT)
        save(*arguments)

    monkeypatch.setattr(Mesh, "save", slowly)
    yield gate
    gate.set()


@pytest.fixture
def bar(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Person:
    """A bar at rest, and another mesh beside it."""
    monkeypatch.chdir(tmp_path)
    for length in (20, 10):
        mesh = slab(length, 4, 2.0)
        mesh.save(tmp_path / f"bar{length}.obj", mesh.vertices)
    person = Person(slab(20, 4, 2.0), tmp_path / "bar20.obj")
    return person


def test_no_other_mesh_is_proposed_in_place_of_one_that_could_not_be_written(
    bar: Person, tmp_path: Path, gate: threading.Event
) -> None:
    bar.editor.execute(c.Export(tmp_path / "gone" / "out.obj"))
    bar.editor.execute(c.OpenMesh(tmp_path / "bar10.obj"))
    gate.set()
    until(bar, is_over(bar))
    assert bar.editor.question is None
    assert "out.obj: cannot be written" in error_of(bar)


def test_a_question_of_an_export_waits_until_the_one_that_stands_is_answered(
    bar: Person, tmp_path: Path, gate: threading.Event
) -> None:
    bar.editor.execute(c.Export(tmp_path / "gone" / "out.obj"))
    bar.editor.ask(REPLACE)
    gate.set()
    until(bar, is_over(bar))
    assert bar.editor.question is REPLACE
    bar.answer("Yes")
    bar.frame()
    assert "out.obj: cannot be written" in question_of(bar)
    bar.answer("Save there")
    assert bar.editor.tool == "fixed"
    assert len(saved(tmp_path / "out.obj")) == len(bar.editor.positions)


def test_at_the_end_nobody_is_asked_but_what_went_wrong_is_told(
    bar: Person, tmp_path: Path, gate: threading.Event
) -> None:
    bar.editor.execute(c.Export(tmp_path / "gone" / "out.obj"))
    gate.set()
    with pytest.raises(FileError, match=r"out\.obj: cannot be written") as raised:
        bar.editor.close()
    assert "\n" not in str(raised.value)


def test_exports_of_one_name_to_several_folders_are_all_done(
    bar: Person, tmp_path: Path, gate: threading.Event
) -> None:
    paths = [tmp_path / folder / "out.obj" for folder in "abc"]
    for path in paths:
        path.parent.mkdir()
        bar.editor.execute(c.Export(path))
    gate.set()
    until(bar, is_over(bar))
    assert all(path.exists() for path in paths)


def test_exports_of_two_documents_are_both_done_and_asked_about(
    bar: Person, tmp_path: Path, gate: threading.Event
) -> None:
    out = tmp_path / "out.obj"
    bar.editor.execute(c.Export(tmp_path / "first.obj"))
    bar.editor.execute(c.Export(out))
    bar.editor.execute(c.OpenMesh(tmp_path / "bar10.obj"))
    bar.editor.execute(c.Export(out))
    gate.set()
    until(bar, is_over(bar))
    assert len(saved(out)) == len(slab(20, 4, 2.0).vertices)
    assert f"{out} is there already" in question_of(bar)
    bar.answer("Replace")
    assert len(saved(out)) == len(slab(10, 4, 2.0).vertices)


def test_a_file_that_came_meanwhile_is_not_replaced_when_nobody_can_be_asked(
    bar: Person, tmp_path: Path, gate: threading.Event
) -> None:
    out = tmp_path / "out.obj"
    bar.editor.execute(c.Export(tmp_path / "first.obj"))
    bar.editor.execute(c.Export(out))
    bar.editor.execute(c.OpenMesh(tmp_path / "bar10.obj"))
    out.write_text("somebody else's")
    gate.set()
    until(bar, is_over(bar))
    assert out.read_text() == "somebody else's"
    assert error_of(bar) == f"{out}: not exported, what is there is not to be replaced"


def test_poses_of_a_document_that_is_no_longer_open_go_where_they_were_to(
    bar: Person, tmp_path: Path, gate: threading.Event
) -> None:
    bar.ready_bar()
    bar.do(c.KeepPose("bent"))
    bar.editor.execute(c.ExportPoses(tmp_path / "out.obj"))
    bar.editor.execute(c.OpenMesh(tmp_path / "bar10.obj"))
    gate.set()
    until(bar, is_over(bar))
    out = tmp_path / "out.obj"
    assert text(bar).startswith(f"1 pose: Exported {out}, 1 file beside it")
    assert bar.editor.exported is None
    np.testing.assert_allclose(saved(tmp_path / "out.obj"), slab(20, 4, 2.0).vertices, atol=1e-6)
    bar.do(c.Export(tmp_path / "out.obj"))
    assert "is there already" in question_of(bar)
