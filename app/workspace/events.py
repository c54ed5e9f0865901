"""What a person did in one frame, as plain data: the only thing the editor knows of the mouse."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from solver.types import FloatArray


@dataclass(frozen=True, eq=False)
class Ray:
    """A half-line. origin: (3,) world position. direction: (3,) of unit length."""

    origin: FloatArray
    direction: FloatArray

    def at(self, distance: float) -> FloatArray:
        """The point `distance` along the ray, (3,)."""
        return self.origin + distance * self.direction


def _into_the_screen() -> FloatArray:
    return np.array([0.0, 0.0, -1.0])


@dataclass(frozen=True, eq=False)
class Input:
    """One frame of the mouse.

    ray: through the cursor; None when the cursor is over the panel or outside the window.
    view_direction: (3,) unit, the middle of the view, into the screen.
    pressed, released: the primary button went down or up in this frame (both: a quick click).
    down: the button is down at the end of this frame.
    shift: the shift key is down.
    """

    ray: Ray | None = None
    view_direction: FloatArray = field(default_factory=_into_the_screen)
    pressed: bool = False
    down: bool = False
    released: bool = False
    shift: bool = False
