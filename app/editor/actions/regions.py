"""What the commands do to the handles and to the regions that are held."""

from __future__ import annotations

from dataclasses import replace

from app.editor import commands as c
from app.editor.action import Actions, find_handle
from app.model.handles import FREE
from app.model.poses import without_handle
from app.workspace.workspace import Workspace


def add_handle(work: Workspace, command: c.AddHandle) -> None:
    handle = work.document.new_handle(command.name.strip())
    with work.edit(f"Add {handle.name}") as gesture:
        gesture.change("handles", (*work.document.handles, handle))
    work.chosen.activate(handle.key)


def rename_handle(work: Workspace, command: c.RenameHandle) -> None:
    handle, name = find_handle(work, command.key), command.name.strip()
    if not name:
        raise c.CommandError("a handle's name must not be empty")
    with work.edit(f"Rename {handle.name}", merge=f"rename {handle.key}") as gesture:
        handles = work.document.handles
        renamed = (replace(h, name=name) if h is handle else h for h in handles)
        gesture.change("handles", tuple(renamed))


def remove_handle(work: Workspace, command: c.RemoveHandle) -> None:
    document, handle = work.document, find_handle(work, command.key)
    with work.edit(f"Remove {handle.name}") as gesture:
        gesture.change("role", FREE, document.vertices_of(handle.key))
        gesture.change("handles", tuple(h for h in document.handles if h is not handle))
        gesture.change("pose", document.pose.without(handle.key))
        gesture.change("poses", without_handle(document.poses, handle.key))


def activate_handle(work: Workspace, command: c.ActivateHandle) -> None:
    work.chosen.activate(find_handle(work, command.key).key)


def select_handle(work: Workspace, command: c.SelectHandle) -> None:
    work.chosen.select(find_handle(work, command.key).key)


def clear_fixed(work: Workspace, command: c.ClearFixed) -> None:
    with work.edit("Clear fixed") as gesture:
        gesture.change("role", FREE, work.document.fixed)


def clear_handle(work: Workspace, command: c.ClearHandle) -> None:
    handle = find_handle(work, command.key)
    with work.edit(f"Clear {handle.name}") as gesture:
        gesture.change("role", FREE, work.document.vertices_of(handle.key))


REGION_ACTIONS: Actions = {
    c.AddHandle: add_handle,
    c.RenameHandle: rename_handle,
    c.RemoveHandle: remove_handle,
    c.ActivateHandle: activate_handle,
    c.SelectHandle: select_handle,
    c.ClearFixed: clear_fixed,
    c.ClearHandle: clear_handle,
}
