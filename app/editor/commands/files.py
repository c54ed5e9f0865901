"""What opens and saves files."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import ClassVar

from app.editor.commands.command import Command
from app.model.session.mesh import Carry


@dataclass(frozen=True)
class OpenMesh(Command):
    """fresh: without asking about the session that is beside it."""

    notice: ClassVar[str] = "Loading ..."
    path: Path
    fresh: bool = False


@dataclass(frozen=True)
class OpenSession(Command):
    """mesh: the file that it is put on, None for the one that it names.

    carry: how it gets onto a mesh that has changed, None to ask.
    """

    notice: ClassVar[str] = "Loading ..."
    path: Path
    mesh: Path | None = None
    carry: Carry | None = None


@dataclass(frozen=True)
class ContinueWork(Command):
    """Go on with unsaved work that was kept in a file. mesh, carry: see OpenSession."""

    notice: ClassVar[str] = "Loading ..."
    path: Path
    mesh: Path | None = None
    carry: Carry | None = None


@dataclass(frozen=True)
class SaveSession(Command):
    """Without a path: the session that was opened, or one beside the mesh.

    replace: whatever file is there, without asking; so for the others that save.
    """

    path: Path | None = None
    replace: bool = False


@dataclass(frozen=True)
class Export(Command):
    """Without a path: the one the program was started with, or one beside the mesh."""

    path: Path | None = None
    replace: bool = False
