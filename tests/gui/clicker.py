"""Somebody who does anything at all with mouse and keys, by a seed; never closes the window.

`python -m tests.gui.clicker [EVENTS] [SEED]`: longer than the test, in a window of its own.
"""

from __future__ import annotations

import sys
import tempfile
import time
from pathlib import Path
from random import Random

from solver import load_mesh
from tests.app.person import slab

from .display import VirtualDisplay
from .person import Person, wait_until

PAUSE = 0.012  # seconds between two events: about a frame
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


def clicked(person: Person, folder: Path, events: int, seed: int) -> Clicker:
    """After so many events the window still answers, and saves what can be opened.

    folder: of a mesh plate.obj, which is open, and out.obj, where exports go.
    """
    before = (folder / "plate.obj").read_bytes()
    clicker = Clicker(person, Random(seed))
    clicker.go(events)
    session = folder / "after.json"
    _save_as(person, session)
    assert (folder / "plate.obj").read_bytes() == before
    assert load_mesh(folder / "plate.obj").vertices.shape
    assert "Traceback" not in person.output()
    return clicker
