"""What the commands do that choose: the tool, how it works, the map that is shown."""

from __future__ import annotations

from dataclasses import replace

from app.editor import commands as c
from app.editor.action import Actions, check_name, given
from app.model.settings import is_number
from app.tools.marking_shapes import SHAPES
from app.tools.softness_strokes import SOFTNESS_MODES
from app.tools.table import TOOLS
from app.workspace.color_maps import MAPS
from app.workspace.workspace import Workspace

# The largest brush still shows which part of the mesh it is for; the smallest takes one vertex.
BRUSH_RADII = 0.001, 0.5


def set_tool(work: Workspace, command: c.SetTool) -> None:
    check_name(command.name, TOOLS, "tool")
    work.radii[work.tool] = work.brush.radius
    work.brush = replace(work.brush, radius=work.radii.get(command.name, work.brush.radius))
    work.tool, tool = command.name, TOOLS[command.name]
    watched = MAPS[work.map].measure is not None and tool.keeps_heat
    if tool.map is not None and not watched:
        work.map = tool.map


def set_brush(work: Workspace, command: c.SetBrush) -> None:
    """Numbers out of range are taken to the nearest that fits, as a slider would."""
    changes = given(command)
    if command.mode is not None:
        check_name(command.mode, SOFTNESS_MODES, "brush mode")
    for name, value in changes.items():
        if name in ("mode", "on_screen"):
            continue
        if not is_number(value):
            raise c.CommandError(f"brush {name} must be a number, got {value!r}")
        low, high = BRUSH_RADII if name == "radius" else (0.0, 1.0)
        changes[name] = min(max(float(value), low), high)
    on_screen = changes.pop("on_screen", work.brush.on_screen)
    if on_screen != work.brush.on_screen:
        _measure_brushes(work, on_screen)
    work.brush = replace(work.brush, **changes)


def _measure_brushes(work: Workspace, on_screen: bool) -> None:
    """Measure radii otherwise: all brushes stay as large as they are where the view turns."""
    place = work.viewpoint.pivot, work.viewpoint.camera
    unit = work.brush_unit(*place)
    work.brush = replace(work.brush, on_screen=on_screen)
    factor = unit / work.brush_unit(*place)
    work.radii = {tool: factor * radius for tool, radius in work.radii.items()}
    work.brush = replace(work.brush, radius=factor * work.brush.radius)


def set_marking(work: Workspace, command: c.SetMarking) -> None:
    changes = given(command)
    if command.shape is not None:
        check_name(command.shape, SHAPES, "shape")
    work.marking = replace(work.marking, **changes)


def set_keep(work: Workspace, command: c.SetKeep) -> None:
    work.keep = not work.keep if command.on is None else command.on


def set_turn(work: Workspace, command: c.SetTurn) -> None:
    work.turn = command.on


def set_map(work: Workspace, command: c.SetMap) -> None:
    check_name(command.name, MAPS, "map")
    work.map = command.name


CHOICE_ACTIONS: Actions = {
    c.SetTool: set_tool,
    c.SetBrush: set_brush,
    c.SetMarking: set_marking,
    c.SetTurn: set_turn,
    c.SetKeep: set_keep,
    c.SetMap: set_map,
}
