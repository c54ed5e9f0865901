"""The tools, a button each, and the options of the one in the hand."""

from __future__ import annotations

import polyscope.imgui as psim

from app.editor import commands as c
from app.editor.editor import Editor
from app.tools.table import TOOLS
from app.window.panel.tool_options import OPTIONS
from app.window.panel.widgets import CHOSEN_COLOR, share

TOOLS_A_ROW = 3


def tools(editor: Editor, asked: list[c.Command]) -> None:
    """One button a tool, and what the tool in the hand can be told."""
    size = share(TOOLS_A_ROW)
    for number, name in enumerate(TOOLS):
        if number % TOOLS_A_ROW:
            psim.SameLine()
        _button(editor, name, size, asked)
    for option in TOOLS[editor.tool].options:
        OPTIONS[option](editor, asked)


def _button(editor: Editor, name: str, size: tuple[float, float], asked: list[c.Command]) -> None:
    tool, chosen = TOOLS[name], editor.tool == name
    if chosen:
        psim.PushStyleColor(psim.ImGuiCol_Button, CHOSEN_COLOR)
    if psim.Button(f"{tool.key} {tool.label}", size):
        asked.append(c.SetTool(name))
    if chosen:
        psim.PopStyleColor(1)
