"""Keeps unsaved work in time: while a person works on, and when the window ends."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Iterator
from contextlib import suppress
from datetime import datetime
from pathlib import Path
from typing import Any

from app.bundled import is_bundled
from app.model.document import Document
from app.model.session.mesh import mesh_hash, mesh_places
from app.model.session.unsaved import holds
from app.model.session.writing import session_pieces
from app.unsaved.file import UnsavedFile
from app.unsaved.places import Kept
from app.workspace.workspace import Workspace
from solver.errors import SolverError

NEVER = -1  # of revisions
MANY = 100  # steps of work that are kept before their time: an hour's, done in less
# Of a frame, for writing numbers down: at least so many seconds, and such a share of a slow one.
SECONDS, SHARE = 0.002, 0.05


class Keeper:
    """What looks after the unsaved work of one workspace.

    Numbers are written down bit by bit between two frames, from a frozen copy, since a million of
    them in one go would take a second; the file is written behind.
    """

    def __init__(self, work: Workspace, seconds: float) -> None:
        """seconds: how long changes go unkept."""
        self._work = work
        self._seconds = seconds
        self._file = UnsavedFile()
        self._said = ""
        self._thread: threading.Thread | None = None
        self._failed: SolverError | None = None
        self._begin()

    def _begin(self) -> None:
        """Another document is open, as some file has it."""
        self._serial = self._work.document.serial
        self._stepped = time.monotonic()
        self._pieces: Iterator[bytes] | None = None
        self._data = bytearray()  # not a list: joining it would hold up everything else
        self._kept, self._dismissed = self._version, NEVER
        self._count()
        self._behind(self._describe_mesh)

    def _count(self) -> None:
        """From here: time, and steps of work."""
        self._since: float | None = None
        self._steps, self._top = 0, self._work.history.top

    @property
    def _version(self) -> int:
        return max(self._work.document.revision.values())

    @property
    def unsaved(self) -> bool:
        """Whether there is work that neither a session file holds nor a person has dismissed."""
        work = self._work
        begun = work.history.dirty or work.interaction is not None
        return begun and self._version != self._dismissed

    def step(self) -> None:
        """Once a frame. Raises FileError where nothing can be kept anywhere."""
        now = time.monotonic()
        took, self._stepped = now - self._stepped, now
        self._steps += self._work.history.top is not self._top
        self._top = self._work.history.top
        if self._thread is not None:
            if not self._thread.is_alive():
                self._thread = None
                self._tell()
        elif self._serial != self._work.document.serial:
            self.follow()
        elif not self.unsaved:
            self._drop()
        elif self._pieces is not None:
            self._write_down(self._pieces, max(SECONDS, SHARE * took))
        elif self._due(now):
            self._write_down(self._freeze(), SECONDS)

    def hurry(self) -> None:
        """Something went wrong: keep what there is as soon as can be."""
        self._since = -float("inf")

    def keep(self) -> Path | None:
        """Keep it now, whole, with the stroke or drag in progress; None where all is saved.

        Raises FileError.
        """
        with suppress(SolverError, OSError):  # it must not stand in the way of all else
            self._work.finish()
        self._wait()
        if self._failed is not None:
            self._failed, self._kept = None, NEVER
        if not self.unsaved:
            self._drop()
        elif self._file.path is None or self._version != self._kept or self._pieces is not None:
            self._file.write(self._stem, b"".join(self._freeze()))
            self._pieces = None
        return self._file.path

    def dismiss(self) -> None:
        """Nobody wants what is unsaved now."""
        self._file.remove()
        self._kept = self._dismissed = self._version
        self._pieces = None
        self._count()

    def follow(self, kept: Kept | None = None) -> None:
        """Another document is open: what was kept of the last stays for the next start.

        kept: the work that it is, None for what some file has.
        """
        self._wait()
        if kept is None:
            self._file.release()
        else:
            self._file.take(kept)
        self._begin()

    def close(self) -> None:
        """Leave what is kept to the next start."""
        self._file.release()

    def _wait(self) -> None:
        if self._thread is not None:
            self._thread.join()
            self._thread = None

    @property
    def _stem(self) -> str:
        return self._work.document.path.stem

    def _due(self, now: float) -> bool:
        if self._version == self._kept:
            return False
        if self._since is None:
            self._since = now
        return now - self._since >= self._seconds or self._steps >= MANY

    def _freeze(self) -> Iterator[bytes]:
        document = self._work.document.frozen()
        self._kept = self._version
        self._count()
        self._data = bytearray()
        self._pieces = self._pieces_of(document, self._work.session_path)
        return self._pieces

    def _describe_mesh(self) -> None:
        """What a session says of a mesh is found once, and takes its time where that is large."""
        mesh = self._work.document.mesh
        mesh_hash(mesh)
        mesh_places(mesh)

    def _pieces_of(self, document: Document, session: Path | None) -> Iterator[bytes]:
        mesh = str(document.path.resolve())
        unsaved: dict[str, Any] = {
            "at": datetime.now().astimezone().isoformat(timespec="seconds"),
            "mesh": mesh,
            "holds": holds(document),
        }
        if session is not None and not is_bundled(session):
            unsaved["session"] = str(session.resolve())
        yield from session_pieces(document, {"path": mesh}, unsaved=unsaved)

    def _write_down(self, pieces: Iterator[bytes], seconds: float) -> None:
        end = time.perf_counter() + seconds
        for piece in pieces:
            self._data += piece
            if time.perf_counter() > end:
                return
        self._pieces = None
        data, self._data = self._data, bytearray()
        self._behind(lambda: self._write(self._stem, data))

    def _behind(self, work: Callable[[], None]) -> None:
        """In a thread: a disk may take its time, and so does a large mesh."""
        self._thread = threading.Thread(target=work)
        self._thread.start()

    def _write(self, stem: str, data: bytearray) -> None:
        try:
            self._file.write(stem, data)
        except SolverError as error:
            self._failed = error

    def _tell(self) -> None:
        """What became of it, for the person. Raises FileError."""
        failed, self._failed = self._failed, None
        if failed is not None:
            self._kept = NEVER
            raise failed
        if self._file.moved and self._file.moved != self._said:
            self._said = self._file.moved
            self._work.say(f"{self._said}: unsaved work is kept in {self._file.path}", "error")

    def _drop(self) -> None:
        """All is saved: what was kept is of no use."""
        if self._file.path is not None or self._version != self._kept:
            self.dismiss()
