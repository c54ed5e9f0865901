"""A scripted person: paints, folds and saves the default mesh through the code the mouse uses."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import closing
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np

from app.bundled import DEFAULT_MESH
from app.editor import commands as c
from app.editor.editor import Editor
from app.graphics import GraphicsError, loading
from app.model.document import Document
from app.telling import tell
from app.viewpoint.camera import Camera
from app.viewpoint.events import Input
from app.viewpoint.framing import framing
from app.worker.client import ProcessWorker
from solver import load_mesh
from solver.errors import SolverError

PICTURE_SIZE = (1280, 800)
FILES = "demo.obj", "demo.json", "before.png", "softness.png", "after.png"
Point = tuple[float, float, float]

# Where the brush goes on the mannequin, in world coordinates.
BODY: Sequence[Sequence[Point]] = (
    [(0, 1.7, 0.1), (0, 1.5, 0.1), (0, 1.0, 0.1)],
    [(-0.1, 0.9, 0.1), (-0.11, 0.5, 0.05), (-0.11, 0.03, 0.05)],
    [(0.1, 0.9, 0.1), (0.11, 0.5, 0.05), (0.11, 0.03, 0.05)],
    [(-0.1, 1.42, 0.1), (-0.5, 1.425, 0.04), (-0.94, 1.425, 0.0)],
)
BODY_RADIUS, HAND_RADIUS, ELBOW_RADIUS = 0.075, 0.05, 0.08
HAND: Sequence[Point] = ((0.83, 1.425, 0.02), (0.95, 1.425, 0.02))
ELBOW: Sequence[Point] = ((0.465, 1.425, 0.03),)
GRAB: Point = (0.85, 1.425, 0.02)
DRAG: Sequence[Point] = (
    GRAB,
    (0.83, 1.6, 0.0),
    (0.70, 1.75, 0.0),
    (0.50, 1.78, 0.0),
    (0.36, 1.7, 0),
)
STEPS = 10  # frames between two points of a path


class Performer:
    """Moves a cursor over the editor as a person would over the window."""

    def __init__(self, editor: Editor, camera: Camera) -> None:
        self._editor = editor
        self._camera = camera

    def take(self, tool: str, **brush: Any) -> None:
        """Take a tool and set the brush."""
        self._editor.execute(c.SetTool(tool))
        self._editor.execute(c.SetBrush(**brush))

    def stroke(self, path: Sequence[Point]) -> None:
        """Press over the first point, move over the others, release; then wait for the bind."""
        pixels = self._camera.project(np.array(path))
        cursor = [pixels[0]]
        for start, end in pairwise(pixels):
            cursor += [start + (end - start) * step / STEPS for step in range(1, STEPS + 1)]
        for number, (x, y) in enumerate(cursor):
            self._frame(x, y, pressed=number == 0, down=True)
        x, y = cursor[-1]
        self._frame(x, y, released=True)
        self._editor.settle()

    def _frame(
        self, x: float, y: float, pressed: bool = False, down: bool = False, released: bool = False
    ) -> None:
        self._editor.step(Input((x, y), self._camera, pressed, down, released))


def demo(folder: Path) -> None:
    """Save FILES: what was done, and pictures of it. Raises SolverError.

    Where no graphics library can be used, the pictures are left out and it says so.
    """
    editor = Editor(Document(load_mesh(DEFAULT_MESH), DEFAULT_MESH), ProcessWorker())
    with closing(editor):
        _perform(editor, folder)
    if editor.message is not None and editor.message.kind == "error":
        raise SolverError(editor.message.text)
    tell(f"{folder / 'demo.obj'}, {folder / 'demo.json'}: saved")


def _perform(editor: Editor, folder: Path) -> None:
    camera = framing(editor.positions, PICTURE_SIZE)
    try:
        draw = painter(editor, camera)
    except GraphicsError as error:
        tell(f"no pictures: {error}", error=True)
        draw = _no_picture
    performer = Performer(editor, camera)
    paint_regions(performer)
    draw(folder / "before.png", "painted: the body fixed, the hand a handle")
    paint_elbow(performer)
    draw(folder / "softness.png", "painted: the elbow soft")
    editor.execute(c.SetMap("roles"))
    performer.take("drag")
    performer.stroke(DRAG)
    draw(folder / "after.png", "dragged: the hand up and in")
    editor.execute(c.Export(folder / "demo.obj", replace=True))
    editor.complete()
    editor.execute(c.SaveSession(folder / "demo.json", replace=True))


def _no_picture(path: Path, caption: str) -> None:
    """What stands in for a painter where nothing can be drawn."""


def paint_regions(performer: Performer) -> None:
    """Body fixed, one hand a handle."""
    performer.take("fixed", radius=BODY_RADIUS)
    for path in BODY:
        performer.stroke(path)
    performer.take("handle", radius=HAND_RADIUS)
    performer.stroke(HAND)


def paint_elbow(performer: Performer) -> None:
    """The elbow of that hand soft."""
    performer.take("softness", radius=ELBOW_RADIUS)
    performer.stroke(ELBOW)


def painter(
    editor: Editor, camera: Camera, size: tuple[int, int] = PICTURE_SIZE
) -> Callable[[Path, str], None]:
    """What takes a picture of the editor. Raises GraphicsError."""
    with loading():
        from app.window.drawing.view import View
        from app.window.opening import open_offscreen
    open_offscreen(size)
    view = View()

    def draw(path: Path, caption: str) -> None:
        view.show(editor.scene())
        view.look(camera)
        view.picture(path)
        tell(f"{path}: {caption}")

    return draw
