"""What the mouse does: who has it, what a gesture leaves, where the brush is seen."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from app.editor import commands as c
from app.scene.overlay import NOTHING
from app.tools.table import TOOLS
from tests.app.person import Person, state

OFF_THE_MESH = [30.0, 2.0, 0.0]


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
    ready.do(c.SetPlacing(gizmo=False))
    before = state(ready.editor.document)
    for _ in ready.hold([OFF_THE_MESH, [19, 2, 0], [10, 2, 0]]):
        assert not ready.editor.captures
        assert ready.editor.cursor is NOTHING
    ready.frame([10, 2, 0], "r")
    assert state(ready.editor.document) == before


def test_a_press_on_the_surface_moves_the_camera_with_navigate_alone(ready: Person) -> None:
    for tool in TOOLS:
        ready.use(tool)
        before = ready.editor.viewpoint.camera.forward
        for _ in ready.hold([[19, 2, 0], [12, 3, 0]]):
            assert ready.editor.captures == (tool != "navigate")
        moved = ready.editor.viewpoint.camera.forward @ before < 1 - 1e-9
        assert moved == (tool == "navigate")
        ready.frame([12, 3, 0], "r")


def test_dragging_what_is_fixed_says_why_nothing_moves(ready: Person) -> None:
    before = state(ready.editor.document)
    for _ in ready.hold([[0, 2, 0], [3, 3, 0]]):
        assert ready.editor.captures
    ready.frame([3, 3, 0], "r")
    assert state(ready.editor.document) == before
    assert ready.editor.message is not None
    assert "fixed" in ready.editor.message.text


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


def test_what_a_press_would_do_hovers_over_the_surface(ready: Person) -> None:
    ready.do(c.SetPlacing(gizmo=False))
    for tool in TOOLS:
        ready.use(tool)
        ready.frame([10, 2, 0])
        assert (ready.editor.cursor is not NOTHING) == (tool != "navigate")
    ready.use("fixed")
    ready.frame(OFF_THE_MESH)
    assert ready.editor.cursor is NOTHING
