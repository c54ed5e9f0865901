"""Pictures of the scene, one or many, and how they become files."""

from __future__ import annotations

import io
import os
import tempfile
import threading
from collections.abc import Iterator
from contextlib import closing
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path
from queue import Queue

import numpy as np

from app.bundled import writable
from app.editor.commands import Command
from app.editor.files.replacing import whole
from app.model.free_path import free_path
from app.window.films.files import FILMS, FilmFile, Picture, PictureError, check_library
from solver.errors import SolverError
from solver.storage import write_atomically

WAITING = 8  # frames that are taken and not yet written
CHUNK = 1 << 20  # bytes copied at a time


def default_film_path(mesh: Path, ending: str) -> Path:
    """Beside the mesh, where no file is: an MP4 where those can be made."""
    suffix = ".mp4" if find_spec("av") is not None else ".gif"
    return beside(mesh, f"{ending}{suffix}")


def beside(mesh: Path, ending: str) -> Path:
    """A name that no file has, beside a mesh, or beside the program where that is its own."""
    return free_path(whole(writable(mesh.with_name(f"{mesh.stem}-{ending}"))))


def save_picture(picture: Picture, path: Path) -> None:
    """As a PNG. Raises FileError, PictureError where Pillow is missing."""
    check_library("PIL")
    from PIL import Image

    stream = io.BytesIO()
    Image.fromarray(picture).save(stream, "PNG")
    write_atomically(path, stream.getvalue())


@dataclass(frozen=True)
class TakeFilm(Command):
    """Begin a film. name: "turntable" or "record".  path: where it goes.

    replace: whether a person has agreed to replace what is there.
    """

    name: str
    path: Path
    replace: bool = False


class Film:
    """Frames of one size on their way into a file; a thread writes them while more are taken.

    They go to a file of their own, and in the end to `path`, or where something is there already
    and must not be replaced, to a name beside it.
    saved: what became of it, and whether that is what was asked for; None as long as it is written.
    Raises PictureError where that is no film, or where none can be.
    """

    def __init__(self, path: Path, replace: bool = False) -> None:
        if path.suffix.lower() not in FILMS:
            raise PictureError(f"{path}: a film is one of {', '.join(FILMS)}")
        if not os.access(path.parent, os.W_OK):
            raise PictureError(f"{path}: its folder is not there or cannot be written to")
        self._path, self._replace, self._kind = whole(path), replace, FILMS[path.suffix.lower()]
        number, name = tempfile.mkstemp(path.suffix.lower(), "film-")
        os.close(number)
        self._own = Path(name)
        try:
            self._file = self._kind(self._own)
        except BaseException:
            self._own.unlink()
            raise
        self._frames: Queue[tuple[Picture, float] | None] = Queue(WAITING)
        self._shape: tuple[int, ...] | None = None
        self._start = self.seconds = 0.0  # from the first frame to the last
        self.count = 0
        self.saved: tuple[str, bool] | None = None
        self._thread = threading.Thread(target=self._work)
        self._thread.start()

    @property
    def full(self) -> bool:
        """Whether no more frames are kept."""
        return self.count >= self._kind.most

    @property
    def ready(self) -> bool:
        """Whether the next frame would not have to wait for others to be written."""
        return not self._frames.full()

    def add(self, picture: Picture, time: float) -> None:
        """A frame that was taken at so many seconds; another size than the first is left out."""
        if self._shape is None:
            self._shape, self._start = picture.shape, time
        if not self.full and picture.shape == self._shape:
            self.count, self.seconds = self.count + 1, time - self._start
            self._frames.put((picture, self.seconds))

    def end(self) -> None:
        """There are no more; what is left is written meanwhile."""
        self._frames.put(None)

    def wait(self) -> None:
        """Until it is saved."""
        self._thread.join()

    def _work(self) -> None:
        """Of the thread: nobody else would hear of what it raises."""
        frames = iter(self._frames.get, None)
        fault: Exception | None = None
        whole = False
        try:
            with closing(self._file) as file:
                try:
                    for frame in _timed(frames):
                        _add(file, *frame)
                except Exception as error:
                    fault = error
            whole = self.count > 0
        except Exception as error:
            fault = fault or error
        for _ in frames:  # nobody may wait for room
            pass
        self.saved = self._keep(fault) if whole else self._drop(fault)

    def _drop(self, fault: Exception | None) -> tuple[str, bool]:
        self._own.unlink()
        return f"{self._path}: no film was saved: {fault or 'nothing was recorded'}", False

    def _keep(self, fault: Exception | None) -> tuple[str, bool]:
        """In its place; where that cannot be, where it is."""
        self._path = self._path if self._replace else free_path(self._path)
        try:
            with self._own.open("rb") as stream:
                write_atomically(self._path, iter(lambda: stream.read(CHUNK), b""))
        except SolverError as error:
            return f"{error}; the film is kept in {self._own}", False
        self._own.unlink()
        if fault is not None:
            return f"Saved {self._path}, which ends too early: {fault}", False
        return f"Saved {self._path}", True


def _timed(frames: Iterator[tuple[Picture, float]]) -> Iterator[tuple[Picture, float, float]]:
    """Each with its end, where the next begins; the last is as long as the one before it."""
    lasts, last = 1.0, next(frames, None)
    for frame in frames:
        assert last is not None
        lasts = frame[1] - last[1]
        yield *last, frame[1]
        last = frame
    if last is not None:
        yield *last, last[1] + lasts


def _add(file: FilmFile, picture: Picture, start: float, end: float) -> None:
    file.add(_smaller(picture, -(-picture.shape[1] // file.widest)), start, end)


def _smaller(picture: Picture, step: int) -> Picture:
    """The mean of blocks of step by step pixels."""
    if step == 1:
        return picture
    height, width = (length // step for length in picture.shape[:2])
    blocks = picture[: height * step, : width * step].reshape(height, step, width, step, 3)
    return np.asarray(blocks.mean(axis=(1, 3)).astype(np.uint8))
