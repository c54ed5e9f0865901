"""What a person did in one frame, as plain data: the only thing the editor knows of the mouse."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from app.workspace.camera import Camera, Pixel, Ray


@dataclass(frozen=True, eq=False)
class Input:
    """One frame of the mouse.

    pixel: where the cursor is; None over the panel or outside the window.
    camera: what the person sees the scene through.
    pressed, released: the primary button went down or up in this frame (both: a quick click).
    down: the button is down at the end of this frame.
    shift: the shift key is down.
    """

    pixel: Pixel | None
    camera: Camera
    pressed: bool = False
    down: bool = False
    released: bool = False
    shift: bool = False

    @cached_property
    def ray(self) -> Ray | None:
        """Through the cursor, the same object each time; None where there is no pixel."""
        return None if self.pixel is None else self.camera.ray(self.pixel)
