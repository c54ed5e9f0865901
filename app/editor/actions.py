"""What the commands that change the document or the choices do. ACTIONS is the table."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np

from app.editor import commands as c
from app.model.handles import FREE, Handle, Pose
from app.model.settings import SETTINGS, is_number
from app.tools.softness_strokes import SOFTNESS_MODES
from app.tools.table import TOOLS
from app.workspace.color_maps import MAPS
from app.workspace.workspace import Workspace
from solver.softness.checks import smooth_softness
from solver.softness.harmonic import interpolate_softness
from solver.softness.material import resolve_material

# The largest brush still shows which part of the mesh it is for; the smallest takes one vertex.
BRUSH_RADII = 0.001, 0.5


def set_tool(work: Workspace, command: c.SetTool) -> None:
    _check_name(command.name, TOOLS, "tool")
    work.tool, tool = command.name, TOOLS[command.name]
    watched = MAPS[work.map].measure is not None and tool.keeps_heat
    if tool.map is not None and not watched:
        work.map = tool.map


def set_brush(work: Workspace, command: c.SetBrush) -> None:
    """Numbers out of range are taken to the nearest that fits, as a slider would."""
    changes = {name: value for name, value in vars(command).items() if value is not None}
    if command.mode is not None:
        _check_name(command.mode, SOFTNESS_MODES, "brush mode")
    for name, value in changes.items():
        if name == "mode":
            continue
        if not is_number(value):
            raise c.CommandError(f"brush {name} must be a number, got {value!r}")
        low, high = BRUSH_RADII if name == "radius" else (0.0, 1.0)
        changes[name] = min(max(float(value), low), high)
    work.brush = replace(work.brush, **changes)


def set_turn(work: Workspace, command: c.SetTurn) -> None:
    work.turn = command.on


def set_map(work: Workspace, command: c.SetMap) -> None:
    _check_name(command.name, MAPS, "map")
    work.map = command.name


def add_handle(work: Workspace, command: c.AddHandle) -> None:
    handle = work.document.new_handle(command.name.strip())
    with work.edit(f"Add {handle.name}") as gesture:
        gesture.change("handles", (*work.document.handles, handle))
    work.activate(handle.key)


def rename_handle(work: Workspace, command: c.RenameHandle) -> None:
    handle, name = _handle(work, command.key), command.name.strip()
    if not name:
        raise c.CommandError("a handle's name must not be empty")
    with work.edit(f"Rename {handle.name}", merge=f"rename {handle.key}") as gesture:
        handles = work.document.handles
        renamed = (replace(h, name=name) if h is handle else h for h in handles)
        gesture.change("handles", tuple(renamed))


def remove_handle(work: Workspace, command: c.RemoveHandle) -> None:
    document, handle = work.document, _handle(work, command.key)
    with work.edit(f"Remove {handle.name}") as gesture:
        gesture.change("role", FREE, document.vertices_of(handle.key))
        gesture.change("handles", tuple(h for h in document.handles if h is not handle))
        gesture.change("pose", document.pose.without(handle.key))


def activate_handle(work: Workspace, command: c.ActivateHandle) -> None:
    work.activate(_handle(work, command.key).key)


def clear_fixed(work: Workspace, command: c.ClearFixed) -> None:
    with work.edit("Clear fixed") as gesture:
        gesture.change("role", FREE, work.document.fixed)


def clear_handle(work: Workspace, command: c.ClearHandle) -> None:
    handle = _handle(work, command.key)
    with work.edit(f"Clear {handle.name}") as gesture:
        gesture.change("role", FREE, work.document.vertices_of(handle.key))


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
    softness = interpolate_softness(mesh.vertices, mesh.faces, pins, values)
    component = work.neighbours.component
    reached = np.flatnonzero(np.isin(component, component[pins]))
    with work.edit("Fill softness") as gesture:
        gesture.change("softness", softness[reached], reached)


def smooth_whole_softness(work: Workspace, command: c.SmoothSoftness) -> None:
    document, mesh = work.document, work.document.mesh
    softness = smooth_softness(mesh.vertices, mesh.faces, document.softness)
    with work.edit("Smooth softness") as gesture:
        gesture.change("softness", softness, np.arange(len(softness)))


def clear_pins(work: Workspace, command: c.ClearPins) -> None:
    with work.edit("Clear pins") as gesture:
        gesture.change("pinned", False, np.flatnonzero(work.document.pinned))


def set_material(work: Workspace, command: c.SetMaterial) -> None:
    resolve_material(command.material)
    if command.material != work.document.material:
        with work.edit("Material", merge="material") as gesture:
            gesture.change("material", command.material)


def set_setting(work: Workspace, command: c.SetSetting) -> None:
    name, value = command.name, command.value
    _check_name(name, SETTINGS, "setting")
    if not SETTINGS[name].accepts(value):
        raise c.CommandError(f"{name} must be {SETTINGS[name].expected}, got {value!r}")
    if value != getattr(work.document, name):
        with work.edit(name.replace("_", " ").capitalize(), merge=name) as gesture:
            gesture.change(name, value)


def reset_pose(work: Workspace, command: c.ResetPose) -> None:
    if work.document.pose.at_rest:
        return
    with work.edit("Reset pose") as gesture:
        gesture.change("pose", Pose())


def cancel_gesture(work: Workspace, command: c.CancelGesture) -> None:
    work.cancel()


def undo(work: Workspace, command: c.Undo) -> None:
    entry = work.history.undo(work.document)
    work.say(f"Undone: {entry.label}" if entry else "Nothing to undo")


def redo(work: Workspace, command: c.Redo) -> None:
    entry = work.history.redo(work.document)
    work.say(f"Redone: {entry.label}" if entry else "Nothing to redo")


def _handle(work: Workspace, key: int) -> Handle:
    handle = work.document.find(key)
    if handle is None:
        raise c.CommandError(f"there is no handle with key {key!r}")
    return handle


def _check_name(name: str, table: Any, what: str) -> None:
    if name not in table:
        raise c.CommandError(f"unknown {what} {name!r}, expected one of {', '.join(table)}")


ACTIONS: dict[type[c.Command], Callable[[Workspace, Any], None]] = {
    c.SetTool: set_tool,
    c.SetBrush: set_brush,
    c.SetTurn: set_turn,
    c.SetMap: set_map,
    c.AddHandle: add_handle,
    c.RenameHandle: rename_handle,
    c.RemoveHandle: remove_handle,
    c.ActivateHandle: activate_handle,
    c.ClearFixed: clear_fixed,
    c.ClearHandle: clear_handle,
    c.ClearSoftness: clear_softness,
    c.FillSoftness: fill_softness,
    c.SmoothSoftness: smooth_whole_softness,
    c.ClearPins: clear_pins,
    c.SetMaterial: set_material,
    c.SetSetting: set_setting,
    c.ResetPose: reset_pose,
    c.CancelGesture: cancel_gesture,
    c.Undo: undo,
    c.Redo: redo,
}
