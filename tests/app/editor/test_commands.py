"""Commands: each has an action, and what is wrong is a message that changes nothing."""

from __future__ import annotations

import dataclasses
from pathlib import Path

import pytest

from app.editor import commands as c
from app.editor.actions import ACTIONS
from tests.app.person import Person, error_of, state

WRONG = [
    (c.SetTool("hammer"), "unknown tool 'hammer'"),
    (c.SetMap("heat"), "unknown map 'heat'"),
    (c.SetBrush(strength=float("nan")), "brush strength must be a number"),
    (c.SetSetting("colour", 1), "unknown setting 'colour'"),
    (
        c.SetSetting("bending_length", 0.0),
        "bending_length must be a number from 1e-12",
    ),
    (c.SetSetting("orientation", 1), "orientation must be true or false"),
    (c.SetSetting("rigid", -1), "rigid must be an integer from 0 to 1000"),
    (c.SetMaterial("steel"), "unknown material 'steel'"),
    (c.RemoveHandle(-5), "no handle with key -5"),
    (c.SelectHandle(-5), "no handle with key -5"),
    (c.ResetHandle(-5), "no handle with key -5"),
    (c.SetPlacing(axes="polar"), "unknown axes 'polar'"),
    (c.SetPlacing(pivot="nose"), "unknown pivot 'nose'"),
    (c.SetPosition(3, 0.0), "axis must be 0, 1 or 2, got 3"),
    (c.SetPosition(0, float("inf")), "position must be numbers, got inf"),
    (c.SetRotation(0, (float("nan"), 0, 0)), "rotation must be numbers, got nan"),
    (c.OpenMesh(Path("no-such.obj")), "no-such.obj"),
    (c.OpenMesh(Path("no-such.xyz")), "unknown mesh format"),
    (c.OpenSession(Path("no-such.json")), "no-such.json"),
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
