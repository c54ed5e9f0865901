"""What can be asked of the softness field as a whole."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import ClassVar

from app.editor.commands.command import Command


@dataclass(frozen=True)
class ClearSoftness(Command):
    """Rigid everywhere, and nothing pinned."""


@dataclass(frozen=True)
class FillSoftness(Command):
    """Keep the pinned values and blend between them, as far as they are from each other."""

    notice: ClassVar[str] = "Working ..."


@dataclass(frozen=True)
class SmoothSoftness(Command):
    """Even out the whole field, pins included. around: only near these vertices."""

    notice: ClassVar[str] = "Working ..."
    around: tuple[int, ...] | None = None


@dataclass(frozen=True)
class ClearPins(Command):
    """Pin nothing; the softness stays."""


@dataclass(frozen=True)
class LearnSoftness(Command):
    """Find the softness with which the surface takes the shapes of meshes with its vertices."""

    paths: tuple[Path, ...]
