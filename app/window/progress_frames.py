"""Frames that are drawn while the program reads a file: they say how far it is."""

from __future__ import annotations

import time
from collections.abc import Callable

import polyscope as ps
import polyscope.imgui as psim

from app.window.messages import overlay
from app.workspace.tasks import Cancelled

PAUSE = 0.1  # seconds between two frames: drawing them must not take the time that is waited for


class ProgressFrames:
    """Draws a frame with a bar when it is told how far something is, but not too often.

    notice: what is being done.
    """

    def __init__(self, notice: str, panel: Callable[[], object]) -> None:
        """panel: draws what stands beside the scene."""
        self.notice = notice
        self._panel = panel
        self._last = 0.0
        self._cancelled = False

    def __call__(self, fraction: float) -> None:
        """A frame; whoever draws the usual ones has to be set again afterwards.

        Raises Cancelled once Esc was pressed or the window is to be closed.
        """
        now = time.perf_counter()
        if now - self._last >= PAUSE:
            self._last = now
            ps.set_user_callback(lambda: self._draw(fraction))
            ps.frame_tick()
        if self._cancelled or ps.window_requests_close():
            self._cancelled = False
            raise Cancelled("loading was cancelled")

    def _draw(self, fraction: float) -> None:
        self._panel()
        overlay("loading", self.notice, fraction=fraction)
        self._cancelled = self._cancelled or psim.IsKeyPressed(psim.ImGuiKey_Escape)
