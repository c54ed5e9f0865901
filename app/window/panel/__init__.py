"""The panel beside the scene: shows what the Editor holds and returns what the person asks for."""

from __future__ import annotations

import polyscope.imgui as psim

from app.editor import commands as c
from app.editor.editor import Editor
from app.window.panel.file_rows import FileRows
from app.window.panel.looking import LookingRows
from app.window.panel.sections import SECTIONS, TALL, Section, draw_section
from app.window.panel.widgets import CONTENT_WIDTH, ERROR_COLOR, WIDTH
from app.window.scaling import scaled
from app.window.shortcuts import SHORTCUTS

__all__ = ["ERROR_COLOR", "WIDTH", "Panel"]

BESIDE = 30.0  # how far the help is from the panel and from the rim of the window
HELP_WIDTH = 540.0
LABELS = 110.0  # room for what stands behind a slider
PLACE = (
    psim.ImGuiWindowFlags_NoTitleBar
    | psim.ImGuiWindowFlags_NoResize
    | psim.ImGuiWindowFlags_NoMove
    | psim.ImGuiWindowFlags_NoCollapse
    | psim.ImGuiWindowFlags_NoBringToFrontOnFocus
)
HELP = (
    "Paint what stays (2), what you move (3), where it bends (4); then drag (5).",
    "Left drag beside the surface or with Navigate orbits, right drag pans, the wheel zooms, and "
    "with Ctrl resizes the brush. Shift while painting erases.",
    "A double click takes a whole part, another one the group that it is in.",
    "Dab soft and stiff spots with the softness brush, then Fill blends the rest.",
)


class Panel:
    """Holds nothing but a switch of the window itself: show_help.

    file_rows: the rows that open and save.
    """

    def __init__(self, file_rows: FileRows, looking: LookingRows) -> None:
        self.show_help = False
        self.file_rows = file_rows
        self._sections = (
            *SECTIONS,
            Section("View", looking.draw, TALL),
            Section("Files", file_rows.draw, unfolds=lambda: file_rows.used),
        )

    def draw(self, editor: Editor) -> list[c.Command]:
        """Draw the panel; the commands of what was pressed, moved or typed in this frame."""
        asked: list[c.Command] = []
        psim.SetNextWindowPos((0.0, 0.0))
        psim.SetNextWindowSize((scaled(WIDTH), psim.GetIO().DisplaySize[1]))
        psim.SetNextWindowContentSize((scaled(CONTENT_WIDTH), 0.0))
        psim.SetNextWindowBgAlpha(1.0)
        psim.Begin("##panel", PLACE)
        try:
            psim.PushItemWidth(-scaled(LABELS))
            for section in self._sections:
                draw_section(section, editor, asked)
            psim.PopItemWidth()
        finally:
            psim.End()
        if self.show_help:
            self._help()
        return asked

    def _help(self) -> None:
        left, margin = scaled(WIDTH + BESIDE), scaled(BESIDE)
        width, height = psim.GetIO().DisplaySize
        psim.SetNextWindowPos((left, margin), psim.ImGuiCond_FirstUseEver)
        psim.SetNextWindowSizeConstraints((0.0, 0.0), (width - left, height - 2.0 * margin))
        _, self.show_help = psim.Begin("Help", True, psim.ImGuiWindowFlags_AlwaysAutoResize)
        try:
            psim.PushTextWrapPos(min(width - left - margin, scaled(HELP_WIDTH)))
            for line in HELP:
                psim.TextWrapped(line)
            psim.Separator()
            for shortcut in SHORTCUTS:
                psim.Text(shortcut.keys)
                psim.SameLine(scaled(130.0))
                psim.TextWrapped(shortcut.meaning)
            psim.PopTextWrapPos()
        finally:
            psim.End()
