"""What the commands do to the whole softness, without a stroke."""

from __future__ import annotations

import numpy as np

from app.editor import commands as c
from app.editor.action import Actions
from app.workspace.workspace import Workspace
from solver.softness.checks import smooth_softness
from solver.softness.harmonic import interpolate_softness


def clear_softness(work: Workspace, command: c.ClearSoftness) -> None:
    with work.edit("Clear softness") as gesture:
        gesture.change("softness", 0.0, np.flatnonzero(work.document.softness))
        gesture.change("pinned", False, np.flatnonzero(work.document.pinned))


def fill_softness(work: Workspace, command: c.FillSoftness) -> None:
    document, mesh = work.document, work.document.mesh
    pins = np.flatnonzero(document.pinned)
    if not len(pins):
        raise c.CommandError("nothing to fill from: dab a few soft and a few stiff spots first")
    values = document.softness[pins]
    softness = interpolate_softness(document.rest_positions, mesh.faces, pins, values)
    component = work.neighbours.component
    reached = np.flatnonzero(np.isin(component, component[pins]))
    with work.edit("Fill softness") as gesture:
        gesture.change("softness", softness[reached], reached)


def smooth_whole_softness(work: Workspace, command: c.SmoothSoftness) -> None:
    document, mesh = work.document, work.document.mesh
    softness = smooth_softness(document.rest_positions, mesh.faces, document.softness)
    with work.edit("Smooth softness") as gesture:
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
