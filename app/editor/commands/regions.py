"""What can be asked of handles and of the regions that are held."""

from __future__ import annotations

from dataclasses import dataclass

from app.editor.commands.command import Command


@dataclass(frozen=True)
class AddHandle(Command):
    """A new, empty handle, made active. Without a name it gets one."""

    name: str = ""


@dataclass(frozen=True)
class RenameHandle(Command):
    key: int
    name: str


@dataclass(frozen=True)
class RemoveHandle(Command):
    """Its vertices become free."""

    key: int


@dataclass(frozen=True)
class ActivateHandle(Command):
    """The handle that the handle brush paints."""

    key: int


@dataclass(frozen=True)
class SelectHandle(Command):
    """Place a handle together with those selected, as the active one; or no longer."""

    key: int


@dataclass(frozen=True)
class ClearFixed(Command):
    """Free all fixed vertices."""


@dataclass(frozen=True)
class ClearHandle(Command):
    """Free the vertices of a handle, and keep the handle."""

    key: int
