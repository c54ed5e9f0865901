"""The surface on screen follows the document: binds, hints, settings, failures."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from app.editor import commands as c
from app.live.live_surface import BindError
from app.model.document import Document
from app.tools.table import TOOLS
from app.worker.requests import BindRequest
from solver import Mesh
from tests.app.person import IdleWorker, Person, error_of, sheet, slab


def test_the_hint_names_what_is_missing(bar: Person) -> None:
    editor = bar.editor
    assert "Paint a handle" in editor.hint
    bar.use("drag")
    assert editor.hint == TOOLS["drag"].hint
    bar.use("handle", 1.6)
    bar.stroke([20, 0, 0], [20, 4, 0])
    editor.settle()
    assert "nothing is fixed" in editor.hint
    assert "drag tool" in editor.hint
    bar.use("fixed", 1.6)
    bar.stroke([0, 0, 0])
    editor.settle()
    bar.use("drag")
    assert editor.hint == TOOLS["drag"].hint


def test_the_hint_says_that_a_bind_is_running() -> None:
    person = Person(slab(20, 4, 2.0), worker=IdleWorker())
    person.use("handle", 2)
    person.stroke([10, 2, 0])
    assert person.editor.hint == "Binding ..."


def test_a_bind_is_asked_for_when_a_stroke_ends_and_only_if_it_matters(
    ready: Person, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked: list[BindRequest] = []
    monkeypatch.setattr(ready.editor.worker, "request", asked.append)
    ready.use("fixed", 1)
    for _ in ready.hold([[5, 2, 0], [6, 2, 0]]):
        assert not asked
    ready.frame([6, 2, 0], "r")
    assert len(asked) == 1
    ready.frame([7, 2, 0])
    ready.do(c.SetSetting("rigid", 0), c.SetMap("softness"), c.AddHandle())
    assert len(asked) == 1
    for command in (
        c.SetSetting("bending_length", 0.02),
        c.SetSetting("orientation", False),
        c.SetMaterial("clay"),
        c.ClearFixed(),
        c.Undo(),
    ):
        asked.clear()
        ready.do(command)
        assert len(asked) == 1


def test_without_any_handle_the_surface_is_at_rest(ready: Person) -> None:
    ready.stroke([19, 2, 0], [16, 8, 0])
    ready.do(c.RemoveHandle(ready.editor.document.handles[0].key))
    np.testing.assert_array_equal(ready.editor.positions, ready.editor.document.mesh.vertices)
    ready.do(c.Undo())
    ready.editor.settle()
    assert np.abs(ready.editor.positions - ready.editor.document.mesh.vertices).max() > 1


def test_settings_change_the_surface_on_screen(ready: Person) -> None:
    ready.stroke([19, 2, 0], [8, 10, 0])
    shown = ready.editor.positions
    for command in (c.SetSetting("rigid", 0), c.SetSetting("bending_length", 0.1)):
        version = ready.editor.positions_version
        ready.do(command)
        ready.editor.settle()
        assert ready.editor.positions_version != version
        assert np.abs(ready.editor.positions - shown).max() > 1e-6
        shown = ready.editor.positions


def test_versions_change_exactly_with_what_they_stand_for(ready: Person) -> None:
    editor = ready.editor
    colors, positions = editor.colors_version, editor.positions_version
    ready.frame([10, 2, 0])
    assert (editor.colors_version, editor.positions_version) == (colors, positions)
    ready.stroke([19, 2, 0], [18, 4, 0])
    assert editor.positions_version != positions
    assert editor.colors_version == colors
    ready.do(c.SetMap("softness"))
    assert editor.colors_version != colors


def test_a_failed_bind_is_a_message_and_the_last_one_stays(ready: Person, tmp_path: Path) -> None:
    bound = ready.editor.surface.bound
    with ready.editor.edit("Wrong") as gesture:
        gesture.change("softness", 2.0, np.array([0]))
    with pytest.raises(BindError, match="Binding failed"):
        ready.editor.settle()
    assert "Binding failed" in error_of(ready)
    assert ready.editor.hint == error_of(ready)
    assert ready.editor.surface.bound is bound
    ready.do(c.Export(tmp_path / "out.obj"))
    assert "Binding failed" in error_of(ready)
    assert not (tmp_path / "out.obj").exists()
    ready.do(c.Undo())
    ready.editor.settle()
    assert ready.editor.surface.bound is not bound


def test_one_vertex_can_be_a_handle_and_be_dragged() -> None:
    person = Person(Mesh.from_arrays(*sheet(12, 6)))
    person.use("fixed", 1.2)
    person.stroke([0, 0, 0], [0, 6, 0])
    person.use("handle", 0.1)
    person.stroke([10, 3, 0])
    person.editor.settle()
    document = person.editor.document
    assert len(document.vertices_of(document.handles[0].key)) == 1
    person.use("drag")
    person.stroke([10, 3, 0], [9, 5, 0])
    assert np.isfinite(person.editor.positions).all()
    np.testing.assert_allclose(
        person.editor.positions[document.vertices_of(document.handles[0].key)],
        [[9, 5, 0]],
        atol=1e-4,
    )
    person.editor.close()


def test_documents_do_not_share_state() -> None:
    one, two = (Document(slab(3, 3, 1.0), Path("a.obj")) for _ in range(2))
    one.change("role", 1, np.array([0, 1]))
    assert not two.role.any()
    assert one.serial != two.serial
