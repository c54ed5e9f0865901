"""The vertices of handles where a camera sees them, to find the one nearest to the cursor."""

from __future__ import annotations

import numpy as np

from app.latest import Latest
from app.live.live_surface import LiveSurface
from app.model.document import Document
from app.model.handles import FIRST_HANDLE
from app.viewpoint.camera import Camera, Pixel
from app.workspace.parts import Parts
from solver.types import FloatArray, IntArray


class SeenVertices:
    """Some vertices (k,) of positions (n, 3), as pixels of one camera."""

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


class SeenHandles:
    """Finds the vertices of handles again where they or the camera differ, not in every frame."""

    def __init__(self) -> None:
        self._seen: Latest[SeenVertices] = Latest()

    def by(
        self, camera: Camera, document: Document, parts: Parts, surface: LiveSurface
    ) -> SeenVertices:
        """Those of parts that are shown."""

        def found() -> SeenVertices:
            held = (document.role >= FIRST_HANDLE) & parts.visible
            return SeenVertices(np.flatnonzero(held), surface.positions, camera)

        version = camera, surface.version, document.revision["role"], parts.hidden
        return self._seen(version, found)
