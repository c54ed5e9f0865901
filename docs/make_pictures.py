"""Makes the pictures of README.md: `python -m docs.make_pictures` (Linux, with Xvfb and xdotool).

The close-ups are rendered without a window; the walkthrough is a real window and a real mouse.
"""

from __future__ import annotations

import tempfile
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from app.bundled import DEFAULT_MESH
from app.demo import (
    BODY,
    BODY_RADIUS,
    DRAG,
    ELBOW,
    ELBOW_RADIUS,
    HAND,
    HAND_RADIUS,
    PICTURE_SIZE,
    Performer,
    Point,
    paint_elbow,
    paint_regions,
    painter,
)
from app.editor.commands import SetMap
from app.editor.editor import Editor
from app.model.document import Document
from app.viewpoint.camera import FIELD_OF_VIEW, Camera
from app.viewpoint.framing import framing
from app.window.panel import WIDTH
from app.worker.client import ProcessWorker
from solver import load_mesh
from tests.gui.display import VirtualDisplay
from tests.gui.person import Person

IMAGES = Path(__file__).resolve().parent / "images"
CLOSE_SIZE = (640, 560)
RADIUS_STEP = 1.15  # what one press of a bracket key does to the brush
FIRST_RADIUS = 0.03


def close_ups() -> None:
    """The arm as painted, as soft, as folded."""
    editor = Editor(Document(load_mesh(DEFAULT_MESH), DEFAULT_MESH), ProcessWorker())
    performer = Performer(editor, framing(editor.positions, PICTURE_SIZE))
    near = Camera.look_at((0.4, 1.52, 1.3), (0.4, 1.52, 0.0), FIELD_OF_VIEW, CLOSE_SIZE)
    draw = painter(editor, near, CLOSE_SIZE)
    paint_regions(performer)
    draw(IMAGES / "painted.png", "painted")
    paint_elbow(performer)
    draw(IMAGES / "soft.png", "soft")
    performer.take("drag")
    performer.stroke(DRAG)
    draw(IMAGES / "folded.png", "folded")
    editor.execute(SetMap("softness"))
    draw(IMAGES / "folded-soft.png", "folded, softness")
    editor.close()


def walkthrough() -> None:
    """The window after each step of the walkthrough."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        display = VirtualDisplay(folder, pointer=True)
        try:
            _walk(Person(display, [str(DEFAULT_MESH)], folder))
        finally:
            display.stop()


def _walk(person: Person) -> None:
    camera = framing(load_mesh(DEFAULT_MESH).vertices, person.size(), WIDTH)

    def paint(tool: str, radius: float, paths: Sequence[Sequence[Point]]) -> None:
        person.key(tool)
        nonlocal brush
        steps = round(np.log(radius / brush) / np.log(RADIUS_STEP))
        for _ in range(abs(steps)):
            person.key("bracketright" if steps > 0 else "bracketleft")
        brush *= RADIUS_STEP**steps
        for path in paths:
            person.drag([tuple(pixel) for pixel in camera.project(np.array(path))])

    brush = FIRST_RADIUS
    for number, (tool, radius, paths) in enumerate(
        (("2", BODY_RADIUS, BODY), ("3", HAND_RADIUS, [HAND]), ("4", ELBOW_RADIUS, [ELBOW])), 1
    ):
        paint(tool, radius, paths)
        person.wait_still()
        person.screenshot(IMAGES / f"step-{number}.png")
    paint("5", brush, [DRAG])
    person.wait_still(1.0)
    person.screenshot(IMAGES / "step-4.png")
    person.leave()


if __name__ == "__main__":
    walkthrough()
    close_ups()
