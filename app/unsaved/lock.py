"""A file that one process at a time can hold; the system lets go of it when that process ends."""

from __future__ import annotations

import contextlib
import os
import sys
from pathlib import Path

if sys.platform == "win32":
    import msvcrt

    def _hold(number: int) -> None:
        msvcrt.locking(number, msvcrt.LK_NBLCK, 1)
else:
    import fcntl

    def _hold(number: int) -> None:
        fcntl.flock(number, fcntl.LOCK_EX | fcntl.LOCK_NB)


class Lock:
    """Held from `take` to `release`, however the process ends in between."""

    def __init__(self, path: Path, number: int) -> None:
        self._path, self._number = path, number

    @classmethod
    def take(cls, path: Path) -> Lock | None:
        """None where somebody holds it. Raises OSError where no file can be made."""
        number = os.open(path, os.O_RDWR | os.O_CREAT, 0o600)
        try:
            _hold(number)
            # who held it before may have taken the name away just now, and another made it anew
            if os.path.samestat(os.fstat(number), os.stat(path)):
                return cls(path, number)
        except OSError:
            pass
        os.close(number)
        return None

    def release(self) -> None:
        """Let others have it."""
        if os.name == "posix":  # while it is held, so that nobody else's is taken away
            self._path.unlink(missing_ok=True)
        os.close(self._number)
        if os.name != "posix":  # an open file has to keep its name there
            with contextlib.suppress(OSError):
                self._path.unlink()
