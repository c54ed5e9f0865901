"""Messages at the lower end of the scene: what went wrong, what was done, what takes its time."""

from __future__ import annotations

import time
from collections.abc import Iterator
from contextlib import contextmanager

import polyscope.imgui as psim

from app.telling import readable
from app.window.panel.widgets import ERROR_COLOR, WIDTH
from app.window.scaling import scaled
from app.workspace.interaction import Message
from app.workspace.tasks import Task

BAR_WIDTH = 240.0
GAP = 6.0  # between a message and what is below it
AT_ONCE = 0.25  # seconds after which something takes its time
MESSAGE_SECONDS = {"info": 4.0, "error": 10.0}
PLACE = (
    psim.ImGuiWindowFlags_NoDecoration
    | psim.ImGuiWindowFlags_AlwaysAutoResize
    | psim.ImGuiWindowFlags_NoSavedSettings
)


class Messages:
    """Shows each message for as long as it takes to read it."""

    def __init__(self) -> None:
        self._number = 0
        self._until = 0.0

    def draw(self, message: Message | None, above: float = 0.0) -> None:
        """The last message, once a frame; nothing when its time is over.

        above: how many pixels higher than usual.
        """
        if message is None:
            return
        if message.number != self._number:
            self._number = message.number
            self._until = time.perf_counter() + MESSAGE_SECONDS[message.kind]
        if time.perf_counter() < self._until:
            overlay("message", message.text, error=message.kind == "error", above=above)


def overlay(
    name: str,
    text: str,
    error: bool = False,
    fraction: float | None = None,
    above: float = 0.0,
) -> None:
    """A line or more in the middle of the scene's lower end; the panel is beside it.

    fraction: of a bar below that shows how far something is, None without one.
    above: how many pixels higher than usual.
    """
    text = readable(text)
    with _place(name, PLACE | psim.ImGuiWindowFlags_NoInputs, above):
        if error:
            psim.TextColored(ERROR_COLOR, text)
        else:
            psim.Text(text)
        if fraction is not None:
            psim.ProgressBar(fraction, (scaled(BAR_WIDTH), 0.0))


def draw_task(task: Task) -> tuple[float, bool]:
    """What is under way, how far it is, and a button that takes it back.

    Returns its height in pixels, and whether the button was pressed. Nothing is drawn of what is
    over at once: it would only flicker.
    """
    now = time.monotonic()
    if now - task.since < AT_ONCE:
        return 0.0, False
    with _place("task", PLACE):
        psim.Text(f"{task.name} ...")
        # A negative fraction is a bar that runs to and fro, as long as nobody can tell.
        fraction = task.fraction if task.fraction is not None else -now
        psim.ProgressBar(fraction, (scaled(BAR_WIDTH), 0.0))
        psim.SameLine()
        cancelled = psim.Button("Cancel (Esc)")
        return psim.GetWindowHeight() + scaled(GAP), bool(cancelled)


@contextmanager
def _place(name: str, flags: int, above: float = 0.0) -> Iterator[None]:
    """In the middle of the scene's lower end."""
    width, height = psim.GetIO().DisplaySize
    panel = scaled(WIDTH)
    place = 0.5 * (width + panel), height - scaled(30.0) - above
    psim.SetNextWindowPos(place, 0, (0.5, 1.0))
    psim.SetNextWindowBgAlpha(0.9)
    psim.Begin(f"##{name}", flags)
    psim.PushTextWrapPos(max(width - panel - scaled(60.0), scaled(100.0)))
    try:
        yield
    finally:
        psim.PopTextWrapPos()
        psim.End()
