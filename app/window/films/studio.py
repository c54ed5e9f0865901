"""Takes pictures of the scene: one, a turn around it, or what happens while it records."""

from __future__ import annotations

import time
from dataclasses import replace

import numpy as np

from app.editor.editor import Editor
from app.telling import tell
from app.viewpoint.camera import Camera
from app.viewpoint.moves import orbited
from app.window.drawing.view import View
from app.window.films.files import Picture, PictureError, check_library
from app.window.films.film import Film, TakeFilm, beside, save_picture
from solver.geometry.bounding_box import middle
from solver.types import FloatArray

PICTURES = ("picture", "before-after")
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
        self._saving: Film | None = None

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
        """One of PICTURES, or "stop" for the end of a recording. Raises PictureError."""
        if name == "stop" and self._film is not None:
            self._end(self._film)
        elif name in PICTURES:
            check_library("PIL")
            self._asked = name

    def begin(self, film: TakeFilm) -> None:
        """A film. Raises PictureError."""
        if self._saving is not None or self._turn is not None or self._film is not None:
            raise PictureError("one film at a time: the last one is not finished yet")
        if film.name == "turntable":
            seen = self._editor.positions[self._editor.parts.framed]
            self._middle = middle(seen)
            self._turn = Film(film.path, film.replace)
        else:
            self._film, self._next = Film(film.path, film.replace), 0.0
            self._editor.say("Recording; press Stop to save it")

    def work(self) -> None:
        """Once a frame, after it was drawn. Raises SolverError."""
        if self._asked:
            self._take(self._asked)
        if self._turn is not None and self._turn.ready:
            self._take_turn(self._turn)
        if self._film is not None and self._film.ready:
            self._record(self._film)
        self._tell()

    def close(self) -> None:
        """Save the film that is being taken, and wait for the one that is being saved."""
        film = self._turn or self._film
        if film is not None:
            self._end(film)
        if self._saving is not None:
            self._saving.wait()
            if self._saving.saved is not None:
                tell(self._saving.saved[0])

    def _take(self, name: str) -> None:
        self._asked = ""
        path = beside(self._editor.document.path, f"{name}.png")
        save_picture(self._picture() if name == "picture" else self._compared(), path)
        self._editor.say(f"Saved {path}")

    def _compared(self) -> Picture:
        """The rest shape and the surface, seen by one camera."""
        editor, halves = self._editor, []
        for rest in (True, False):
            self._view.show(replace(editor.scene(rest), twin=None))
            halves.append(self._picture())
        return np.hstack(halves)

    def _take_turn(self, film: Film) -> None:
        number = film.count
        film.add(self._picture(), number * TURN_SECONDS / TURN_FRAMES)
        resized = film.count == number  # the window is: the turn ends where it is
        if resized or film.count == TURN_FRAMES:
            self._end(film)

    def _record(self, film: Film) -> None:
        start = time.perf_counter()
        if start < self._next:
            return
        film.add(self._picture(), start)
        took = time.perf_counter() - start
        self._next = start + max(PAUSE, took / SHARE)
        if film.full:
            self._end(film)

    def _end(self, film: Film) -> None:
        """Saving it goes on meanwhile."""
        film.end()
        self._turn, self._film, self._saving = None, None, film
        self._editor.say(f"Saving {film.seconds:.0f} s ...")

    def _tell(self) -> None:
        if self._saving is not None and self._saving.saved is not None:
            text, well = self._saving.saved
            self._saving = None
            self._editor.say(text, "info" if well else "error")

    def _picture(self) -> Picture:
        """The scene beside the panel."""
        pixels = self._view.pixels()
        viewpoint = self._editor.viewpoint
        covered = viewpoint.inset / viewpoint.camera.size[0]
        return pixels[:, round(covered * pixels.shape[1]) :]
