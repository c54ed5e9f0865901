"""Where a person looks from: the camera, the point it turns about, and how the mouse moves both."""

from __future__ import annotations

from collections.abc import Callable
from typing import Literal

import numpy as np

from app.viewpoint.camera import FIELD_OF_VIEW, Camera, Pixel
from app.viewpoint.events import Input
from app.viewpoint.framing import framing
from app.viewpoint.moves import orbited, panned, zoomed
from solver.geometry.bounding_box import diagonal, middle
from solver.types import FloatArray

Motion = Literal["orbit", "pan"]
# How close the camera may come to what it goes towards, in diagonals of the mesh.
NEAREST = 1e-2
# Half the width of lines on the surface, in pixels, and the steps in which it follows the distance.
LINE, COARSER = 1.1, 1.2
UPS: dict[str, FloatArray] = {"y": np.array([0.0, 1.0, 0.0]), "z": np.array([0.0, 0.0, 1.0])}
# What the camera looks along, in terms of right, up and towards the viewer of a front view.
SIDES = {
    "front": (0.0, 0.0, -1.0),
    "back": (0.0, 0.0, 1.0),
    "left": (1.0, 0.0, 0.0),
    "right": (-1.0, 0.0, 0.0),
    "top": (0.0, -1.0, 0.0),
    "bottom": (0.0, 1.0, 0.0),
}


class Viewpoint:
    """The camera of the window.

    camera: as it is now.  pivot: (3,) the point that the view turns about.  up_name: one of UPS,
    the axis that stays upright.  inset: pixels at the left of the window that a panel covers.
    """

    def __init__(self) -> None:
        self.inset = 0.0
        self.up_name = "y"
        self.pivot: FloatArray = np.zeros(3)
        self.camera = Camera.look_at([0, 0, 1], [0, 0, 0], FIELD_OF_VIEW, (1280, 800))
        self._middle, self._size = self.pivot, 1.0
        self._motion: Motion | None = None
        self._last: Pixel | None = None
        self._point: FloatArray = self.pivot
        # What is seen is framed again in a window of another size, until it is looked at otherwise.
        self._framed: FloatArray | None = None

    def show(self, positions: FloatArray) -> None:
        """Look at another surface, of vertices (n, 3), from the front."""
        self._middle = middle(positions)
        self._size = diagonal(positions) or 1.0
        self.view_from("front", positions)

    @property
    def up(self) -> FloatArray:
        """(3,) unit, the axis that stays upright."""
        return UPS[self.up_name]

    def set_up(self, name: str) -> None:
        """Make another axis the one that stays upright, from the next view on."""
        self.up_name = name

    def view_from(self, side: str, positions: FloatArray) -> None:
        """See the whole of `positions` (n, 3) from one of SIDES.

        Whoever looks from above or below has the front at the lower or the upper edge.
        """
        right, towards = np.array([1.0, 0.0, 0.0]), np.cross([1.0, 0.0, 0.0], self.up)
        axes = np.column_stack([right, self.up, towards])
        forward = axes @ SIDES[side]
        steep = {"top": -towards, "bottom": towards}
        self._frame(positions, forward, steep.get(side, self.up))

    def frame(self, positions: FloatArray, about: FloatArray | None = None) -> None:
        """See the whole of `positions` (n, 3) from where the camera is.

        about: (k, 3) those that the view turns about, all by default.
        """
        self._frame(positions, self.camera.forward, self.camera.up)
        if about is not None:
            self.pivot = middle(about)

    def frames(self, positions: FloatArray) -> bool:
        """Whether these positions have been framed, and nothing looked at otherwise since."""
        return self._framed is not None and np.array_equal(self._framed, positions)

    def _frame(self, positions: FloatArray, forward: FloatArray, up: FloatArray) -> None:
        self.camera = framing(positions, self.camera.size, self.inset, forward, up)
        self.pivot = middle(positions)
        self._framed = positions

    def fit(self, size: tuple[float, float], inset: float) -> None:
        """The window has this size, the panel this width."""
        if (size, inset) == (self.camera.size, self.inset) or min(size) <= 0:
            return
        self.inset, self.camera = inset, self.camera.resized(size)
        if self._framed is not None:
            axes = self.camera.forward, self.camera.up
            self.camera = framing(self._framed, size, inset, *axes)

    @property
    def reach(self) -> float:
        """About how far away the farthest part of the surface is."""
        return float(np.linalg.norm(self.camera.position - self._middle)) + self._size

    @property
    def line_radius(self) -> float:
        """About a pixel at the pivot, in world units: the same as long as little changes."""
        pixel = self.camera.pixel_angle * float(np.linalg.norm(self.camera.position - self.pivot))
        return LINE * COARSER ** round(np.log(max(pixel, 1e-300)) / np.log(COARSER))

    def advance(
        self, frame: Input, left: Motion | None, under: Callable[[], FloatArray | None]
    ) -> None:
        """One frame of the mouse.

        left: what the primary button does, if it is not a tool's.
        under: the point of the surface under the cursor.
        """
        self.camera = frame.camera
        motion = _motion(frame, left)
        if motion != self._motion:
            self._motion, self._last = motion, frame.pixel
            if motion == "pan":
                self._point = self._anchor(frame, under())
        if frame.pixel is not None:
            if self._last is not None and frame.pixel != self._last:
                self._move(frame.pixel)
            if frame.wheel and not frame.ctrl:  # with Ctrl it is the brush's
                point = self._anchor(frame, under())
                self._look(zoomed(self.camera, point, frame.wheel, NEAREST * self._size))
        self._last = frame.pixel if motion else None

    def _move(self, pixel: Pixel) -> None:
        assert self._last is not None
        if self._motion == "pan":
            self._look(panned(self.camera, self._point, pixel))
        elif self._motion == "orbit":
            way = pixel[0] - self._last[0], pixel[1] - self._last[1]
            self._look(orbited(self.camera, self.pivot, way, self.up))

    def _look(self, camera: Camera) -> None:
        self.camera = camera
        self._framed = None

    def _anchor(self, frame: Input, hit: FloatArray | None) -> FloatArray:
        """The point that the cursor holds: of the surface, or beside it as far as the pivot."""
        if hit is not None or frame.pixel is None:
            return self.pivot if hit is None else hit
        depth = max(self.camera.depth(self.pivot), NEAREST * self._size)
        return self.camera.at_depth(frame.pixel, depth)


def _motion(frame: Input, left: Motion | None) -> Motion | None:
    """Right drags pan, middle ones turn; with Shift both pan."""
    if frame.secondary:
        return "pan"
    if frame.middle:
        return "pan" if frame.shift else "orbit"
    return left if frame.down else None
