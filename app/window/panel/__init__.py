"""The panel beside the scene: shows what the Editor holds and returns what the person asks for."""

from __future__ import annotations

import polyscope.imgui as psim

from app.editor import commands as c
from app.editor.editor import Editor
from app.window.panel.colours import colours
from app.window.panel.file_rows import FileRows
from app.window.panel.parts import parts
from app.window.panel.regions import regions
from app.window.panel.settings import pose, soft_parts, softness_warnings
from app.window.panel.status import status
from app.window.panel.tools import choose_tool, tool_options
from app.window.panel.widgets import ERROR_COLOR, WIDTH
from app.window.shortcuts import SHORTCUTS

__all__ = ["ERROR_COLOR", "WIDTH", "Panel"]

SECTIONS = (
    status,
    choose_tool,
    tool_options,
    regions,
    parts,
    soft_parts,
    softness_warnings,
    pose,
)
PLACE = (
    psim.ImGuiWindowFlags_NoTitleBar
    | psim.ImGuiWindowFlags_NoResize
    | psim.ImGuiWindowFlags_NoMove
    | psim.ImGuiWindowFlags_NoCollapse
    | psim.ImGuiWindowFlags_NoBringToFrontOnFocus
)
HELP = (
    "Paint what stays (2), what you move (3), where it bends (4); then drag (5).",
    "Left drag beside the surface or with Navigate orbits, right drag pans,",
    "the wheel zooms, and with Ctrl resizes the brush. Shift while painting erases.",
    "A double click takes a whole part, another one the group that it is in.",
    "Dab soft and stiff spots with the softness brush, then Fill blends the rest.",
)


class Panel:
    """Holds nothing but switches of the window itself: show_edges, show_help.

    file_rows: the rows that open and save.
    """

    def __init__(self) -> None:
        self.show_edges = False
        self.show_help = False
        self.file_rows = FileRows()

    def draw(self, editor: Editor) -> list[c.Command]:
        """Draw the panel; the commands of what was pressed, moved or typed in this frame."""
        asked: list[c.Command] = []
        psim.SetNextWindowPos((0.0, 0.0))
        psim.SetNextWindowSize((WIDTH, psim.GetIO().DisplaySize[1]))
        psim.SetNextWindowBgAlpha(1.0)
        psim.Begin("##panel", PLACE)
        try:
            psim.PushItemWidth(-110.0)
            for section in SECTIONS:
                section(editor, asked)
            self.show_edges = colours(editor, self.show_edges, asked)
            self.file_rows.draw(editor, asked)
            psim.PopItemWidth()
        finally:
            psim.End()
        if self.show_help:
            self._help()
        return asked

    def _help(self) -> None:
        psim.SetNextWindowPos((WIDTH + 30.0, 30.0), psim.ImGuiCond_FirstUseEver)
        _, self.show_help = psim.Begin("Help", True, psim.ImGuiWindowFlags_AlwaysAutoResize)
        try:
            for line in HELP:
                psim.Text(line)
            psim.Separator()
            for shortcut in SHORTCUTS:
                psim.Text(shortcut.keys)
                psim.SameLine(130.0)
                psim.Text(shortcut.meaning)
        finally:
            psim.End()
