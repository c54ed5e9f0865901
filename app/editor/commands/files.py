"""What opens and saves files."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import ClassVar

from app.editor.commands.command import Command


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

    path: Path | None = None
