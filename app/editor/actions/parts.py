"""What the commands do that concern the pieces of the mesh: seen or hidden, following or not."""

from __future__ import annotations

from app.editor import commands as c
from app.editor.action import Actions
from app.workspace.workspace import Workspace


def show_part(work: Workspace, command: c.ShowPart) -> None:
    _check(work, command.number)
    if not command.on and len(work.parts.hidden | {command.number}) == len(work.parts.all):
        raise c.CommandError("the last part that is shown cannot be hidden")
    work.show_part(command.number, command.on)


def set_follows(work: Workspace, command: c.SetFollows) -> None:
    _check(work, command.number)
    count = len(work.parts.all)
    following = {number for number in range(count) if work.document.follows(number)}
    following = following | {command.number} if command.on else following - {command.number}
    everything = {count: True, 0: False}
    attach = everything.get(len(following), sorted(following))
    if attach != work.document.attach:
        name = work.parts.name(command.number)
        with work.edit(f"{name}: {'follows' if command.on else 'stays'}") as gesture:
            gesture.change("attach", attach)


def _check(work: Workspace, number: int) -> None:
    if not 0 <= number < len(work.parts.all):
        raise c.CommandError(f"there is no piece {number!r}")


PART_ACTIONS: Actions = {c.ShowPart: show_part, c.SetFollows: set_follows}
