from __future__ import annotations

import dataclasses
from pathlib import Path

import numpy as np
import pytest

from app.editor import commands as c
from app.editor.actions import ACTIONS
from app.model.document import Document
from app.tools.table import TOOLS
from app.tools.tool import brush_rim
from app.worker.requests import BindRequest
from app.workspace.live_surface import BindError
from solver import Mesh
from tests.app.person import IdleWorker, Person, sheet, slab, state

OFF_THE_MESH = [30.0, 2.0, 0.0]


def error_of(person: Person) -> str:
    message = person.editor.message
    assert message is not None
    assert message.kind == "error"
    assert "\n" not in message.text
    return message.text


@pytest.mark.parametrize("tool", ["fixed", "handle", "softness", "drag"])
def test_the_camera_is_captured_during_strokes_and_drags_only(ready: Person, tool: str) -> None:
    ready.use(tool)
    editor = ready.editor
    ready.frame([19, 2, 0])
    assert not editor.captures
    for _ in ready.hold([[19, 2, 0], [19, 3, 0], OFF_THE_MESH]):
        assert editor.captures
    ready.frame(None, "d")
    assert editor.captures
    ready.frame([19, 3, 0], "r")
    assert not editor.captures


@pytest.mark.parametrize("tool", list(TOOLS))
def test_a_press_beside_the_mesh_is_left_to_the_camera(ready: Person, tool: str) -> None:
    ready.use(tool)
    before = state(ready.editor.document)
    for _ in ready.hold([OFF_THE_MESH, [19, 2, 0], [10, 2, 0]]):
        assert not ready.editor.captures
        assert ready.editor.cursor is None
    ready.frame([10, 2, 0], "r")
    assert state(ready.editor.document) == before


def test_navigating_and_dragging_what_is_no_handle_are_left_to_the_camera(ready: Person) -> None:
    for tool, start in (("navigate", [19, 2, 0]), ("drag", [10, 2, 0]), ("drag", [0, 2, 0])):
        ready.use(tool)
        for _ in ready.hold([start, [12, 3, 0]]):
            assert not ready.editor.captures
        ready.frame(start, "r")


def test_a_quick_click_paints(bar: Person) -> None:
    bar.use("fixed", 1)
    bar.frame([10, 2, 0], "pr")
    assert not bar.editor.captures
    assert bar.editor.document.role.any()
    assert len(bar.editor.history.done) == 1


@pytest.mark.parametrize("end", ["tool", "undo", "lost", "press", "open"])
def test_a_gesture_in_progress_ends_cleanly(bar: Person, tmp_path: Path, end: str) -> None:
    bar.use("fixed", 1)
    history = bar.editor.history
    for _ in bar.hold([[5, 2, 0], [8, 2, 0]]):
        pass
    if end == "tool":
        bar.do(c.SetTool("navigate"))
    elif end == "undo":
        bar.do(c.Undo())
        assert not bar.editor.document.role.any()
    elif end == "lost":
        bar.frame([9, 2, 0])
    elif end == "open":
        bar.do(c.OpenMesh(tmp_path / "missing.obj"))
    else:
        bar.frame([15, 2, 0], "pd")
        bar.frame([15, 2, 0], "r")
        assert len(history.done) == 2
        return
    assert not bar.editor.captures
    assert len(history.done) + len(history.undone) == 1


def test_cancel_restores_what_was_before(ready: Person) -> None:
    before, entries = state(ready.editor.document), len(ready.editor.history.done)
    for tool in ("drag", "fixed", "handle", "softness"):
        ready.use(tool, 2)
        for _ in ready.hold([[19, 2, 0], [15, 3, 0]]):
            pass
        assert state(ready.editor.document) != before
        ready.do(c.CancelGesture())
        ready.frame([14, 3, 0], "d")
        ready.frame([14, 3, 0], "r")
        assert state(ready.editor.document) == before
        assert len(ready.editor.history.done) == entries
    np.testing.assert_array_equal(ready.editor.positions, ready.editor.document.mesh.vertices)


def test_the_brush_hovers_over_the_surface_with_painting_tools_only(ready: Person) -> None:
    for tool in TOOLS:
        ready.use(tool)
        ready.frame([10, 2, 0])
        assert (ready.editor.cursor is not None) == (TOOLS[tool].cursor is brush_rim)
    ready.use("fixed")
    ready.frame(OFF_THE_MESH)
    assert ready.editor.cursor is None


WRONG = [
    (c.SetTool("hammer"), "unknown tool 'hammer'"),
    (c.SetMap("heat"), "unknown map 'heat'"),
    (c.SetBrush(strength=float("nan")), "brush strength must be a number"),
    (c.SetSetting("colour", 1), "unknown setting 'colour'"),
    (c.SetSetting("bending_length", 0.0), "bending_length must be a positive number, got 0.0"),
    (c.SetSetting("orientation", 1), "orientation must be true or false"),
    (c.SetSetting("rigid", -1), "rigid must be an integer, 0 or more"),
    (c.SetMaterial("steel"), "unknown material 'steel'"),
    (c.RemoveHandle(-5), "no handle with key -5"),
    (c.OpenMesh(Path("no-such.obj")), "no-such.obj"),
    (c.OpenMesh(Path("no-such.xyz")), "unknown mesh format"),
    (c.OpenSession(Path("no-such.json")), "no-such.json"),
    (c.SaveSession(Path("no-such-folder/a.json")), "no-such-folder"),
    (c.Export(Path("no-such-folder/a.obj")), "no-such-folder"),
    (c.Export(Path("a.docx")), "unknown mesh format"),
]


@pytest.mark.parametrize(("command", "text"), WRONG, ids=[repr(w[0]) for w in WRONG])
def test_errors_are_messages_and_change_nothing(
    ready: Person, command: c.Command, text: str
) -> None:
    editor = ready.editor
    document, before = editor.document, state(editor.document)
    entries, positions = len(editor.history.done), editor.positions
    ready.do(command)
    assert text in error_of(ready)
    assert editor.document is document
    assert state(document) == before
    assert len(editor.history.done) == entries
    assert editor.positions is positions


def test_a_handle_keeps_a_name(ready: Person) -> None:
    handle = ready.editor.document.handles[0]
    ready.do(c.RenameHandle(handle.key, "  "))
    assert "name must not be empty" in error_of(ready)
    ready.do(c.RenameHandle(handle.key, " hand "))
    assert ready.editor.document.handles[0].name == "hand"


def test_every_command_has_a_handler() -> None:
    asked = [
        kind
        for kind in vars(c).values()
        if isinstance(kind, type) and issubclass(kind, c.Command) and kind is not c.Command
    ]
    assert set(asked) == set(ACTIONS)
    assert all(dataclasses.is_dataclass(kind) for kind in asked)


def test_brush_sliders_stay_in_range(bar: Person) -> None:
    bar.do(c.SetBrush(radius=1e9, strength=-3, value=7))
    assert (bar.editor.brush.strength, bar.editor.brush.value) == (0, 1)
    assert bar.editor.brush.radius <= 0.5
    bar.do(c.SetBrush(radius=0))
    assert bar.editor.brush.radius > 0


def test_the_hint_names_what_is_missing(bar: Person) -> None:
    editor = bar.editor
    assert "Paint a handle" in editor.hint
    bar.use("handle", 1.6)
    bar.stroke([20, 0, 0], [20, 4, 0])
    editor.settle()
    assert "nothing is fixed" in editor.hint
    assert "drag tool" in editor.hint
    bar.use("fixed", 1.6)
    bar.stroke([0, 0, 0])
    editor.settle()
    bar.use("drag")
    assert editor.hint == "Press on a handle and drag"


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
    ready.do(c.SetSetting("bending_length", 1e300))
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
