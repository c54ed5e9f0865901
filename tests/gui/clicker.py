"""Somebody who does anything at all with mouse and keys, by a seed; never closes the window.

`python -m tests.gui.clicker [EVENTS] [SEED]`: longer than the test, in a window of its own.
"""

from __future__ import annotations

import sys
import tempfile
import time
from pathlib import Path
from random import Random

from app.model.document import Document
from app.model.session.reading import read_session, to_document
from solver import load_mesh
from tests.app.person import slab

from .display import VirtualDisplay
from .person import Person, wait_until

PAUSE = 0.012  # seconds between two events: about a frame
ANSWER = 0.7  # seconds within which a small session is saved
BATCH = 40  # events that xdotool is given at once
KEYS = (
    *("1", "2", "3", "4", "5", "g", "r", "f", "k", "x", "y", "z", "Home", "F1", "Escape", "grave"),
    *("bracketleft", "bracketright", "Return", "Tab", "BackSpace", "Delete", "minus", "period"),
    *("ctrl+z", "ctrl+shift+z", "ctrl+y", "ctrl+r", "ctrl+i", "ctrl+s", "ctrl+e", "ctrl+o"),
    *("ctrl+KP_Add", "ctrl+KP_Subtract", "KP_1", "KP_3", "KP_7", "ctrl+KP_1", "Up", "Down"),
)
HELD = ("", "", "", "shift", "ctrl", "alt")


class Clicker:
    """Deeds are lists of xdotool's words; `done` counts the events."""

    def __init__(self, person: Person, random: Random) -> None:
        self.person, self.random, self.done = person, random, 0
        self.size = person.size()

    def go(self, events: int) -> None:
        """So many events at least. AssertionError where the program ends meanwhile."""
        while self.done < events:
            words, batch = list[object](), self.done + BATCH
            while self.done < batch:
                words += self.random.choices((self._click, self._drag, self._key), (4, 3, 5))[0]()
            self.person.send(*words)
            assert self.person.process.poll() is None, self.person.output()

    def _event(self, *words: object) -> list[object]:
        self.done += 1
        return [*words, "sleep", PAUSE]

    def _to(self) -> list[object]:
        """Somewhere, half of the time in the panel."""
        width, height = self.size
        x = self.random.randrange(width if self.random.random() < 0.5 else width // 4)
        return self._event("mousemove", x, self.random.randrange(height))

    def _click(self) -> list[object]:
        """With any button or the wheel."""
        button = self.random.choice((1, 1, 1, 1, 2, 3, 4, 5))
        return [*self._to(), *self._event("mousedown", button), *self._event("mouseup", button)]

    def _drag(self) -> list[object]:
        key, button = self.random.choice(HELD), self.random.choice((1, 1, 1, 2, 3))
        words = [*self._to(), *(self._event("keydown", key) if key else [])]
        words += self._event("mousedown", button)
        for _ in range(self.random.randint(1, 6)):
            words += self._to()
        if self.random.random() < 0.2:  # whatever a key does while a button is down
            words += self._key()
        words += self._event("mouseup", button)
        return [*words, *(self._event("keyup", key) if key else [])]

    def _key(self) -> list[object]:
        keys = self.random.choice(KEYS).split("+")
        down = [word for key in keys for word in self._event("keydown", key)]
        return down + [word for key in reversed(keys) for word in self._event("keyup", key)]


def survives(person: Person, mesh: Path, events: int, seed: int) -> Document:
    """What the window saves after so many events, read again; the open mesh has its old bytes.

    AssertionError where the window no longer answers, or has printed a traceback.
    """
    before = mesh.read_bytes()
    clicker = Clicker(person, Random(f"clicks {seed}"))
    clicker.go(events)
    document = _saved(person, mesh.parent)
    assert mesh.read_bytes() == before, "the open mesh was replaced"
    assert "Traceback" not in person.output(), person.output()
    return document


def _saved(person: Person, folder: Path) -> Document:
    """Save as somebody would who finds the window in any state: out of what is open, then Ctrl+S.

    What is asked then is whether files are replaced: Enter agrees.
    """
    for path in folder.glob("*.json"):
        path.unlink()

    def saved() -> bool:
        for key in ("Escape", "Escape", "Escape", "ctrl+s"):
            person.key(key)
        time.sleep(ANSWER)
        if not (files := list(folder.glob("*.json"))):
            person.key("Return")
            time.sleep(ANSWER)
            files = list(folder.glob("*.json"))
        return bool(files)

    wait_until(saved, 60, "a session that is saved")
    session = read_session(next(folder.glob("*.json")))
    return to_document(session, load_mesh(session.mesh_path), session.mesh_path)


def main(events: int = 20_000, seed: int = 0) -> None:
    """In a window of its own, and a line of what was done."""
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place)
        (folder / "screen").mkdir()
        mesh, display = plate(folder), VirtualDisplay(folder / "screen")
        person = Person(display, [mesh.name, "--export", "out.obj"], folder)
        try:
            document = survives(person, mesh, events, seed)
        finally:
            person.leave()
            display.stop()
    kept = f"{len(document.handles)} handles, {len(document.poses)} kept poses"
    print(f"{events} events of seed {seed}: the window answers, and saved {kept}")


def plate(folder: Path) -> Path:
    """A small mesh in a folder."""
    mesh = slab(20, 8, 0.2)
    mesh.save(folder / "plate.obj", mesh.vertices)
    return folder / "plate.obj"


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
