"""Fixtures: one virtual display a run, and windows that end with their test."""

from __future__ import annotations

import shutil
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from .display import VirtualDisplay
from .person import Person


@pytest.fixture(scope="session")
def display(tmp_path_factory: pytest.TempPathFactory) -> Iterator[VirtualDisplay]:
    """A virtual screen; skips where Xvfb or xdotool is missing."""
    missing = [name for name in ("Xvfb", "xdotool") if shutil.which(name) is None]
    if missing:
        pytest.skip(f"not installed: {', '.join(missing)}; the window cannot be tested")
    display = VirtualDisplay(tmp_path_factory.mktemp("display"))
    yield display
    display.stop()


@pytest.fixture
def open_window(display: VirtualDisplay, tmp_path: Path) -> Iterator[Callable[..., Person]]:
    """`open_window(*arguments)` starts `python -m app ARGUMENTS` in `tmp_path`."""
    people: list[Person] = []

    def open_window(*arguments: str | Path) -> Person:
        people.append(Person(display, [str(word) for word in arguments], tmp_path))
        return people[-1]

    yield open_window
    for person in people:
        person.leave()
