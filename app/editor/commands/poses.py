"""What can be asked of the pose, and of those that are kept.

A pose is named by its key; REST is the key of the rest shape.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import ClassVar

from app.editor.commands.command import Command


@dataclass(frozen=True)
class ResetPose(Command):
    """Every handle back to rest."""


@dataclass(frozen=True)
class KeepPose(Command):
    """Put the pose of now into the list; without a name it gets a free one."""

    name: str = ""


@dataclass(frozen=True)
class ReplacePose(Command):
    """Put the pose of now in the place of a kept one."""

    key: int


@dataclass(frozen=True)
class RenamePose(Command):
    key: int
    name: str


@dataclass(frozen=True)
class MovePose(Command):
    """Change places with the one above (-1) or below (1)."""

    key: int
    step: int


@dataclass(frozen=True)
class DuplicatePose(Command):
    key: int


@dataclass(frozen=True)
class DeletePose(Command):
    key: int


@dataclass(frozen=True)
class GoToPose(Command):
    """Every handle where a kept pose, or REST, has it."""

    key: int


@dataclass(frozen=True)
class BlendPoses(Command):
    """Every handle that share, 0 to 1, of the way from one pose to another."""

    start: int
    end: int
    share: float


@dataclass(frozen=True)
class ChooseBlend(Command):
    """Change what is not None: what the slider leads from and to, what an export has between.

    between: how many shapes there are between one kept pose and the next.
    """

    interrupts: ClassVar[bool] = False
    start: int | None = None
    end: int | None = None
    between: int | None = None


@dataclass(frozen=True)
class ExportPoses(Command):
    """The mesh as Export saves it, and all kept poses in it or in files beside it.

    between: how many shapes there are between one and the next, the rest shape first.
    """

    path: Path | None = None
    between: int = 0
    replace: bool = False


@dataclass(frozen=True)
class AddPose(Command):
    """Keep the pose in which handles are where a mesh with the same vertices has them."""

    path: Path


@dataclass(frozen=True)
class MakeRest(Command):
    """The surface as it is becomes the rest shape; kept poses lead where they did."""


@dataclass(frozen=True)
class RestoreRest(Command):
    """The file's shape is the rest shape again; the pose and the kept ones lead where they did."""


@dataclass(frozen=True)
class ResetHandle(Command):
    """One handle back to rest."""

    key: int
