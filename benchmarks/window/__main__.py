"""Whether the window freezes while the solver works: `python -m benchmarks.window`.

Opens the real window on a virtual screen (needs Xvfb and xdotool) and works in it with a mouse.
"""

from __future__ import annotations

import json
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

import igl
import numpy as np

from app.model.document import Document
from app.model.session.writing import write_session
from app.viewpoint.framing import framing
from benchmarks.tables import table
from solver import load_mesh
from solver.types import BoolArray, FloatArray
from tests.gui.display import VirtualDisplay
from tests.gui.person import Person

ASSETS = Path(__file__).resolve().parents[2] / "assets"
VERTICES = 25_000
STROKES = 6
GOAL_START, GOAL_RATIO = 3.0, 2.0
# World coordinates on the mannequin: a stroke that fixes a little of the belly, and the hand.
BELLY = ((-0.05, 1.15, 0.1), (0.05, 1.15, 0.1))
HAND = ((0.85, 1.425, 0.02), (0.7, 1.7, 0.02))
BESIDE = ((1100.0, 700.0), (1160.0, 690.0))  # pixels where nothing but background is


@dataclass(frozen=True)
class Frames:
    """Frames of one run. begin: when each began, seconds. length: from each to the next."""

    begin: FloatArray
    length: FloatArray
    binding: BoolArray
    dragging: BoolArray

    @staticmethod
    def read(log: Path) -> Frames:
        begin, _, binding, dragging = np.array(
            [json.loads(line) for line in log.read_text(encoding="utf-8").splitlines()],
            dtype=np.float64,
        ).T
        return Frames(begin[:-1], np.diff(begin), binding[:-1] > 0, dragging[:-1] > 0)

    def during(self, start: float, end: float) -> Frames:
        return self.where((self.begin >= start) & (self.begin < end))

    def where(self, mask: BoolArray) -> Frames:
        return Frames(*(values[mask] for values in vars(self).values()))

    def row(self, name: str, base: Frames) -> list[str]:
        """Count, median, longest, and the longest in medians of `base`."""
        if len(self.length) == 0:
            return [name, "0", "-", "-", "-"]
        middle, longest = np.median(self.length), self.length.max()
        ratio = longest / np.median(base.length)
        return [
            name,
            str(len(self.length)),
            f"{1e3 * middle:.1f}",
            f"{1e3 * longest:.1f}",
            f"{ratio:.2f}",
        ]


def large_session(folder: Path) -> Path:
    """The mannequin with about VERTICES vertices: one half fixed, a hand to drag."""
    mesh = load_mesh(ASSETS / "mannequin.obj")
    coarse = igl.qslim(np.array(mesh.vertices), np.array(mesh.faces), VERTICES // 2)
    V, F = igl.loop(coarse[0], coarse[1])
    path = folder / "large.obj"
    igl.writeOBJ(str(path), V, F)
    document = Document(load_mesh(path), path)
    document.change("handles", (document.new_handle("hand"),))
    x = document.mesh.vertices[:, 0]
    document.change("role", 1, np.flatnonzero(x < -0.12))
    document.change("role", 2, np.flatnonzero(x > 0.8))
    write_session(folder / "large.json", document)
    return folder / "large.json"


class Sitting:
    """One window, watched."""

    def __init__(self, display: VirtualDisplay, folder: Path, session: Path) -> None:
        self.log = folder / "ticks.txt"
        self.started = time.time()
        command = sys.executable, "-P", "-m", "benchmarks.window.ticks"
        self.person = Person(display, [str(self.log), str(session)], folder, command)

    def finish(self) -> Frames:
        assert self.person.quit() == 0, self.person.output()
        return Frames.read(self.log)


def first_frame(display: VirtualDisplay, folder: Path) -> float:
    """Seconds from the start of the program to the end of the default session's first frame."""
    sitting = Sitting(display, folder, ASSETS / "mannequin-elbow.json")
    sitting.finish()
    begin, seconds, *_ = json.loads(sitting.log.read_text(encoding="utf-8").splitlines()[0])
    return float(begin + seconds - sitting.started)


def measure(display: VirtualDisplay, folder: Path) -> tuple[int, list[list[str]]]:
    """Vertices, and a row for everything that is done in the window."""
    session = large_session(folder)
    V = load_mesh(folder / "large.obj").vertices
    sitting = Sitting(display, folder, session)
    person, spans = sitting.person, {}
    camera = framing(V, person.size(), _panel_width())

    def pixels(points: object) -> list[tuple[float, float]]:
        return [(float(x), float(y)) for x, y in camera.project(np.array(points))]

    def span(name: str, start: float) -> None:
        spans[name] = (start, time.time())

    person.wait_still()
    person.move(*BESIDE[0])
    start = time.time()
    time.sleep(2)
    span("idle", start)
    start = time.time()
    person.drag([*BESIDE, BESIDE[0]], steps=20)
    span("orbiting", start)
    person.key("2")
    start = time.time()
    for _ in range(STROKES):
        person.drag(pixels(BELLY))
        person.move(*BESIDE[0])
        time.sleep(1.5)
    span("strokes", start)
    start = time.time()
    for _ in range(STROKES):
        person.drag(pixels(BELLY), hold=("shift",))
        person.drag([*BESIDE, BESIDE[0]], steps=20)
        time.sleep(0.5)
    span("strokes, then orbiting", start)
    person.key("5")
    start = time.time()
    person.drag(pixels(HAND), steps=40)
    span("drag", start)
    person.wait_still()
    frames = sitting.finish()
    part = {name: frames.during(*between) for name, between in spans.items()}
    idle, orbit = part["idle"], part["orbiting"]
    one, two = part["strokes"], part["strokes, then orbiting"]
    return len(V), [
        idle.row("idle", idle),
        one.where(one.binding).row("at rest while a bind runs", idle),
        orbit.row("orbiting", orbit),
        two.where(two.binding).row("orbiting while a bind runs", orbit),
        part["drag"].where(part["drag"].dragging).row("dragging", orbit),
    ]


def _panel_width() -> float:
    from app.window.panel import WIDTH  # loads the graphics library

    return WIDTH


def main() -> None:
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        display = VirtualDisplay(folder)
        try:
            starts = [first_frame(display, folder) for _ in range(3)]
            count, rows = measure(display, folder)
        finally:
            display.stop()
    print(f"\n{count:,} vertices, software rendering; the goal is a longest frame of at most")
    print(f"{GOAL_RATIO:.0f} medians without a bind\n")
    print(table(["what happens", "frames", "median, ms", "longest, ms", "longest / median"], rows))
    print(
        f"\nStart to first frame, default session: {starts[0]:.2f} s, then "
        f"{min(starts[1:]):.2f} s; the goal is {GOAL_START:.0f} s."
    )


if __name__ == "__main__":
    main()
