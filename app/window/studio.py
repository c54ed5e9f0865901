"""Takes pictures of the scene: one, a turn around it, or what happens while it records."""

from __future__ import annotations

import threading
import time
from pathlib import Path
from typing import Literal

import numpy as np

from app.bundled import writable
from app.editor.editor import Editor
from app.editor.replacing import whole
from app.model.free_path import free_path
from app.telling import tell
from app.viewpoint.camera import Camera
from app.viewpoint.moves import orbited
from app.window.film import Film, Picture, PictureError, check_pictures, save_picture
from app.window.panel.widgets import WIDTH
from app.window.scaling import scaled
from app.window.view import View
from solver.types import BoolArray, FloatArray

PICTURES = ("picture", "turntable", "record")
TURN_FRAMES, TURN_SECONDS = 72, 6.0
PAUSE = 1 / 12  # seconds between two frames of a recording, or more where taking one takes longer:
SHARE = 0.4  # of the time at most; a drag has the rest


class Studio:
    """What takes pictures and films of an editor's scene, between two frames of the window."""

    def __init__(self, editor: Editor, view: View) -> None:
        self._editor = editor
        self._view = view
        self._asked = ""
        self._turn: Film | None = None
        self._middle: FloatArray = np.zeros(3)  # what the turntable turns about
        self._film: Film | None = None
        self._next = 0.0
        self._saving: threading.Thread | None = None
        self._saved: tuple[str, Literal["info", "error"]] = "", "info"

    @property
    def recording(self) -> float | None:
        """How many seconds have been recorded, None while nothing is."""
        return None if self._film is None else self._film.seconds

    @property
    def turning(self) -> Camera | None:
        """What the turntable sees next, None where it stands still."""
        if self._turn is None:
            return None
        viewpoint = self._editor.viewpoint
        # As far as the cursor would have to be moved: twice the height of the window is one turn.
        way = 2.0 * viewpoint.camera.size[1] * self._turn.count / TURN_FRAMES
        return orbited(viewpoint.camera, self._middle, (way, 0.0), viewpoint.up)

    def ask(self, name: str) -> None:
        """One of PICTURES; "record" also ends a recording. Raises PictureError."""
        check_pictures()
        if name == "picture":
            self._asked = name
        elif name == "record" and self._film is not None:
            self._end_recording(self._film)
        elif self._saving is not None or self._turn is not None or self._film is not None:
            raise PictureError("one film at a time: the last one is not finished yet")
        elif name == "turntable":
            seen = self._editor.positions[self._seen()]
            self._middle = 0.5 * (seen.min(axis=0) + seen.max(axis=0))
            self._turn = Film()
        else:
            self._film, self._next = Film(), 0.0
            self._editor.say("Recording; press Stop to save it")

    def work(self) -> None:
        """Once a frame, after it was drawn. Raises SolverError."""
        if self._asked:
            self._asked = ""
            path = free_path(self._path("picture.png"))
            save_picture(self._picture(), path)
            self._editor.say(f"Saved {path}")
        if self._turn is not None:
            self._take_turn(self._turn)
        if self._film is not None:
            self._record(self._film)
        self._tell()

    def close(self) -> None:
        """Save the film that is being recorded, and wait for the one that is being saved."""
        if self._film is not None:
            self._end_recording(self._film)
        if self._saving is not None:
            self._saving.join()
            tell(self._saved[0])

    def _take_turn(self, film: Film) -> None:
        number = film.count
        film.add(self._picture(), number * TURN_SECONDS / TURN_FRAMES)
        resized = film.count == number  # the window is: the turn ends where it is
        if resized or film.count == TURN_FRAMES:
            self._turn = None
            self._save_behind(film, "turntable")

    def _record(self, film: Film) -> None:
        start = time.perf_counter()
        if start < self._next:
            return
        film.add(self._picture(), start)
        took = time.perf_counter() - start
        self._next = start + max(PAUSE, took / SHARE)
        if film.full:
            self._end_recording(film)
            self._editor.say(f"The recording is full after {film.seconds:.0f} s: saving it ...")

    def _end_recording(self, film: Film) -> None:
        self._film = None
        self._save_behind(film, "recording")

    def _save_behind(self, film: Film, name: str) -> None:
        """In the background: saving takes longer than a frame."""
        path = self._path(f"{name}.gif")
        self._saving = threading.Thread(target=self._save, args=(film, path))
        self._editor.say("Saving ...")
        self._saving.start()

    def _save(self, film: Film, path: Path) -> None:
        try:
            path = free_path(path)  # now: another window may have saved meanwhile
            film.save(path)
            self._saved = f"Saved {path}", "info"
        except Exception as error:  # of a thread: nobody else would hear of it
            self._saved = str(error), "error"

    def _tell(self) -> None:
        if self._saving is not None and not self._saving.is_alive():
            self._saving = None
            self._editor.say(*self._saved)

    def _picture(self) -> Picture:
        """The scene beside the panel."""
        pixels = self._view.pixels()
        covered = scaled(WIDTH) / self._editor.viewpoint.camera.size[0]
        return pixels[:, round(covered * pixels.shape[1]) :]

    def _seen(self) -> BoolArray:
        """(n,) the vertices of what is shown."""
        return self._editor.parts.visible & (self._editor.document.mesh.pieces >= 0)

    def _path(self, ending: str) -> Path:
        mesh = self._editor.document.path
        return whole(writable(mesh.with_name(f"{mesh.stem}-{ending}")))
