"""What can be asked of the softness field as a whole."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from app.editor.commands.command import Command


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
