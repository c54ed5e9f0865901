"""Messages at the lower end of the scene: what went wrong, what was done, what takes its time."""

from __future__ import annotations

import time

import polyscope.imgui as psim

from app.telling import readable
from app.window.panel.widgets import ERROR_COLOR, WIDTH
from app.window.scaling import scaled
from app.workspace.interaction import Message

BAR_WIDTH = 240.0
MESSAGE_SECONDS = {"info": 4.0, "error": 10.0}
PLACE = (
    psim.ImGuiWindowFlags_NoDecoration
    | psim.ImGuiWindowFlags_NoInputs
    | psim.ImGuiWindowFlags_AlwaysAutoResize
    | psim.ImGuiWindowFlags_NoSavedSettings
)


class Messages:
    """Shows each message for as long as it takes to read it."""

    def __init__(self) -> None:
        self._number = 0
        self._until = 0.0

    def draw(self, message: Message | None) -> None:
        """The last message, once a frame; nothing when its time is over."""
        if message is None:
            return
        if message.number != self._number:
            self._number = message.number
            self._until = time.perf_counter() + MESSAGE_SECONDS[message.kind]
        if time.perf_counter() < self._until:
            overlay("message", message.text, error=message.kind == "error")


def overlay(name: str, text: str, error: bool = False, fraction: float | None = None) -> None:
    """A line or more in the middle of the scene's lower end; the panel is beside it.

    fraction: of a bar below that shows how far something is, None without one.
    """
    text = readable(text)
    width, height = psim.GetIO().DisplaySize
    panel = scaled(WIDTH)
    psim.SetNextWindowPos((0.5 * (width + panel), height - scaled(30.0)), 0, (0.5, 1.0))
    psim.SetNextWindowBgAlpha(0.9)
    psim.Begin(f"##{name}", PLACE)
    psim.PushTextWrapPos(max(width - panel - scaled(60.0), scaled(100.0)))
    try:
        if error:
            psim.TextColored(ERROR_COLOR, text)
        else:
            psim.Text(text)
        if fraction is not None:
            psim.ProgressBar(fraction, (scaled(BAR_WIDTH), 0.0))
    finally:
        psim.PopTextWrapPos()
        psim.End()
