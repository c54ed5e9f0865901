"""Somebody before the window, and the pictures taken of it."""

from __future__ import annotations

import json
import shutil
import tempfile
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from PIL import Image

from app.demo import Point
from app.editor.files.actions import load_document
from app.pointing.brush import RADIUS_STEP
from app.viewpoint.camera import Pixel
from app.viewpoint.framing import framing
from tests.gui.display import VirtualDisplay
from tests.gui.person import Person, wait_until

IMAGES = Path(__file__).resolve().parents[1] / "images"
FIRST_RADIUS = 0.03  # of the brush
FOLDER = Path(tempfile.gettempdir()) / "figures"  # always of one name: it is seen in pictures
COLOURS, NO_DITHER = 256, Image.Dither.NONE
LEFT_OF_POINTER = 5  # pixels
PATIENCE = 120  # seconds
MARGIN = 30  # pixels around what is shown
Box = tuple[int, int, int, int]  # pixels: left, top, right, bottom
CORNER = (1270, 790)  # where the mouse is in nobody's way


class Seat:
    """A person at the window, who knows where points of the world are in it."""

    def __init__(self, person: Person, file: Path) -> None:
        from app.window.panel import WIDTH  # needs the graphics library

        self.person = person
        document = load_document(*((None, file) if file.suffix == ".json" else (file, None)))
        self._camera = framing(document.mesh.vertices, person.size(), WIDTH)
        self._radius = FIRST_RADIUS

    def pixels(self, path: Sequence[Point]) -> list[Pixel]:
        """Where points of the world are, seen as the window first shows them."""
        return [(x, y) for x, y in self._camera.project(np.array(path, dtype=float))]

    def stroke(self, *path: Point, steps: int = 8) -> None:
        """Press over the first point, move over the others, release; wait for what follows."""
        self.person.drag(self.pixels(path), steps=steps)
        self.settle()

    def brush(self, radius: float) -> None:
        """Press the brackets until the brush has about this radius."""
        steps = round(np.log(radius / self._radius) / np.log(RADIUS_STEP))
        for _ in range(abs(steps)):
            self.person.key("bracketright" if steps > 0 else "bracketleft")
        self._radius *= RADIUS_STEP**steps

    def value(self, label: str, number: float) -> None:
        """Type a number into a slider."""
        self.person.drag([self.person.widget(label)], hold=["ctrl"])
        self.person.key("ctrl+a")
        self.person.type(f"{number:g}")
        self.person.key("Return")

    def settle(self, still: float = 1.0) -> None:
        """Wait for the solver, and until nothing moves any more."""
        self.person.wait_still(still)

    def follows(self, place: Point) -> None:
        """Wait until the surface has come to where the mouse has led it."""
        ((x, y),) = np.rint(self.pixels([place])).astype(int)

        def there() -> bool:
            picture = self.person.picture()
            left = picture[y, x - LEFT_OF_POINTER].astype(int)
            return bool(np.abs(left - picture[-1, -1]).max() > 30)

        wait_until(there, PATIENCE, "the surface at the mouse")
        self.settle()

    def around(self, *places: Point) -> Box:
        """The box of pixels that has these points of the world in it, and a margin."""
        low, high = np.min(self.pixels(places), axis=0), np.max(self.pixels(places), axis=0)
        left, top = np.maximum(low - MARGIN, 0).astype(int)
        right, bottom = (high + MARGIN).astype(int)
        return int(left), int(top), int(right), int(bottom)

    def aside(self) -> None:
        """Take the mouse out of the way."""
        self.person.move(*CORNER)
        self.settle()

    def shot(self, name: str, box: Box | None = None) -> None:
        """Save what the window shows, or a box of it, as a small PNG."""
        image = Image.fromarray(np.ascontiguousarray(self.person.picture())).crop(box)
        # Rare colours, of handles and marks in the panel, count as much as large areas.
        colours = image.quantize(COLOURS, Image.Quantize.MAXCOVERAGE, kmeans=3, dither=NO_DITHER)
        colours.save(IMAGES / name, optimize=True)


@dataclass(frozen=True)
class Scene:
    """pictures: the files it makes.  steps: what is done before the window.

    prepare: puts into a folder what the window opens, and returns that file.
    dialogs: whether the system's are used; else the panel has fields to type paths into.
    """

    pictures: tuple[str, ...]
    prepare: Callable[[Path], Path]
    steps: Callable[[Seat], None]
    dialogs: bool = True

    def make(self) -> None:
        """Act the scene, and save its pictures. Raises FileExistsError while another is acted."""
        FOLDER.mkdir()
        try:
            (FOLDER / "preferences").write_text(json.dumps({"dialogs": self.dialogs}))
            with seated(self.prepare(FOLDER)) as seat:
                self.steps(seat)
        finally:
            shutil.rmtree(FOLDER)


def copies(opened: Path, *others: Path) -> Callable[[Path], Path]:
    """What puts copies of files into a folder."""

    def prepare(folder: Path) -> Path:
        for file in others:
            shutil.copy(file, folder)
        return Path(shutil.copy(opened, folder))

    return prepare


@contextmanager
def seated(file: Path) -> Iterator[Seat]:
    """Somebody before a window of their own on a mesh or a session, in the folder of the file."""
    display = VirtualDisplay(file.parent, pointer=True)
    try:
        person = Person(display, [file.name], file.parent)
        try:
            yield Seat(person, file)
        finally:
            person.leave()
    finally:
        display.stop()
