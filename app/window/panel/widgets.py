"""Measures, colours and small widgets that the parts of the panel share.

Measures are for an interface of size 1: `scaled` makes pixels of them.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import polyscope.imgui as psim

from app.telling import readable
from app.window.scaling import scaled
from solver.types import FloatArray

WIDTH = 310.0
CONTENT_WIDTH = WIDTH - 26.0  # a scroll bar has room beside it: nothing moves when one appears
BUTTON_COLUMN = WIDTH - 92.0  # where the buttons behind a region begin
REST_OF_LINE = (-1.0, 0.0)
SWATCH_WIDTH = 12.0
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


def share(count: int) -> tuple[float, float]:
    """The size of a button, where so many share a line evenly."""
    gaps = (count - 1) * psim.GetStyle().ItemSpacing[0]
    return (psim.GetContentRegionAvail()[0] - gaps) / count, 0.0


def shares(*labels: str) -> Iterator[tuple[str, tuple[float, float]]]:
    """The labels of buttons that share a line evenly, and the size of each."""
    size = share(len(labels))
    for number, label in enumerate(labels):
        if number:
            psim.SameLine()
        yield label, size


def halves(*labels: str) -> Iterator[str]:
    """The labels of two widgets that share a line; what they are called stands inside them."""
    for label, (width, _) in shares(*labels):
        psim.SetNextItemWidth(width)
        yield label


def swatch(color: FloatArray) -> None:
    """A small field of one colour, before something on the same line."""
    red, green, blue = map(float, color)
    flags = psim.ImGuiColorEditFlags_NoTooltip
    size = scaled(SWATCH_WIDTH), psim.GetFrameHeight()
    psim.AlignTextToFramePadding()
    psim.ColorButton("##swatch", (red, green, blue, 1.0), flags, size)
    psim.SameLine()


def button_column() -> None:
    """Go on in the same line, where the buttons behind a region begin."""
    psim.SameLine(scaled(BUTTON_COLUMN))


def text_until(column: float, text: str, quiet: bool = False) -> None:
    """Text that ends before a column of the panel; where it is cut its tooltip has the whole."""
    text = readable(text)
    room = scaled(column) - psim.GetCursorPosX() - psim.GetStyle().ItemSpacing[0]
    short = shortened(text, room)
    (psim.TextDisabled if quiet else psim.Text)(short)
    if short != text:
        psim.SetItemTooltip(text)


def text_field(label: str, text: str, hint: str = "", flags: int = 0) -> tuple[bool, str]:
    """A field for a name or a path: whether Enter asked for it, and what is in it now.

    What cannot be shown is escaped, and stays what it was until something else is typed.
    """
    shown = readable(text)
    entered, typed = psim.InputTextWithHint(label, hint, shown, flags)
    return bool(entered), text if typed == shown else typed


def shortened(text: str, width: float) -> str:
    """The beginning and the end of a text that is too long for so many pixels."""
    kept = len(text)
    short = text
    while kept > 2 and psim.CalcTextSize(short)[0] > width:
        kept -= 1
        short = f"{text[: kept - kept // 2]}...{text[len(text) - kept // 2 :]}"
    return short


@contextmanager
def disabled(off: bool) -> Iterator[None]:
    """Draw what is inside as something that cannot be used now."""
    psim.BeginDisabled(off)
    yield
    psim.EndDisabled()


def typed_path(text: str) -> Path:
    """The path that was typed into a field."""
    return Path(text.strip()).expanduser()


def short_path(path: Path) -> str:
    """As a field has it: relative to the working directory where it lies below."""
    try:
        return str(path.resolve().relative_to(Path.cwd()))
    except ValueError:
        return str(path)
