"""The tools, a button each, and the options of the one in the hand."""

from __future__ import annotations

import polyscope.imgui as psim

from app.editor import commands as c
from app.editor.editor import Editor
from app.tools.table import TOOLS
from app.window.panel.tool_options import OPTIONS
from app.window.panel.widgets import CHOSEN_COLOR

TOOLS_A_ROW = 3


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
    for name in TOOLS[editor.tool].options:
        OPTIONS[name](editor, asked)
