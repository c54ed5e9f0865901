"""What the commands do to the camera."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from app.editor import commands as c
from app.editor.action import Actions, check_name, given
from app.scene.looks import SHADINGS
from app.scene.twin import ASIDE
from app.viewpoint.viewpoint import SIDES, UPS
from app.workspace.workspace import Workspace
from solver.types import IntArray

MARGIN = 0.03  # diagonals around a place that is framed


def frame_selected(work: Workspace, command: c.FrameSelected) -> None:
    chosen = _selected(work)
    if chosen is None or work.viewpoint.frames(work.positions[chosen]):
        _frame_all(work)
    else:
        work.viewpoint.frame(work.positions[chosen])


def frame_vertices(work: Workspace, command: c.FrameVertices) -> None:
    """With some of what is around them: a place cannot be told from itself alone."""
    positions = work.positions[list(command.vertices)]
    low, high = positions.min(axis=0), positions.max(axis=0)
    margin = MARGIN * work.document.diagonal
    work.viewpoint.frame(np.vstack([low - margin, high + margin]))


def view_from(work: Workspace, command: c.ViewFrom) -> None:
    check_name(command.side, SIDES, "side")
    work.viewpoint.view_from(command.side, work.positions[work.parts.framed])
    if work.looks.beside:
        _frame_all(work)


def set_up(work: Workspace, command: c.SetUp) -> None:
    check_name(command.name, UPS, "axis")
    work.viewpoint.set_up(command.name)
    view_from(work, c.ViewFrom("front"))


def set_looks(work: Workspace, command: c.SetLooks) -> None:
    before, changes = work.looks, given(command)
    check_name(changes.get("shading", before.shading), SHADINGS, "shading")
    work.looks = replace(before, **changes)
    if work.looks.beside != before.beside:
        _frame_all(work)


def _frame_all(work: Workspace) -> None:
    """From where the camera is; with room for the rest shape at both places, where it is beside."""
    seen = work.parts.framed
    positions = shown = work.positions[seen]
    if work.looks.beside:
        rest = work.document.rest_positions[seen]
        to_the_left = -ASIDE * work.document.diagonal * work.viewpoint.camera.right
        shown = np.vstack([positions, rest, rest + to_the_left])
    work.viewpoint.frame(shown, about=positions)


def _selected(work: Workspace) -> IntArray | None:
    """The vertices of the active handle, else of the part under the cursor; None for all."""
    active = work.active
    if active is not None and len(vertices := work.document.vertices_of(active.key)):
        return vertices
    if work.hovered is not None:
        return np.flatnonzero(work.document.mesh.pieces == work.hovered)
    return None


VIEW_ACTIONS: Actions = {
    c.FrameSelected: frame_selected,
    c.FrameVertices: frame_vertices,
    c.ViewFrom: view_from,
    c.SetUp: set_up,
    c.SetLooks: set_looks,
}
