"""Where unsaved work is kept, and what of it is there."""

from __future__ import annotations

import contextlib
import json
import os
import secrets
import tempfile
import time
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from platformdirs import user_state_path

from app.model.preferences import PROGRAM
from app.model.schema import SessionError
from app.model.session.files import SUFFIX
from app.model.session.unsaved import UNSAVED
from app.unsaved.lock import Lock
from solver.storage import remove_orphans

PLACE = "SURFACE_DEFORMATION_STATE"  # an environment variable with another folder
OLD_SECONDS, MOST = 30 * 24 * 3600, 50  # what is older, and not among so many, may go
LINES, LONGEST = 8, 100_000  # of the beginning of a file, where UNSAVED is


@dataclass(frozen=True)
class Kept:
    """Work in a file that no window has open: this process holds it until `lock` is released.

    at: seconds since the epoch.  unsaved: see UNSAVED.
    """

    path: Path
    lock: Lock
    at: float
    unsaved: dict[str, Any]

    @property
    def mesh(self) -> Path:
        """The file of its mesh, which may be gone."""
        return Path(self.unsaved["mesh"])

    @property
    def session(self) -> Path | None:
        """The session file that it goes on from."""
        return Path(self.unsaved["session"]) if "session" in self.unsaved else None

    def dismiss(self) -> None:
        """Nobody wants it any more. Raises OSError."""
        self.path.unlink(missing_ok=True)
        self.lock.release()


def places() -> tuple[Path, ...]:
    """Where the platform keeps the state of programs; then where there may be room if not there."""
    told = os.environ.get(PLACE)
    first = Path(told) if told else user_state_path(PROGRAM, appauthor=False) / "unsaved"
    user = os.getuid() if hasattr(os, "getuid") else "user"
    return first, Path(tempfile.gettempdir()) / f"{PROGRAM}-unsaved-{user}"


def new_file(folder: Path, stem: str) -> tuple[Path, Lock]:
    """A name in `folder` that is this process's alone. Raises OSError."""
    folder.mkdir(mode=0o700, parents=True, exist_ok=True)
    while True:
        path = folder / f"{stem[:60]}-{secrets.token_hex(6)}{SUFFIX}"
        lock = Lock.take(lock_path(path))
        if lock is not None:  # else another window was just tidying up
            return path, lock


def lock_path(path: Path) -> Path:
    """What whoever writes `path` holds."""
    return path.with_suffix(".lock")


def kept_work() -> list[Kept]:
    """What no window that runs has open, the last first; each is held until it is released."""
    found = [kept for folder in places() for kept in _in(folder)]
    return sorted(found, key=lambda kept: kept.at, reverse=True)


def clean_up() -> None:
    """Remove what is old where there is much, and what windows that were killed left behind."""
    now = time.time()
    found = kept_work()
    for number, kept in enumerate(found):
        if number >= MOST and now - kept.at > OLD_SECONDS:
            with contextlib.suppress(OSError):
                kept.path.unlink()
        kept.lock.release()
    for folder in places():
        remove_orphans(folder)
        _remove_locks(folder)


def _in(folder: Path) -> Iterator[Kept]:
    for path in _listed(folder, SUFFIX):
        with contextlib.suppress(OSError, SessionError):
            unsaved = read_unsaved(path)
            lock = Lock.take(lock_path(path))
            if lock is not None:
                yield Kept(path, lock, path.stat().st_mtime, unsaved)


def read_unsaved(path: Path) -> dict[str, Any]:
    """What stands at the beginning of a file of unsaved work. Raises OSError, SessionError."""
    with path.open(encoding="utf-8", errors="replace") as file:
        for line in (file.readline(LONGEST) for _ in range(LINES)):
            with contextlib.suppress(ValueError):
                found = json.loads(f"{{{line.strip().rstrip(',')}}}")
                if "unsaved" in found:
                    return dict(UNSAVED(found["unsaved"], "unsaved"))
    raise SessionError(f"{path}: expected unsaved work")


def _remove_locks(folder: Path) -> None:
    """Of windows that were killed before they kept anything."""
    for path in _listed(folder, ".lock"):
        with contextlib.suppress(OSError):
            if (lock := Lock.take(path)) is not None:
                lock.release()


def _listed(folder: Path, suffix: str) -> list[Path]:
    """Of the folder, unless others could write there."""
    with contextlib.suppress(OSError):
        if not hasattr(os, "getuid") or folder.stat().st_uid == os.getuid():
            return sorted(path for path in folder.iterdir() if path.suffix == suffix)
    return []
