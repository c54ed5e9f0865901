"""What the commands do to the whole softness, without a stroke."""

from __future__ import annotations

import numpy as np

from app.editor import commands as c
from app.editor.action import Actions
from app.model.handles import FREE
from app.workspace.workspace import Workspace
from solver.softness.checks import smooth_softness
from solver.softness.filling import fill_between

# How far a single dab reaches, in radii of the brush.
LEAST_REACH = 2.0
# Rings of edges around a fault that its cure touches.
RINGS = 12


def clear_softness(work: Workspace, command: c.ClearSoftness) -> None:
    with work.edit("Clear softness") as gesture:
        gesture.change("softness", 0.0, np.flatnonzero(work.document.softness))
        gesture.change("pinned", False, np.flatnonzero(work.document.pinned))


def fill_softness(work: Workspace, command: c.FillSoftness) -> None:
    document, mesh = work.document, work.document.mesh
    pins = np.flatnonzero(document.pinned)
    if not len(pins):
        raise c.CommandError("nothing to fill from: dab a few soft and a few stiff spots first")
    place = work.viewpoint.pivot, work.viewpoint.camera
    free, reach = document.role == FREE, LEAST_REACH * work.brush_radius(*place)
    softness = fill_between(
        document.rest_positions, mesh.faces, document.softness, pins, free, reach
    )
    with work.edit("Fill softness") as gesture:
        gesture.change("softness", softness, np.arange(len(softness)))


def smooth_whole_softness(work: Workspace, command: c.SmoothSoftness) -> None:
    """Around some vertices only where the command names them, fading out over some rings."""
    document, mesh = work.document, work.document.mesh
    softness = smooth_softness(document.rest_positions, mesh.faces, document.softness)
    label, amount = "Smooth softness", np.ones(len(softness))
    if command.around is not None:
        label = "Smooth softness there"
        amount = work.neighbours.fading(np.array(command.around), RINGS)
    with work.edit(label) as gesture:
        softness = document.softness + amount * (softness - document.softness)
        gesture.change("softness", softness, np.arange(len(softness)))


def clear_pins(work: Workspace, command: c.ClearPins) -> None:
    with work.edit("Clear pins") as gesture:
        gesture.change("pinned", False, np.flatnonzero(work.document.pinned))


SOFTNESS_ACTIONS: Actions = {
    c.ClearSoftness: clear_softness,
    c.FillSoftness: fill_softness,
    c.SmoothSoftness: smooth_whole_softness,
    c.ClearPins: clear_pins,
}
