"""Vertices where a camera sees them, to find the one nearest to the cursor."""

from __future__ import annotations

import numpy as np

from app.viewpoint.camera import Camera, Pixel
from solver.types import FloatArray, IntArray


class SeenVertices:
    """Some vertices (k,) of positions (n, 3), as pixels of one camera; found once."""

    def __init__(self, vertices: IntArray, positions: FloatArray, camera: Camera) -> None:
        self._vertices = vertices
        pixels = camera.project(positions[vertices])
        # What is behind the camera is near to nothing.
        self._x, self._y = np.where(np.isfinite(pixels), pixels, np.inf).T.copy()

    def nearest(self, pixel: Pixel, reach: float) -> int | None:
        """The vertex nearest to a pixel, None if none is within `reach` pixels of it."""
        if not len(self._vertices):
            return None
        away = (self._x - pixel[0]) ** 2 + (self._y - pixel[1]) ** 2
        best = int(away.argmin())
        return int(self._vertices[best]) if away[best] <= reach**2 else None
