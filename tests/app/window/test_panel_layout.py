"""Nothing in the panel is cut off or covered, at any size of the window and of the interface."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from itertools import combinations
from pathlib import Path

import pytest

from app.bundled import ASSETS
from tests.app.window.layout import Item

pytest.importorskip("polyscope", exc_type=ImportError)
widgets = pytest.importorskip("app.window.panel.widgets", exc_type=ImportError)

ROOT = Path(__file__).resolve().parents[3]
SCREENS = ((1000, 650, 1.0), (1280, 800, 1.0), (1920, 1080, 1.25), (2560, 1440, 2.0))
ROUNDING = 1.0  # pixel


def layout(width: int, height: int, scale: float, tool: str, mesh: Path) -> list[Item]:
    """Everything in a panel of which all is unfolded."""
    words = [str(word) for word in (width, height, scale, tool, mesh)]
    done = subprocess.run(
        [sys.executable, "-m", "tests.app.window.layout", *words],
        cwd=ROOT,
        env=os.environ | {"PYTHONPATH": str(ROOT)},
        capture_output=True,
        text=True,
        check=True,
        timeout=120,
    )
    return [Item(**json.loads(line)) for line in done.stdout.splitlines()]


def covers(one: Item, other: Item) -> bool:
    """Whether two things have more than a rim in common."""
    low = [max(a, b) for a, b in zip(one.low, other.low, strict=True)]
    high = [min(a, b) for a, b in zip(one.high, other.high, strict=True)]
    return all(b - a > ROUNDING for a, b in zip(low, high, strict=True))


def check(items: list[Item], height: int, scale: float) -> None:
    panel = [item for item in items if not item.inner]
    right = scale * widgets.WIDTH
    for item in items:
        assert item.low[0] >= 0, item
        assert item.high[0] <= right + ROUNDING, item
        assert item.high[0] - item.low[0] >= item.needs - ROUNDING, f"its text is cut: {item}"
    for one, other in combinations(panel, 2):
        assert not covers(one, other), (one, other)
    last = panel[-1]
    assert last.high[1] - last.below <= height, "the last row can be reached"
    assert last.below == 0 or last.high[1] > height, "nothing scrolls that fits"


@pytest.mark.parametrize("tool", ["fixed", "handle", "drag"])
def test_the_options_of_other_tools(tool: str) -> None:
    items = layout(1280, 800, 1.0, tool, ASSETS / "dressed-elbow.json")
    check(items, 800, 1.0)
    assert "##mx" in {item.label for item in items} or tool != "drag"


@pytest.mark.parametrize(("width", "height", "scale"), SCREENS)
def test_a_character_of_many_parts(width: int, height: int, scale: float) -> None:
    items = layout(width, height, scale, "softness", ASSETS / "dressed-elbow.json")
    check(items, height, scale)
    labels = {item.label for item in items}
    assert {"Tools", "Parts", "Fill", "##map", "Record", "Open...", "Export as..."} <= labels
    fonts = {round(item.high[1] - item.low[1]) for item in items if item.kind == "TextDisabled"}
    assert fonts == {round(18 * scale)}, "all is as large as it is to be"


@pytest.mark.parametrize(("width", "height", "scale"), SCREENS)
def test_a_long_name_and_paths_that_are_typed(
    width: int, height: int, scale: float, tmp_path: Path
) -> None:
    mesh = tmp_path / f"{'the-name-of-a-mesh-that-somebody-was-proud-of-' * 2}.obj"
    shutil.copy(ASSETS / "bar.obj", mesh)
    items = layout(width, height, scale, "handle", mesh)
    check(items, height, scale)
    assert {"Save session", "Export mesh"} <= {item.label for item in items}
    assert "Open..." not in {item.label for item in items}
