"""Makes the pictures of README.md: `python -m docs.make_pictures` (Linux, with Xvfb and xdotool).

The close-ups are rendered without a window; the walkthrough is a real window and a real mouse.
"""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

import igl
import numpy as np

from app.bundled import ASSETS, DEFAULT_MESH
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
from app.editor.file_actions import load_document
from app.model.document import Document
from app.viewpoint.camera import FIELD_OF_VIEW, Camera, Pixel
from app.viewpoint.framing import framing
from app.window.panel import WIDTH
from app.worker.client import ProcessWorker
from solver import Mesh, load_mesh
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


# Clicked in turn; then some of them are dragged, with nothing painted.
PINS: Sequence[Point] = (
    (0.0, 1.25, 0.13),
    (0.85, 1.425, 0.02),
    (-0.85, 1.425, 0.02),
    (0.13, 0.05, 0.12),
    (-0.13, 0.05, 0.12),
)
PIN_DRAGS: Sequence[Sequence[Point]] = (
    [PINS[1], (0.62, 1.78, 0.02)],
    [PINS[2], (-0.58, 1.08, 0.02)],
    [PINS[3], (0.42, 0.32, 0.12)],
)


def with_pins() -> None:
    """The window after some clicks and drags, with nothing painted."""
    with window(DEFAULT_MESH) as (person, pixels):
        person.key("5")
        for place in PINS:
            person.drag(pixels([place]))
            person.wait_still()
        for path in PIN_DRAGS:
            person.drag(pixels(path), steps=20)
            person.wait_still(1.0)
        person.screenshot(IMAGES / "window-pins.png")


def dressed() -> None:
    """The window with a character of many pieces, its hand dragged."""
    with window(ASSETS / "dressed-elbow.json") as (person, pixels):
        person.key("5")
        person.wait_still(3.0)
        person.drag(pixels(DRAG), steps=20)
        person.wait_still(2.0)
        person.screenshot(IMAGES / "window-dressed.png")


def large() -> None:
    """The window with the mannequin in more than half a million vertices."""
    with tempfile.TemporaryDirectory() as name:
        mesh = load_mesh(DEFAULT_MESH)
        V, F = np.array(mesh.vertices), np.array(mesh.faces)
        for _ in range(3):
            V, F = igl.loop(V, F)
        path = Path(name) / "large.obj"
        Mesh.from_arrays(V, F).save(path, V)
        with window(path) as (person, pixels):
            person.key("5")
            for place in PINS[:2]:
                person.drag(pixels([place]))
                person.wait_still(4.0)
            person.drag(pixels(PIN_DRAGS[0]), steps=20)
            person.wait_still(4.0)
            person.screenshot(IMAGES / "window-large.png")


@contextmanager
def window(file: Path) -> Iterator[tuple[Person, Callable[[Sequence[Point]], list[Pixel]]]]:
    """Somebody before a window on a mesh or a session, and where points are in it."""
    document = load_document(*((None, file) if file.suffix == ".json" else (file, None)))
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        display = VirtualDisplay(folder, pointer=True)
        try:
            person = Person(display, [str(file)], folder)
            camera = framing(document.mesh.vertices, person.size(), WIDTH)
            yield person, lambda path: [(x, y) for x, y in camera.project(np.array(path))]
            person.leave()
        finally:
            display.stop()


if __name__ == "__main__":
    walkthrough()
    with_pins()
    dressed()
    large()
    close_ups()
