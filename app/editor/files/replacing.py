"""Whether a file may be written: what is refused, and what is asked about first."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from dataclasses import replace
from itertools import count
from pathlib import Path

from app.editor import commands as c
from app.editor.question import CANCEL, Answer, Asks, Question
from app.model.session.files import is_session
from app.workspace.workspace import Workspace

Saving = c.SaveSession | c.Export | c.ExportPoses
SHOWN = 3  # files that a question names


def check_session_file(work: Workspace, path: Path) -> None:
    """Raise CommandError where a session would replace what is none."""
    if is_open_mesh(work, path):
        raise c.CommandError(f"{whole(path)} is the mesh that is open; expected another name")
    if path.is_file() and path.stat().st_size and not is_session(path):
        raise c.CommandError(f"{whole(path)} is no session of this program; expected another name")


def before_mesh(
    work: Workspace,
    command: c.Export | c.ExportPoses,
    path: Path,
    files: Callable[[Path], Sequence[Path]],
) -> None:
    """See ask_before; raise CommandError where a mesh would replace a session."""
    for file in files(path):
        if file.is_file() and is_session(file):
            raise c.CommandError(f"{whole(file)} is a session; a mesh needs another name")
    ask_before(work, command, path, files)


def ask_before(
    work: Workspace, command: Saving, path: Path, files: Callable[[Path], Sequence[Path]]
) -> None:
    """Raise Asks where a command would replace what is not the open document's own.

    Raise CommandError for a folder. files: what is written where the command goes to a path.
    """
    if path.is_dir():
        raise c.CommandError(f"{whole(path)} is a folder, expected a file")
    there = [] if command.replace else [f for f in files(path) if not work.own.may_replace(f)]
    if not there:
        return
    numbers = (path.with_name(f"{path.stem}-{number}{path.suffix}") for number in count(2))
    other = next(p for p in numbers if not any(f.exists() for f in files(p)))
    aside = Answer(f"Save as {other.name}", replace(command, path=other))
    over = Answer("Replace", replace(command, path=path, replace=True))
    raise Asks(Question(_what_is_there(work, there), (aside, over, CANCEL)))


def is_open_mesh(work: Workspace, path: Path) -> bool:
    """Whether a path names the file of the mesh that is open."""
    mesh = work.document.path
    same = path.exists() and mesh.exists() and path.samefile(mesh)
    return same or path.resolve() == mesh.resolve()


def whole(path: Path) -> Path:
    """A path as a message names it: from the root on."""
    return Path(os.path.abspath(path))


def _what_is_there(work: Workspace, there: Sequence[Path]) -> str:
    """Which files a command would replace, and what they are."""
    lines = [_sentence(work, path) for path in there[:SHOWN]]
    if len(there) > SHOWN:
        lines.append(f"So are {len(there) - SHOWN} more.")
    return "\n".join([*lines, "", "Replace it?" if len(there) == 1 else "Replace them?"])


def _sentence(work: Workspace, path: Path) -> str:
    if is_open_mesh(work, path):
        return f"{whole(path)} is the mesh that is open."
    if work.own.knows(path):
        return f"{whole(path)} was changed by somebody else meanwhile."
    return f"{whole(path)} is there already."
