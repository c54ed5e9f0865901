"""What the commands do that place handles exactly."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from app.editor import commands as c
from app.editor.action import Actions, check_name, given
from app.model.handles import rotation_of
from app.model.settings import is_number
from app.tools.gizmo.begin import begin_operator
from app.tools.gizmo.pick import PickPivot
from app.tools.gizmo.placement import follow_placed, label_of, placed
from app.workspace.placing import AXES, PIVOTS
from app.workspace.workspace import Workspace
from solver.geometry.motions import from_euler_angles, motion
from solver.types import FloatArray


def move_handles(work: Workspace, command: c.MoveHandles) -> None:
    _pivot(work)
    work.interaction = begin_operator(work, "Move")


def turn_handles(work: Workspace, command: c.TurnHandles) -> None:
    _pivot(work)
    work.interaction = begin_operator(work, "Turn")


def pick_pivot(work: Workspace, command: c.PickPivot) -> None:
    _pivot(work)
    work.interaction = PickPivot(work)


def set_placing(work: Workspace, command: c.SetPlacing) -> None:
    if command.axes is not None:
        check_name(command.axes, AXES, "axes")
    if command.pivot is not None:
        check_name(command.pivot, PIVOTS, "pivot")
    work.placing = replace(work.placing, **given(command))


def set_position(work: Workspace, command: c.SetPosition) -> None:
    pivot = _pivot(work)
    _check(command.axis, [command.value], "position")
    shift = np.zeros(3)
    shift[command.axis] = command.value - pivot[command.axis]
    _place(work, motion(np.eye(3), shift), "Move", command.axis)


def set_rotation(work: Workspace, command: c.SetRotation) -> None:
    pivot = _pivot(work)
    _check(command.axis, command.degrees, "rotation")
    before = rotation_of(work.document.pose.of(work.selected[0].key))
    turn = from_euler_angles(command.degrees) @ before.T
    _place(work, motion(turn, centre=pivot), "Turn", command.axis)


def _place(work: Workspace, T: FloatArray, kind: str, axis: int) -> None:
    """Move the selected handles by T (4, 4). Entries of one kind and axis become one."""
    label = label_of(kind, work.selected)
    pose, before = placed(work, work.document.pose, T, kind), work.history.top
    with work.edit(label, merge=f"{label} {axis}") as gesture:
        gesture.change("pose", pose)
    if work.history.top is not before:  # else nothing was moved, and nothing is owed
        follow_placed(work, work.selected, kind)


def _pivot(work: Workspace) -> FloatArray:
    pivot = work.pivot
    if pivot is None:
        raise c.CommandError("there is nothing to move: paint a handle first")
    return pivot


def _check(axis: int, values: Sequence[float], what: str) -> None:
    if axis not in (0, 1, 2):
        raise c.CommandError(f"axis must be 0, 1 or 2, got {axis!r}")
    for value in values:
        if not is_number(value):
            raise c.CommandError(f"{what} must be numbers, got {value!r}")


PLACING_ACTIONS: Actions = {
    c.MoveHandles: move_handles,
    c.TurnHandles: turn_handles,
    c.PickPivot: pick_pivot,
    c.SetPlacing: set_placing,
    c.SetPosition: set_position,
    c.SetRotation: set_rotation,
}
