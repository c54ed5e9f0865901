"""Where the camera has to be for a surface to fill the window beside the panel."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from app.viewpoint.camera import FIELD_OF_VIEW, Camera
from solver.types import FloatArray

FIT = 1.15  # how much larger than the surface a framed view is
FRONT = (0.0, 0.0, -1.0)
UP = (0.0, 1.0, 0.0)


def framing(
    positions: FloatArray,
    size: tuple[float, float],
    inset: float = 0.0,
    forward: ArrayLike = FRONT,
    up: ArrayLike = UP,
) -> Camera:
    """The whole of `positions` (n, 3), right of `inset` pixels of panel.

    forward, up: where the camera looks, unit and orthogonal; by default from the front.
    """
    forward, up = (np.asarray(axis, dtype=np.float64) for axis in (forward, up))
    right = np.cross(forward, up)
    along = positions @ np.column_stack([right, up, forward])
    low, high = along.min(axis=0), along.max(axis=0)
    wide, tall, deep = high - low
    width, height = size
    # Height of the view, in world units, at the front of the bounding box.
    view = max(FIT * max(tall, wide * height / max(width - inset, 1.0)), 1e-9)
    distance = 0.5 * view / np.tan(0.5 * FIELD_OF_VIEW) + 0.5 * deep
    x, y, z = 0.5 * (low + high)
    position = (x - 0.5 * inset / height * view) * right + y * up + (z - distance) * forward
    return Camera(position, forward, up, FIELD_OF_VIEW, size)
