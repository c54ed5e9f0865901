"""Keeps what a person made and did not save, when another file is opened or the window closes."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

from app.editor.editor import Editor
from app.editor.file_actions import default_session_path
from app.model.document import Document
from app.model.free_path import free_path
from app.model.session import write_session
from app.telling import tell
from solver.errors import FileError, SolverError


def keep_unsaved(editor: Editor) -> Path | None:
    """Write what no session file holds to one beside it, so that nothing made is ever lost.

    A stroke or drag in progress is a part of it. Returns the file, None where all is saved.
    Where that folder takes none, the file goes into the working directory, else the home.
    Raises FileError where nothing could be written.
    """
    with suppress(SolverError, OSError):  # it must not stand in the way of all else
        editor.finish()
    return _write(editor.document, default_session_path(editor)) if editor.dirty else None


def _write(document: Document, session: Path) -> Path:
    first: Exception | None = None
    folders: tuple[Callable[[], Path], ...] = (lambda: session.parent, Path.cwd, Path.home)
    for folder in folders:
        try:
            spare = free_path(folder() / f"{session.stem}-unsaved.json")
            write_session(spare, document)
        except (SolverError, OSError) as error:
            first = first or error
        else:
            tell(f"unsaved work is kept in {spare}")
            return spare
    raise FileError(f"unsaved work could not be kept: {first}") from first
