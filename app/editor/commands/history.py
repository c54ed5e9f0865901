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
    """Take back the stroke or drag in progress."""

    interrupts: ClassVar[bool] = False
