"""The sections of the panel, as a table."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import polyscope.imgui as psim

from app.editor import commands as c
from app.editor.editor import Editor
from app.window.panel.colours import colours
from app.window.panel.mirror import mirror
from app.window.panel.parts import has_parts, parts
from app.window.panel.poses import poses
from app.window.panel.regions import regions
from app.window.panel.settings import pose, soft_parts, softness_warnings
from app.window.panel.status import status
from app.window.panel.tools import tools
from app.window.scaling import scaled

# Heights of a window, for an interface of size 1, from which a section is open at the start.
ALWAYS, ROOMY, TALL = 0.0, 780.0, 960.0


@dataclass(frozen=True)
class Section:
    """title: of the header that folds it, empty for what is always there.  draw: its rows.

    open_from: how high the window has to be for it to be open at the start.
    needed: whether there is anything to show.  unfolds: whether it is open now, however it was.
    """

    title: str
    draw: Callable[[Editor, list[c.Command]], None]
    open_from: float = ALWAYS
    needed: Callable[[Editor], bool] = lambda editor: True
    unfolds: Callable[[], bool] = lambda: False


SECTIONS = (
    Section("", status),
    Section("Tools", tools),
    Section("Regions", regions),
    Section("Parts", parts, TALL, has_parts),
    Section("Soft parts", soft_parts, ROOMY),
    Section("", softness_warnings),
    Section("Pose", pose),
    Section("Kept poses", poses, ROOMY),
    Section("Mirror", mirror, TALL),
    Section("Colours", colours, TALL),
)


def draw_section(section: Section, editor: Editor, asked: list[c.Command]) -> None:
    """Its header, and its rows where it is open; what was asked for goes into `asked`."""
    if not section.needed(editor):
        return
    if section.title:
        height = psim.GetIO().DisplaySize[1]
        psim.SetNextItemOpen(height >= scaled(section.open_from), psim.ImGuiCond_Once)
        if section.unfolds():
            psim.SetNextItemOpen(True)
        if not psim.CollapsingHeader(section.title):
            return
    section.draw(editor, asked)
