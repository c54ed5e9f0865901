"""What a person can ask of the camera."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from app.editor.commands.command import Command


@dataclass(frozen=True)
class FrameSelected(Command):
    """See what is selected: the active handle, else the part under the cursor, else all.

    Asked once more, all.
    """

    interrupts: ClassVar[bool] = False


@dataclass(frozen=True)
class FrameVertices(Command):
    """See some vertices, from where the camera is."""

    interrupts: ClassVar[bool] = False
    vertices: tuple[int, ...]


@dataclass(frozen=True)
class ViewFrom(Command):
    """See the whole mesh from one of viewpoint.SIDES."""

    interrupts: ClassVar[bool] = False
    side: str


@dataclass(frozen=True)
class SetUp(Command):
    """Which axis is upright, one of viewpoint.UPS."""

    interrupts: ClassVar[bool] = False
    name: str


@dataclass(frozen=True)
class SetLooks(Command):
    """Change how the surface is drawn: what is not None of scene.looks.Looks."""

    interrupts: ClassVar[bool] = False
    edges: bool | None = None
    shading: str | None = None
    rest: bool | None = None
    beside: bool | None = None
