"""The upper part of the panel: what is open, what to do next, which tool."""

from __future__ import annotations

import polyscope.imgui as psim

from app import commands as c
from app.editor import Editor
from app.input import WindowAction
from app.panel.widgets import BUSY_COLOR, CHOSEN_COLOR, WIDTH, logarithmic
from app.tools import TOOLS

TOOLS_A_ROW = 3
NOTHING = 1e-5  # seconds below which no drag has been
BRUSH_RADII = 0.005, 0.3


def status(editor: Editor, asked: list[c.Command]) -> None:
    """What is open, what to do next, what it costs."""
    document = editor.document
    mark = " *" if editor.dirty else ""
    psim.Text(f"{document.path.name}{mark}")
    psim.SameLine(WIDTH - 128.0)
    if psim.SmallButton("Frame"):
        asked.append(WindowAction("frame"))
    psim.SetItemTooltip("Show the whole mesh (F)")
    psim.SameLine()
    if psim.SmallButton("Help"):
        asked.append(WindowAction("help"))
    psim.SetItemTooltip("Keys and mouse (F1)")
    faces = len(document.mesh.outlines.sizes)
    psim.TextDisabled(f"{len(document.role):,} vertices, {faces:,} faces")
    if editor.waits:
        psim.TextColored(BUSY_COLOR, editor.hint)
    else:
        psim.TextWrapped(editor.hint)
    bound = editor.bind_seconds
    bind = "-" if bound is None else f"{1e3 * bound:.0f} ms"
    drag = f"{1e3 * editor.drag_seconds:.1f} ms" if editor.drag_seconds > NOTHING else "-"
    psim.TextDisabled(f"bind {bind}   drag frame {drag}")


def choose_tool(editor: Editor, asked: list[c.Command]) -> None:
    """One button a tool."""
    psim.SeparatorText("Tools")
    room, gap = psim.GetContentRegionAvail()[0], psim.GetStyle().ItemSpacing[0]
    size = ((room - (TOOLS_A_ROW - 1) * gap) / TOOLS_A_ROW, 0.0)
    for number, (name, tool) in enumerate(TOOLS.items()):
        if number % TOOLS_A_ROW:
            psim.SameLine()
        chosen = editor.tool == name
        if chosen:
            psim.PushStyleColor(psim.ImGuiCol_Button, CHOSEN_COLOR)
        if psim.Button(f"{tool.key} {tool.label}", size):
            asked.append(c.SetTool(name))
        if chosen:
            psim.PopStyleColor(1)


def tool_options(editor: Editor, asked: list[c.Command]) -> None:
    """What the tool in the hand can be told."""
    brush = editor.brush
    if TOOLS[editor.tool].paints:
        moved, radius = logarithmic("brush radius", brush.radius, *BRUSH_RADII, "%.3f")
        if moved:
            asked.append(c.SetBrush(radius=radius))
    if editor.tool == "softness":
        for label in ("value", "strength"):
            moved, number = psim.SliderFloat(label, getattr(brush, label), 0.0, 1.0, "%.2f")
            if moved:
                asked.append(c.SetBrush(**{label: number}))
    if editor.tool == "drag":
        changed, turn = psim.Checkbox("turns by itself", editor.turn)
        if changed:
            asked.append(c.SetTurn(turn))
