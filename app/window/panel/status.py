"""The head of the panel: what is open, what to do next, what it costs."""

from __future__ import annotations

import polyscope.imgui as psim

from app.editor import commands as c
from app.editor.editor import Editor
from app.telling import readable
from app.window.panel.widgets import BUSY_COLOR, WIDTH, text_until
from app.window.scaling import scaled
from app.window.shortcuts import WindowAction

HINT_LINES = 2
BUTTONS = WIDTH - 124.0  # where Frame and Help begin
NOTHING = 5e-5  # seconds below which no drag has been


def status(editor: Editor, asked: list[c.Command]) -> None:
    """What is open, what to do next, what it costs."""
    document = editor.document
    mark = " *" if editor.dirty else ""
    text_until(BUTTONS, f"{document.path.name}{mark}")
    psim.SameLine(scaled(BUTTONS))
    if psim.SmallButton("Frame"):
        asked.append(c.ViewFrom("front"))
    psim.SetItemTooltip("Show the whole mesh from the front (Home); F frames what is selected")
    psim.SameLine()
    if psim.SmallButton("Help"):
        asked.append(WindowAction("help"))
    psim.SetItemTooltip("Keys and mouse (F1)")
    faces = len(document.mesh.outlines.sizes)
    psim.TextDisabled(f"{len(document.role):,} vertices, {faces:,} faces")
    _hint(editor)
    bound = editor.bind_seconds
    bind = "-" if bound is None else f"{1e3 * bound:.0f} ms"
    drag = f"{1e3 * editor.drag_seconds:.1f} ms" if editor.drag_seconds > NOTHING else "-"
    psim.TextDisabled(f"bind {bind}   drag frame {drag}")


def _hint(editor: Editor) -> None:
    """Takes two lines even where one is enough: what is below must not jump under the mouse."""
    below = psim.GetCursorPosY() + HINT_LINES * psim.GetTextLineHeight()
    below += psim.GetStyle().ItemSpacing[1]
    if editor.waits:
        psim.PushStyleColor(psim.ImGuiCol_Text, BUSY_COLOR)
    psim.TextWrapped(readable(editor.hint))
    if editor.waits:
        psim.PopStyleColor(1)
    psim.SetCursorPosY(max(below, psim.GetCursorPosY()))
