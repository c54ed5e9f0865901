"""Screens of other sizes: the window opens as it was, its panel as large as it is preferred."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from .display import VirtualDisplay
from .person import Person, wait_until

SCALE, SIZE = 2.0, (2560, 1440)
FIRST_HEADER = (60.0, 121.0)  # of the panel, for an interface of size 1


@pytest.fixture
def person(display: VirtualDisplay, tmp_path: Path) -> Iterator[Person]:
    """On a screen with twice as many pixels. `display`: skips where there can be none."""
    preferences = {"dialogs": False, "interface_scale": SCALE, "window": SIZE}
    (tmp_path / "preferences").write_text(json.dumps(preferences))
    (tmp_path / "display").mkdir()
    large = VirtualDisplay(tmp_path / "display", *SIZE)
    try:
        person = Person(large, [], tmp_path)
        yield person
        person.leave()
    finally:
        large.stop()


def panel_width(person: Person) -> int:
    """Pixels until the panel's colour ends, along the lower edge."""
    row = person.picture()[-1].astype(int)
    return int(np.flatnonzero(np.abs(row - row[2]).max(axis=1) > 20)[0])


def test_all_is_twice_as_large_and_sections_fold(person: Person, tmp_path: Path) -> None:
    from app.window.panel import WIDTH

    assert person.size() == SIZE
    assert abs(panel_width(person) - SCALE * WIDTH) <= 1
    person.move(2400, 1300)
    person.wait_still()
    before = person.picture()[:, :600].copy()
    header = SCALE * FIRST_HEADER[0], SCALE * FIRST_HEADER[1]
    person.click(*header)
    person.move(2400, 1300)
    wait_until(lambda: not np.array_equal(person.picture()[:, :600], before), what="it is folded")
    person.click(*header)
    person.move(2400, 1300)
    wait_until(lambda: np.array_equal(person.picture()[:, :600], before), what="it is unfolded")
    assert person.quit() == 0
    assert json.loads((tmp_path / "preferences").read_text())["window"] == list(SIZE)
