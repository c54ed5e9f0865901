"""The file of one window's unsaved work: wherever there is room for it."""

from __future__ import annotations

import contextlib
from pathlib import Path

from app.unsaved.lock import Lock
from app.unsaved.places import Kept, new_file, places
from solver.errors import FileError, SolverError
from solver.storage import write_atomically


class UnsavedFile:
    """None before the first write, and after `remove` or `release`.

    moved: why it is not where the platform keeps such files; empty where it is.
    """

    def __init__(self) -> None:
        self._held: tuple[Path, Lock] | None = None
        self.moved = ""

    @property
    def path(self) -> Path | None:
        """Where it is, None where there is none."""
        return None if self._held is None else self._held[0]

    def write(self, stem: str, data: bytes | bytearray) -> Path:
        """Over what it held before. stem: begins its name. Raises FileError."""
        reasons: list[str] = []
        if self._held is not None:
            path, _ = self._held
            try:
                write_atomically(path, data)
            except SolverError as error:
                reasons.append(str(error))
            else:
                return path
        for folder in places():
            try:
                anew = _written(folder, stem, data)
            except SolverError as error:
                reasons.append(str(error))
            else:
                self.remove()  # what is older than this
                self._held, self.moved = anew, "; ".join(reasons)
                return anew[0]
        raise FileError(f"unsaved work cannot be kept: {reasons[0]}")

    def take(self, kept: Kept) -> None:
        """This window goes on with that work; what it had before is left to others."""
        self.release()
        self._held = kept.path, kept.lock

    def remove(self) -> None:
        """Nothing in it is wanted any more."""
        if self._held is not None:
            with contextlib.suppress(OSError):
                self._held[0].unlink(missing_ok=True)
        self.release()

    def release(self) -> None:
        """Leave it to the next start."""
        held, self._held = self._held, None
        if held is not None:
            held[1].release()


def _written(folder: Path, stem: str, data: bytes | bytearray) -> tuple[Path, Lock]:
    """A new file. Raises FileError."""
    try:
        path, lock = new_file(folder, stem)
    except OSError as error:
        raise FileError(f"{folder}: cannot be written to: {error.strerror or error}") from error
    try:
        write_atomically(path, data)
    except SolverError:
        lock.release()
        raise
    return path, lock
