"""What the commands do with what was done: undo, redo, cancel."""

from __future__ import annotations

from app.editor import commands as c
from app.editor.action import Actions
from app.workspace.workspace import Workspace


def cancel_gesture(work: Workspace, command: c.CancelGesture) -> None:
    if work.interaction is not None:
        work.cancel()
    else:
        work.tasks.cancel()


def cancel_task(work: Workspace, command: c.CancelTask) -> None:
    work.tasks.cancel()


def undo(work: Workspace, command: c.Undo) -> None:
    entry = work.history.undo(work.document)
    work.say(f"Undone: {entry.label}" if entry else "Nothing to undo")


def redo(work: Workspace, command: c.Redo) -> None:
    entry = work.history.redo(work.document)
    work.say(f"Redone: {entry.label}" if entry else "Nothing to redo")


HISTORY_ACTIONS: Actions = {
    c.CancelGesture: cancel_gesture,
    c.CancelTask: cancel_task,
    c.Undo: undo,
    c.Redo: redo,
}
