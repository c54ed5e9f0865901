"""The upper part of the panel: what is open, what to do next, which tool."""

from __future__ import annotations

import polyscope.imgui as psim

from app.editor import commands as c
from app.editor.editor import Editor
from app.tools.softness_strokes import SOFTNESS_MODES
from app.tools.table import TOOLS
from app.window.input import WindowAction
from app.window.panel.widgets import BUSY_COLOR, CHOSEN_COLOR, WIDTH, disabled, halves, logarithmic

TOOLS_A_ROW, HINT_LINES = 3, 2
NOTHING = 5e-5  # seconds below which no drag has been
BRUSH_RADII = 0.005, 0.3


def status(editor: Editor, asked: list[c.Command]) -> None:
    """What is open, what to do next, what it costs."""
    document = editor.document
    mark = " *" if editor.dirty else ""
    psim.Text(f"{document.path.name}{mark}")
    psim.SameLine(WIDTH - 114.0)
    if psim.SmallButton("Frame"):
        asked.append(WindowAction("frame"))
    psim.SetItemTooltip("Show the whole mesh (F)")
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
        psim.TextColored(BUSY_COLOR, editor.hint)
    else:
        psim.TextWrapped(editor.hint)
    psim.SetCursorPosY(max(below, psim.GetCursorPosY()))


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
    if editor.tool == "handle":
        if psim.Button("New handle"):
            asked.append(c.AddHandle())
        psim.SetItemTooltip("Strokes from now on paint another handle")
    if editor.tool == "softness":
        _softness_options(editor, asked)
    if editor.tool == "drag":
        changed, turn = psim.Checkbox("turns by itself", editor.turn)
        if changed:
            asked.append(c.SetTurn(turn))


def _softness_options(editor: Editor, asked: list[c.Command]) -> None:
    brush, pinned = editor.brush, bool(editor.document.pinned.any())
    for number, mode in enumerate(SOFTNESS_MODES):
        if number:
            psim.SameLine()
        if psim.RadioButton(mode, brush.mode == mode):
            asked.append(c.SetBrush(mode=mode))
    for label in halves("value", "strength"):
        with disabled(label == "value" and brush.mode == "smooth"):
            moved, share = psim.SliderFloat(
                f"##{label}", getattr(brush, label), 0.0, 1.0, f"{label} %.2f"
            )
        if moved:
            asked.append(c.SetBrush(**{label: share}))
    for label, command, usable, tip in (
        ("Fill", c.FillSoftness(), pinned, "Keep what is pinned (dots), blend everything between"),
        ("Smooth all", c.SmoothSoftness(), True, "Even out the whole field"),
        ("Clear pins", c.ClearPins(), pinned, "Pin nothing; the softness stays"),
    ):
        with disabled(not usable):
            if psim.Button(label):
                asked.append(command)
        psim.SetItemTooltip(tip)
        psim.SameLine()
    psim.NewLine()
