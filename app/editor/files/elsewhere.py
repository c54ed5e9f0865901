"""Where a file cannot be written, another folder is proposed: nobody is left with full hands."""

from __future__ import annotations

import os
import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import replace
from pathlib import Path

from app.editor.files.replacing import Saving
from app.editor.question import CANCEL, Answer, Asks, Question
from app.model.free_path import free_path
from solver.errors import FileError


@contextmanager
def or_elsewhere(command: Saving, path: Path) -> Iterator[None]:
    """Within, `path` is written. Raises Asks where it cannot be, FileError without another idea."""
    try:
        yield
    except FileError as error:
        spare = _spare(path)
        if spare is None:
            raise
        save = Answer("Save there", replace(command, path=spare))
        text = f"{error}.\n\nSave it as {spare} instead?"
        raise Asks(Question(text, (save, CANCEL))) from error


def _spare(path: Path) -> Path | None:
    """A new file in the first other folder that has some room."""
    for folder in (Path.cwd, Path.home, lambda: Path(tempfile.gettempdir())):
        with suppress(OSError, RuntimeError):  # one that is gone, and a person without a home
            found = folder().resolve()
            other = found != path.parent.resolve()
            if other and os.access(found, os.W_OK | os.X_OK) and shutil.disk_usage(found).free:
                return free_path(found / path.name)
    return None
