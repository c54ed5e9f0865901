"""Reading and writing whole files: a save never leaves half a file behind."""

from __future__ import annotations

import contextlib
import os
import shutil
import uuid
from pathlib import Path

from solver.errors import FileError


def read_bytes(path: str | os.PathLike[str]) -> bytes:
    """Everything in the file. Raises FileError, in one line, where it cannot be read."""
    if os.path.isdir(path):
        raise FileError(f"{path}: is a folder, expected a file")
    try:
        return Path(path).read_bytes()
    except (OSError, ValueError) as error:
        raise FileError(f"{path}: cannot be read: {_reason(error)}") from error


def write_atomically(path: str | os.PathLike[str], data: bytes) -> None:
    """Write beside the target, flush to the disk, then replace.

    A symbolic link is written through; an existing file keeps its permissions.
    Raises FileError and leaves the old file (and nothing else) where the new one cannot be written.
    """
    try:
        target = Path(os.path.realpath(path))
        _check_target(target)
        _replace(target, data)
    except (OSError, ValueError) as error:
        raise FileError(f"{path}: cannot be written: {_reason(error)}") from error


def _check_target(target: Path) -> None:
    if not target.parent.is_dir():
        raise FileNotFoundError(f"the folder {target.parent} does not exist")
    # Replacing a folder or a device such as /dev/null would destroy it.
    if target.exists() and not target.is_file():
        raise OSError("it is not a regular file")
    # A rename needs no right to write the old file, so a write-protected one is refused here.
    if target.exists() and not os.access(target, os.W_OK):
        raise PermissionError("it is write-protected")


def _replace(target: Path, data: bytes) -> None:
    temporary = target.parent / f".{uuid.uuid4().hex}.tmp"
    try:
        with temporary.open("xb") as stream:
            stream.write(data)
            stream.flush()
            os.fsync(stream.fileno())
        if target.exists():
            with contextlib.suppress(OSError):
                shutil.copymode(target, temporary)
        os.replace(temporary, target)
    finally:
        with contextlib.suppress(OSError):
            temporary.unlink()


def _reason(error: OSError | ValueError) -> str:
    """What went wrong, without the path that the caller already names."""
    return (isinstance(error, OSError) and error.strerror) or str(error)
