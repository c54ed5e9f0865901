"""What a person can ask for, as data; the actions do it."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar

from solver.errors import SolverError
from solver.softness.material import Material


class CommandError(SolverError):
    """A command asks for something that there is not, or that must not be done."""


@dataclass(frozen=True)
class Command:
    """interrupts: whether a stroke or drag in progress ends before the command is carried out.

    notice: what the window says while it carries out a command that takes its time, else empty.
    """

    interrupts: ClassVar[bool] = True
    notice: ClassVar[str] = ""


@dataclass(frozen=True)
class SetTool(Command):
    """Take one of tools.TOOLS into the hand."""

    name: str


@dataclass(frozen=True)
class SetBrush(Command):
    """Change what is not None.

    radius: fraction of the diagonal; strength, value in [0, 1]; mode: see Brush.
    """

    interrupts: ClassVar[bool] = False
    radius: float | None = None
    strength: float | None = None
    value: float | None = None
    mode: str | None = None


@dataclass(frozen=True)
class SetTurn(Command):
    """Whether a dragged handle turns by itself or keeps its orientation."""

    interrupts: ClassVar[bool] = False
    on: bool


@dataclass(frozen=True)
class SetMap(Command):
    """Show one of color_maps.MAPS."""

    interrupts: ClassVar[bool] = False
    name: str


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
class ClearFixed(Command):
    """Free all fixed vertices."""


@dataclass(frozen=True)
class ClearHandle(Command):
    """Free the vertices of a handle, and keep the handle."""

    key: int


@dataclass(frozen=True)
class ClearSoftness(Command):
    """Rigid everywhere, and nothing pinned."""


@dataclass(frozen=True)
class FillSoftness(Command):
    """Keep the pinned values, and give all vertices connected to one a harmonic softness."""

    notice: ClassVar[str] = "Working ..."


@dataclass(frozen=True)
class SmoothSoftness(Command):
    """Even out the whole field, pins included."""

    notice: ClassVar[str] = "Working ..."


@dataclass(frozen=True)
class ClearPins(Command):
    """Pin nothing; the softness stays."""


@dataclass(frozen=True)
class SetMaterial(Command):
    material: str | Material


@dataclass(frozen=True)
class SetSetting(Command):
    """One of document.SETTINGS."""

    name: str
    value: Any


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


@dataclass(frozen=True)
class ResetPose(Command):
    """Every handle back to rest."""


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


@dataclass(frozen=True)
class OpenMesh(Command):
    notice: ClassVar[str] = "Loading ..."
    path: Path


@dataclass(frozen=True)
class OpenSession(Command):
    notice: ClassVar[str] = "Loading ..."
    path: Path


@dataclass(frozen=True)
class SaveSession(Command):
    """Without a path: the session that was opened, or one beside the mesh."""

    path: Path | None = None


@dataclass(frozen=True)
class Export(Command):
    """Without a path: the one the program was started with, or one beside the mesh."""

    notice: ClassVar[str] = "Saving ..."
    path: Path | None = None
