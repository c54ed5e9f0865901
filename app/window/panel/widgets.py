"""Measures, colours and small widgets that the parts of the panel share."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import polyscope.imgui as psim

from solver.types import FloatArray

WIDTH = 310.0
BUTTON_COLUMN = WIDTH - 86.0  # where the buttons behind a region begin
REST_OF_LINE = (-1.0, 0.0)
ERROR_COLOR = (1.0, 0.45, 0.4, 1.0)
BUSY_COLOR = (1.0, 0.8, 0.3, 1.0)
CHOSEN_COLOR = (0.18, 0.5, 0.85, 1.0)


def logarithmic(
    label: str, value: float, low: float, high: float, text: str = "%.3g"
) -> tuple[bool, float]:
    """A slider over several orders of magnitude: whether it was moved, and its value."""
    moved, value = psim.SliderFloat(
        label, value, low, high, text, psim.ImGuiSliderFlags_Logarithmic
    )
    return bool(moved), min(max(value, low), high)


def halves(*labels: str) -> Iterator[str]:
    """The labels of two widgets that share a line; what they are called stands inside them."""
    width = 0.5 * (psim.GetContentRegionAvail()[0] - psim.GetStyle().ItemSpacing[0])
    for number, label in enumerate(labels):
        if number:
            psim.SameLine()
        psim.SetNextItemWidth(width)
        yield label


def swatch(color: FloatArray) -> None:
    """A small field of one colour, before something on the same line."""
    red, green, blue = map(float, color)
    flags = psim.ImGuiColorEditFlags_NoTooltip
    psim.AlignTextToFramePadding()
    psim.ColorButton("##swatch", (red, green, blue, 1.0), flags, (12.0, psim.GetFrameHeight()))
    psim.SameLine()


@contextmanager
def disabled(off: bool) -> Iterator[None]:
    """Draw what is inside as something that cannot be used now."""
    psim.BeginDisabled(off)
    yield
    psim.EndDisabled()
