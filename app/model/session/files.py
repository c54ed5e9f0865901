"""What is told about a session file before it is read or replaced."""

from __future__ import annotations

from pathlib import Path

from app.model.session.writing import FORMAT
from solver.storage import read_bytes

BEGINNING = 64  # bytes, enough for a byte order mark and spaces
SUFFIX = ".json"


def is_session(path: Path) -> bool:
    """Whether a file is a session of this program, though perhaps one that cannot be read.

    Raises FileError.
    """
    with path.open("rb") as file:
        if not file.read(BEGINNING).lstrip(b"\xef\xbb\xbf \t\r\n").startswith(b"{"):
            return False
    return f'"{FORMAT}"'.encode() in read_bytes(path)


def session_name(path: Path) -> Path:
    """The same with the suffix of sessions, which is added where there is another one.

    What can only be a folder, ".", ".." or "/", stays as it is.
    """
    if path.name in ("", "..") or path.suffix.lower() == SUFFIX:
        return path
    return path.with_name(path.name + SUFFIX)
