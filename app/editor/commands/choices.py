"""What a person chooses: the tool, how it works, the map that is shown."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from app.editor.commands.command import Command


@dataclass(frozen=True)
class SetTool(Command):
    """Take one of tools.TOOLS into the hand."""

    name: str


@dataclass(frozen=True)
class SetBrush(Command):
    """Change what is not None.

    radius: see Brush; on_screen: whether it keeps its size there, wherever the camera goes;
    strength, value in [0, 1]; mode: see Brush.
    """

    interrupts: ClassVar[bool] = False
    radius: float | None = None
    strength: float | None = None
    value: float | None = None
    mode: str | None = None
    on_screen: bool | None = None


@dataclass(frozen=True)
class SetMarking(Command):
    """How a press marks vertices; changes what is not None, see Marking."""

    shape: str | None = None
    through: bool | None = None


@dataclass(frozen=True)
class SetTurn(Command):
    """Whether a dragged handle turns by itself or keeps its orientation."""

    interrupts: ClassVar[bool] = False
    on: bool


@dataclass(frozen=True)
class SetKeep(Command):
    """Whether what is grabbed stays where it was taken, as a pin, or is let go of.

    on: None for the other of the two.
    """

    interrupts: ClassVar[bool] = False
    on: bool | None = None


@dataclass(frozen=True)
class SetMap(Command):
    """Show one of color_maps.MAPS."""

    interrupts: ClassVar[bool] = False
    name: str
