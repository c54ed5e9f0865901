"""What a person did in one frame, as plain data: the only thing the editor knows of the mouse."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from app.viewpoint.camera import Camera, Pixel, Ray

BACKSPACE, ENTER = "\b", "\n"


@dataclass(frozen=True, eq=False)
class Input:
    """One frame of the mouse.

    pixel: where the cursor is; None over the panel or outside the window.
    camera: what the person sees the scene through.
    pressed, released: the primary button went down or up in this frame (both: a quick click).
    down: the button is down at the end of this frame.
    clicks: how many presses in quick succession a press is the last of.
    secondary, middle: these buttons are down.  wheel: notches, away from the person positive.
    shift, ctrl, alt: these keys are down.
    typed: what went down in this frame of digits, ".", "-", x, y, z, BACKSPACE and ENTER.
    """

    pixel: Pixel | None
    camera: Camera
    pressed: bool = False
    down: bool = False
    released: bool = False
    clicks: int = 1
    secondary: bool = False
    middle: bool = False
    wheel: float = 0.0
    shift: bool = False
    ctrl: bool = False
    alt: bool = False
    typed: str = ""

    @cached_property
    def ray(self) -> Ray | None:
        """Through the cursor, the same object each time; None where there is no pixel."""
        return None if self.pixel is None else self.camera.ray(self.pixel)
