"""Undo, redo, and taking back what is in progress."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from app.editor.commands.command import Command


@dataclass(frozen=True)
class Undo(Command):
    pass


@dataclass(frozen=True)
class Redo(Command):
    pass


@dataclass(frozen=True)
class CancelGesture(Command):
    """Take back the stroke or drag in progress, else what goes on beside it."""

    interrupts: ClassVar[bool] = False


@dataclass(frozen=True)
class CancelTask(Command):
    """Take back what takes its time, say an export; a stroke or drag goes on."""

    interrupts: ClassVar[bool] = False
