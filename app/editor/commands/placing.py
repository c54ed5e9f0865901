"""What places handles exactly: operators, numbers, and how both work."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from app.editor.commands.command import Command


@dataclass(frozen=True)
class MoveHandles(Command):
    """The selected handles follow the cursor without a button; see Operator."""


@dataclass(frozen=True)
class TurnHandles(Command):
    """The selected handles turn with the cursor without a button; see Operator."""


@dataclass(frozen=True)
class PickPivot(Command):
    """The next click on the surface says what the active handle turns about."""


@dataclass(frozen=True)
class SetPlacing(Command):
    """Change what is not None.

    gizmo: whether it shows.  axes: one of placing.AXES.  pivot: one of placing.PIVOTS.
    """

    interrupts: ClassVar[bool] = False
    gizmo: bool | None = None
    axes: str | None = None
    pivot: str | None = None


@dataclass(frozen=True)
class SetPosition(Command):
    """Move the selected handles until their pivot has this coordinate. axis: 0, 1 or 2."""

    axis: int
    value: float


@dataclass(frozen=True)
class SetRotation(Command):
    """Turn the selected handles about their pivot until the active one has this rotation.

    axis: 0, 1 or 2, of the angle that changed: changes of one angle become one entry.
    degrees: about the world's x, then y, then z.
    """

    axis: int
    degrees: tuple[float, float, float]
