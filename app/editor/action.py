"""What an action is: a function that carries out one kind of command on what is open."""

from __future__ import annotations

from collections.abc import Callable, Collection
from typing import Any

from app.editor.commands import Command, CommandError
from app.model.handles import Handle
from app.workspace.workspace import Workspace

MOST_BETWEEN = 100

Action = Callable[[Workspace, Any], None]  # Any: the kind of command it stands beside in its table
Actions = dict[type[Command], Action]


def check_name(name: str, names: Collection[str], what: str) -> None:
    """Raise CommandError unless `name` is one of the names of a table."""
    if name not in names:
        raise CommandError(f"unknown {what} {name!r}, expected one of {', '.join(names)}")


def check_between(count: int) -> int:
    """The same number of shapes between two poses. Raises CommandError if it is none."""
    if type(count) is not int or not 0 <= count <= MOST_BETWEEN:
        raise CommandError(f"shapes between two poses must be 0 to {MOST_BETWEEN}, got {count!r}")
    return count


def given(command: Command) -> dict[str, Any]:
    """The fields of a command that are not None: what it asks to change, by name."""
    return {name: value for name, value in vars(command).items() if value is not None}


def find_handle(work: Workspace, key: int) -> Handle:
    """The handle with this key. Raises CommandError."""
    handle = work.document.find(key)
    if handle is None:
        raise CommandError(f"there is no handle with key {key!r}")
    return handle
