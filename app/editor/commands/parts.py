"""What can be asked of the parts of the mesh."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from app.editor.commands.command import Command


@dataclass(frozen=True)
class ShowPart(Command):
    """Show a piece of the mesh, or hide it. A hidden one cannot be painted; it still follows."""

    interrupts: ClassVar[bool] = False
    number: int
    on: bool


@dataclass(frozen=True)
class SetFollows(Command):
    """Whether a piece of the mesh follows the larger one that it is near."""

    number: int
    on: bool
