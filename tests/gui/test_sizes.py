"""Screens of other sizes: the window opens as it was, its panel as large as it is preferred."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest

from .display import VirtualDisplay
from .person import Person, wait_until
from .resources import set_resolution

SCALE, SIZE = 2.0, (2560, 1440)


@pytest.fixture
def large(display: VirtualDisplay, tmp_path: Path) -> Iterator[VirtualDisplay]:
    """A screen with twice as many pixels. `display`: skips where there can be none."""
    (tmp_path / "display").mkdir()
    large = VirtualDisplay(tmp_path / "display", *SIZE)
    yield large
    large.stop()


@pytest.fixture
def sit_down(
    large: VirtualDisplay, tmp_path: Path, see_out: Callable[[Person], None]
) -> Iterator[Callable[..., Person]]:
    """`sit_down(**preferences)` opens the window before that screen."""
    people: list[Person] = []

    def sit_down(**preferences: object) -> Person:
        (tmp_path / "preferences").write_text(json.dumps({"dialogs": False, **preferences}))
        people.append(Person(large, [], tmp_path))
        return people[-1]

    yield sit_down
    for person in people:
        see_out(person)


def panel_width(person: Person) -> int:
    """Pixels until the panel's colour ends, along the lower edge."""
    row = person.picture()[-1].astype(int)
    return int(np.flatnonzero(np.abs(row - row[2]).max(axis=1) < 20)[-1]) + 1


def test_a_window_suits_the_scale_of_the_screen(
    large: VirtualDisplay, sit_down: Callable[..., Person]
) -> None:
    from app.window.panel import WIDTH

    set_resolution(large.name, 144)
    person = sit_down()
    assert person.size() == (1920, 1200)
    assert abs(panel_width(person) - 1.5 * WIDTH) <= 1


@pytest.mark.parametrize(
    ("scale", "size"),
    [(1.0, (1000, 650)), (1.0, (1280, 800)), (SCALE, SIZE)],
    ids=["small", "usual", "large"],
)
def test_the_whole_figure_stands_beside_the_panel(
    sit_down: Callable[..., Person], scale: float, size: tuple[int, int]
) -> None:
    person = sit_down(interface_scale=scale, window=size)
    assert person.size() == size
    person.key("1")  # without the gizmo, which may pass over the border
    person.move(size[0] - 5, 5)
    person.wait_still()
    view = person.picture()[:, panel_width(person) :].astype(int)
    figure = np.abs(view - view[0, -1]).max(axis=2) > 12
    messages = round(100 * scale)
    assert figure[:-messages].mean() > 0.05
    for border in (figure[0], figure[:-messages, 0], figure[:-messages, -1]):
        assert not border.any()


def test_all_is_as_large_as_is_preferred_and_sections_fold(
    sit_down: Callable[..., Person], tmp_path: Path
) -> None:
    from app.window.panel import WIDTH

    person = sit_down(interface_scale=SCALE, window=SIZE)
    assert person.size() == SIZE
    assert abs(panel_width(person) - SCALE * WIDTH) <= 1
    person.move(2400, 1300)
    person.wait_still()
    before = person.picture()[:, :600].copy()
    person.choose("Tools")
    person.move(2400, 1300)
    wait_until(lambda: not np.array_equal(person.picture()[:, :600], before), what="it is folded")
    person.choose("Tools")
    person.move(2400, 1300)
    wait_until(lambda: np.array_equal(person.picture()[:, :600], before), what="it is unfolded")
    assert person.quit() == 0
    assert json.loads((tmp_path / "preferences").read_text())["window"] == list(SIZE)
