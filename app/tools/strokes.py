"""A brush stroke: from the cursor's rays to dabs on the surface."""

from __future__ import annotations

from typing import ClassVar

import numpy as np

from app.model.history import Gesture
from app.pointing.brush import MAX_DABS
from app.pointing.picking import Hit
from app.tools.marks import Paint
from app.viewpoint.camera import Ray, rays_between
from app.viewpoint.events import Input
from app.workspace.workspace import Workspace
from solver.types import FloatArray


class Stroke:
    """Paints along the cursor's path, however few frames saw it move, and across the mirror.

    mirror: what is painted there, if it is something else.
    """

    drags: ClassVar[bool] = False

    def __init__(
        self,
        work: Workspace,
        press: Input,
        hit: Hit,
        gesture: Gesture,
        paint: Paint,
        mirror: Paint | None = None,
    ) -> None:
        self._work = work
        self._gesture = gesture
        self._paint = paint
        self._mirror = mirror or paint
        self._image: FloatArray | None = None  # where the last dab was across the mirror
        self._ray: Ray | None = press.ray
        self._hit: Hit | None = hit
        self._depth = hit.distance
        self._radius = work.brush_radius(hit.position, press.camera)
        self._dab(hit, None)

    def move(self, frame: Input) -> None:
        """Paint from where the cursor was to where it is."""
        if frame.ray is None:
            self._ray = self._hit = None
            return
        before = self._ray or frame.ray
        length = self._travelled(before, frame.ray, self._work.under(frame))
        count = int(np.clip(np.ceil(2 * length / self._radius), 1, MAX_DABS))
        # A longer way than this from one dab to the next is a jump to another part of the surface.
        reach = max(self._radius, 2 * length / count)
        for ray in rays_between(before, frame.ray, count):
            hit = self._work.under(frame) if ray is frame.ray else self._work.pick(ray)
            if hit is not None:
                self._radius = self._work.brush_radius(hit.position, frame.camera)
                self._dab(hit, self._joined(hit, reach))
                self._depth = hit.distance
            self._hit = hit
        self._ray = frame.ray

    def finish(self) -> None:
        """Keep the stroke as one entry of the history."""
        for paint in {id(paint): paint for paint in (self._paint, self._mirror)}.values():
            paint.finish(self._gesture)
        self._work.history.record(self._gesture.finish(self._paint.label))

    def cancel(self) -> None:
        """Take the stroke back."""
        self._gesture.cancel()

    def _travelled(self, before: Ray, now: Ray, hit: Hit | None) -> float:
        """About how far the brush moves along the surface from one ray to another and its hit."""
        length = float(np.linalg.norm(now.at(self._depth) - before.at(self._depth)))
        if hit is not None and self._hit is not None:
            length = max(length, float(np.linalg.norm(hit.position - self._hit.position)))
        return length

    def _joined(self, hit: Hit, reach: float) -> FloatArray | None:
        """Where the last dab was, if the brush came from there along the surface."""
        if self._hit is None or np.linalg.norm(hit.position - self._hit.position) > reach:
            return None
        return self._hit.position

    def _dab(self, hit: Hit, start: FloatArray | None) -> None:
        self._touch(self._paint, hit, start)
        symmetry = self._work.symmetry
        image = None if symmetry is None else symmetry.hit(hit, self._work.positions)
        if image is not None and image.vertex != hit.vertex:
            self._touch(self._mirror, image, None if start is None else self._image)
        self._image = None if image is None else image.position

    def _touch(self, paint: Paint, hit: Hit, start: FloatArray | None) -> None:
        touched = self._work.neighbours.dab(self._work.positions, hit, self._radius, start)
        paint.dab(self._gesture, *touched)
