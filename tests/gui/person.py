"""Somebody at the screen: starts the program, uses mouse and keys, looks at the window."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import time
from collections.abc import Callable, Sequence
from contextlib import suppress
from itertools import pairwise
from pathlib import Path

import numpy as np

from .closing import request_close
from .display import Picture, VirtualDisplay, save_png

ROOT = Path(__file__).resolve().parents[2]
START_SECONDS = 60
PAUSE = 0.04  # longer than a frame at 9k vertices in software rendering

Point = tuple[float, float]


def wait_until(
    condition: Callable[[], bool], seconds: float = 30, what: str = "the condition"
) -> None:
    """Poll until `condition()` holds; AssertionError that names `what` when it never does."""
    deadline = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < deadline, f"waited {seconds} s for {what}"
        time.sleep(0.05)


class Person:
    """The program in a window of its own; all positions are pixels from the window's top left."""

    def __init__(
        self,
        display: VirtualDisplay,
        arguments: Sequence[str],
        folder: Path,
        command: Sequence[str] = (),
    ) -> None:
        """command: what starts the program; by default it, with a note of its widgets."""
        self._display = display
        self._widgets = folder / "widgets"
        self._widgets.unlink(missing_ok=True)
        watched = (sys.executable, "-P", "-m", "tests.gui.watched", str(self._widgets))
        self._log = folder / "output.txt"
        preferences = folder / "preferences"  # of nobody: no test knows of another
        if not preferences.exists():
            preferences.write_text(json.dumps({"dialogs": False}))
        self._environment = os.environ | {
            "DISPLAY": display.name,
            "SURFACE_DEFORMATION_PREFERENCES": str(preferences),
            "SURFACE_DEFORMATION_STATE": str(folder / "state"),
            "LIBGL_ALWAYS_SOFTWARE": "1",
            "PYTHONPATH": str(ROOT),
            "XDG_SESSION_TYPE": "x11",
        }
        self._environment.pop("WAYLAND_DISPLAY", None)
        with self._log.open("wb") as log:
            self.process = subprocess.Popen(
                [*(command or watched), *arguments],
                cwd=folder,
                env=self._environment,
                stdin=subprocess.DEVNULL,
                stdout=log,
                stderr=log,
            )
        self._window = 0
        try:
            self._find_window()
        except BaseException:
            self.leave()
            raise

    def _find_window(self) -> None:
        wait_until(self._window_is_open, START_SECONDS, "the window")
        # Without a window manager nobody else gives the window the keyboard.
        self._xdotool("windowmove", self._window, 0, 0, "windowfocus", "--sync", self._window)
        wait_until(lambda: bool(np.ptp(self.picture()) > 0), START_SECONDS, "the first frame")
        self.wait_still()

    def _window_is_open(self) -> bool:
        assert self.process.poll() is None, f"the program ended: {self.output()}"
        search = ["search", "--onlyvisible", "--pid", self.process.pid]
        found = self._xdotool(*search, check=False).split()
        self._window = int(found[-1]) if found else 0
        return bool(found)

    def _xdotool(self, *words: object, check: bool = True) -> str:
        command = ["xdotool", *map(str, words)]
        done = subprocess.run(
            command, env=self._environment, check=False, capture_output=True, text=True
        )
        assert not check or done.returncode == 0, f"{command}: {done.stderr}"
        return done.stdout

    def send(self, *words: object) -> None:
        """Any events, in xdotool's words; positions are of the screen, as the window's are."""
        self._xdotool(*words)

    # The mouse

    def _to(self, point: Point) -> list[object]:
        x, y = np.rint(point).astype(int)
        return ["mousemove", "--window", self._window, x, y, "sleep", PAUSE]

    def move(self, x: float, y: float) -> None:
        self._xdotool(*self._to((x, y)))

    def press(self, button: int = 1) -> None:
        self._xdotool("mousedown", button, "sleep", PAUSE)

    def release(self, button: int = 1) -> None:
        self._xdotool("mouseup", button, "sleep", PAUSE)

    def click(self, x: float, y: float, button: int = 1) -> None:
        self.drag([(x, y)], button)

    def double_click(self, x: float, y: float) -> None:
        self._xdotool(*self._to((x, y)), "click", "--repeat", 2, "--delay", 60, 1, "sleep", PAUSE)

    def scroll(self, x: float, y: float, clicks: int, hold: str = "") -> None:
        """Turn the wheel: up for positive `clicks`, down for negative; `hold`: a key held down."""
        turn = ["click", 4 if clicks > 0 else 5, "sleep", PAUSE] * abs(clicks)
        if hold:
            turn = ["keydown", hold, "sleep", PAUSE, *turn, "keyup", hold, "sleep", PAUSE]
        self._xdotool(*self._to((x, y)), *turn)

    def drag(
        self, path: Sequence[Point], button: int = 1, hold: Sequence[str] = (), steps: int = 8
    ) -> None:
        """Press at the first point, pass through the others in `steps` moves each, release.

        `hold`: keys held down all the while, such as "shift".
        """
        words = self._to(path[0])
        for key in hold:
            words += ["keydown", key, "sleep", PAUSE]
        words += ["mousedown", button, "sleep", PAUSE]
        for start, end in pairwise(path):
            for part in np.linspace(start, end, steps + 1)[1:]:
                words += self._to((part[0], part[1]))
        words += ["sleep", PAUSE, "mouseup", button, "sleep", PAUSE]
        for key in hold:
            words += ["keyup", key, "sleep", PAUSE]
        self._xdotool(*words)

    def widget(self, label: str, along: float = 0.5) -> Point:
        """Where a widget of the panel comes to rest; `along`: from its left to its right end."""
        places: list[object] = [None]

        def rests() -> bool:
            time.sleep(2 * PAUSE)
            note = json.loads(self._widgets.read_text()) if self._widgets.exists() else {}
            places.append(note.get(label))
            return places[-1] is not None and places[-1] == places[-2]

        wait_until(rests, what=f"{label!r} in the panel")
        left, top, right, bottom = json.loads(self._widgets.read_text())[label]
        return left + along * (right - left), (top + bottom) / 2

    def shows(self, label: str) -> bool:
        """Whether the last frame had this widget."""
        return label in json.loads(self._widgets.read_text())

    def choose(self, label: str, along: float = 0.5) -> None:
        """Click on a widget of the panel."""
        self.click(*self.widget(label, along))

    def open_section(self, title: str, inside: str) -> None:
        """Unfold a section of the panel, unless what is inside shows already."""
        self.wait_still()
        if not self.shows(inside):
            self.choose(title, 0.3)
        self.widget(inside)

    # The keyboard

    def key(self, chord: str) -> None:
        """Press keys joined by "+", in xdotool's names: "ctrl+shift+z", "bracketleft", "F1"."""
        keys = chord.split("+")
        words: list[object] = []
        for key in keys:
            words += ["keydown", key, "sleep", PAUSE]
        for key in reversed(keys):
            words += ["keyup", key, "sleep", PAUSE]
        self._xdotool(*words)

    def hold(self, key: str) -> None:
        """Press a key and leave it down."""
        self._xdotool("keydown", key, "sleep", PAUSE)

    def release_key(self, key: str) -> None:
        self._xdotool("keyup", key, "sleep", PAUSE)

    def type(self, text: str) -> None:
        self._xdotool("type", "--delay", round(1000 * PAUSE), text)

    # The eyes

    def size(self) -> tuple[int, int]:
        """Width and height of the window."""
        lines = self._xdotool("getwindowgeometry", "--shell", self._window).splitlines()
        geometry = dict(line.split("=") for line in lines)
        return int(geometry["WIDTH"]), int(geometry["HEIGHT"])

    def picture(self) -> Picture:
        """What the window shows, (height, width, 3)."""
        width, height = self.size()
        return self._display.picture()[:height, :width]

    def screenshot(self, path: Path) -> None:
        """Save what the window shows as a PNG file."""
        save_png(path, self.picture())

    def wait_still(self, still: float = 0.3, seconds: float = 30) -> None:
        """Wait until the picture has not changed for `still` seconds."""

        def is_still() -> bool:
            before = self.picture()
            time.sleep(still)
            return np.array_equal(before, self.picture())

        wait_until(is_still, seconds, "a still picture")

    def output(self) -> str:
        """Everything the program has printed so far."""
        return self._log.read_text(errors="replace")

    # The end

    def close(self) -> None:
        """Press the window manager's button; the program may ask what becomes of changes."""
        request_close(self._display.name, self._window)

    def quit(self, seconds: float = 20) -> int:
        """Close the window, whatever it asks: changes are kept; the program's exit code."""
        deadline = time.monotonic() + seconds
        while self.process.poll() is None:
            assert time.monotonic() < deadline, f"the window does not close: {self.output()}"
            self.close()
            with suppress(subprocess.TimeoutExpired):
                self.process.wait(1.0)
        return self.process.returncode

    def leave(self) -> None:
        """End the program however it stands."""
        if self.process.poll() is None:
            self.process.kill()
            self.process.wait()
