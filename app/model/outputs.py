"""Whether a command without a window may write its files: it cannot ask."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path

from app.model.session.files import SUFFIX, is_session
from solver.errors import FileError


def check_outputs(files: Iterable[Path], force: bool = False, inputs: Sequence[Path] = ()) -> None:
    """Raise FileError for a file that must not be replaced.

    That is each that is there, unless `force`; and in any case what the result is made from, a
    session by anything else, and by a session what is none.
    """
    for file in files:
        if not file.exists():
            continue
        if any(source.exists() and file.samefile(source) for source in inputs):
            raise FileError(f"{file} is what the result is made from; expected another name")
        if file.is_file() and is_session(file) != (file.suffix.lower() == SUFFIX):
            kind = "no session of this program" if file.suffix.lower() == SUFFIX else "a session"
            raise FileError(f"{file} is {kind}; expected another name")
        if not force:
            raise FileError(
                f"{file} is there already; expected another name, or --force to replace it"
            )
