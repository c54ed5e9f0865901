"""A mesh in the window: where its points are on screen, and the files that a person saves of it."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from app.viewpoint.framing import framing
from solver import load_mesh

from .display import Picture
from .person import Person, Point, wait_until

World = tuple[float, float, float]
Mask = NDArray[np.bool_]

PARKED = (1250, 500)  # beside every mesh, where the mouse is in nobody's way
SAME = 5e-4  # the share of pixels that lines on the surface may change at its rim
MESSAGE_ROWS = 100  # at the bottom, where messages come and go
RED = (255, 115, 102)  # of the text of errors


class Scene:
    """The window on `mesh`, seen as it was first framed; paths are points of the world.

    session, export: where Ctrl+S and Ctrl+E save.
    """

    def __init__(self, person: Person, mesh: Path, session: Path, export: Path) -> None:
        from app.window.panel import (
            WIDTH,  # needs the graphics library: only where there is a window
        )

        self.person = person
        self.session = session
        self.export = export
        self.panel = round(WIDTH)
        self.source = mesh.read_bytes()
        self.rest = load_mesh(mesh).vertices
        self.camera = framing(self.rest, person.size(), WIDTH)

    def pixels(self, path: Sequence[World]) -> list[Point]:
        return [(x, y) for x, y in self.camera.project(np.array(path, dtype=float))]

    def stroke(self, *path: World, hold: Sequence[str] = (), steps: int = 5) -> None:
        """Press over the first point, move over the others, release."""
        self.person.drag(self.pixels(path), hold=hold, steps=steps)

    def resize_brush(self, steps: int) -> None:
        """Press `]` so many times, or `[` for a negative number."""
        for _ in range(abs(steps)):
            self.person.key("bracketright" if steps > 0 else "bracketleft")

    # What is saved. A file that is there tells that all earlier input has been dealt with.

    def save_session(self) -> dict[str, Any]:
        """Press Ctrl+S; the session."""
        return dict(json.loads(self._saved(self.session, "ctrl+s")))

    def transform(self) -> NDArray[np.float64]:
        """Of the only handle, (4, 4), as Ctrl+S saves it."""
        (handle,) = self.save_session()["handles"]
        return np.array(handle["transform"])

    def save_mesh(self) -> bytes:
        """Press Ctrl+E; the mesh, which waits for the bind that is running."""
        return self._saved(self.export, "ctrl+e")

    def _saved(self, path: Path, chord: str) -> bytes:
        path.unlink(missing_ok=True)
        self.person.key(chord)
        wait_until(path.exists, what=f"{path.name} after {chord}")
        return path.read_bytes()

    # What is seen

    def silhouette(self) -> Mask:
        """Where the surface is on screen now, the panel and the messages left out."""
        self.person.move(*PARKED)
        self.person.wait_still()
        seen = self.view()[:-MESSAGE_ROWS]
        return (np.abs(seen.astype(int) - seen[0, -1]) > 12).any(axis=2)

    def looks_as(self, before: Mask) -> bool:
        """Whether the surface is where a silhouette had it, but for lines along its rim."""
        return float((self.silhouette() != before).mean()) < SAME

    def view(self) -> Picture:
        """The window without the panel."""
        return self.person.picture()[:, self.panel :]

    def error_shown(self) -> Mask:
        """Which pixels of the window are text of an error message."""
        away = np.abs(self.person.picture().astype(int) - RED)
        return np.asarray((away < 12).all(axis=2))


def positions(obj: bytes) -> NDArray[np.float64]:
    """The vertices of an OBJ file."""
    return np.array([line.split()[1:4] for line in vertex_lines(obj)], dtype=float)


def vertex_lines(obj: bytes) -> list[bytes]:
    return [line for line in obj.splitlines(keepends=True) if line.startswith(b"v ")]


def kinds_of_change(source: bytes, saved: bytes) -> set[bytes]:
    """The first words of the lines that differ, line by line."""
    pairs = list(zip(source.split(b"\n"), saved.split(b"\n"), strict=True))
    changed = [(a.split()[:1], b.split()[:1]) for a, b in pairs if a != b]
    assert all(a == b for a, b in changed)
    return {a[0] for a, _ in changed}
