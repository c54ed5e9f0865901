"""What the commands do to the vertices that the tool in the hand marks."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from app.editor import commands as c
from app.editor.action import Actions, check_name
from app.selection.regions import grown, shrunk, smoothed_region
from app.tools.table import TOOLS
from app.workspace.workspace import Workspace
from solver.geometry.cross_products import triangle_areas, vertex_areas
from solver.types import BoolArray


def _smoothed(work: Workspace, marked: BoolArray) -> BoolArray:
    mesh = work.document.mesh
    area = vertex_areas(triangle_areas(mesh.vertices, mesh.faces), mesh.faces, len(mesh.vertices))
    return smoothed_region(work.neighbours.graph, marked, area)


# What is to be marked, (n,), of what is.
CHANGES: dict[str, Callable[[Workspace, BoolArray], BoolArray]] = {
    "grow": lambda work, marked: grown(work.neighbours.graph, marked),
    "shrink": lambda work, marked: shrunk(work.neighbours.graph, marked),
    "smooth": _smoothed,
    "invert": lambda work, marked: ~marked,
    "everything else": lambda work, marked: np.ones_like(marked),
    "clear": lambda work, marked: np.zeros_like(marked),
}


def change_marks(work: Workspace, command: c.ChangeMarks) -> None:
    check_name(command.name, CHANGES, "change")
    tool = TOOLS[work.tool]
    if tool.marks is None:
        raise c.CommandError(f"the tool {tool.label} marks nothing: take Fixed, Handle or Softness")
    marked = tool.marks.marked(work)
    wanted = CHANGES[command.name](work, marked)
    seen = work.parts.visible
    more = np.flatnonzero(wanted & ~marked & seen & tool.marks.free(work))
    less = np.flatnonzero(marked & ~wanted & seen)
    with work.edit(f"{tool.label}: {command.name}") as gesture:
        tool.marks.leave(work, gesture, less, erase=True)
        tool.marks.leave(work, gesture, more)


def find_limbs(work: Workspace, command: c.FindLimbs) -> None:
    shown = [part for part in work.parts.all if part.number not in work.parts.hidden]
    largest = max(shown, key=lambda part: part.count)
    work.limbs.at(int(np.flatnonzero(work.document.mesh.pieces == largest.number)[0]))


MARK_ACTIONS: Actions = {c.ChangeMarks: change_marks, c.FindLimbs: find_limbs}
