"""Dragging a handle: it follows the cursor in a plane parallel to the screen."""

from __future__ import annotations

from typing import ClassVar

import numpy as np

from app.model.history import Gesture
from app.viewpoint.camera import Ray
from app.viewpoint.events import Input
from app.workspace.workspace import Workspace
from solver.geometry.motions import moved_back
from solver.types import FloatArray

GRAZING = 1e-6  # cosine below which a ray counts as parallel to the plane
STILL = 1e-5  # in diagonals, far below a pixel: the cursor has not moved


class Drag:
    """Moves one handle by the point it was grabbed at. Waits while the solver is still binding.

    key: of the handle.  start: (3,) where it was grabbed.
    """

    drags: ClassVar[bool] = True

    def __init__(self, work: Workspace, press: Input, key: int, start: FloatArray) -> None:
        self.work = work
        self.key = key
        self.gesture = Gesture(work.document)
        self._done: tuple[object, ...] = ()
        self._early = False  # the cursor has moved, and the solver is still binding
        self._start = start
        self._normal = press.camera.forward
        self.hold(work.document.pose.of(key))

    def hold(self, T: FloatArray) -> None:
        """Hold the handle at the grabbed point from where it is at T, (4, 4)."""
        self._grabbed = moved_back(T, self._start)

    def move(self, frame: Input) -> None:
        """Take the grabbed point to where the cursor's ray meets the plane. Raises SolverError."""
        work = self.work
        target = None if frame.ray is None else self._target(frame.ray)
        if target is None:
            return
        self._early = not work.surface.holds(self.key)
        if self._early:
            return
        asked = (work.surface.bound, work.turn, *target)
        if asked == self._done:  # the cursor rests
            return
        self._done = asked
        transform = self._turned(target) if work.turn else self._shifted(target)
        self.gesture.change("pose", work.posed(work.document.pose, {self.key: transform}))

    def finish(self) -> None:
        """Keep the drag as one entry of the history."""
        self.tell_early()
        handle = self.work.document.find(self.key)
        assert handle is not None
        self.work.history.record(self.gesture.finish(f"Drag {handle.name}"))

    def tell_early(self) -> None:
        """Say why nothing moved, where the drag was over before the bind."""
        if self._early:
            self.work.say("The solver was still binding: drag once more")

    def cancel(self) -> None:
        """Put the handle back."""
        self.gesture.cancel()

    def _target(self, ray: Ray) -> FloatArray | None:
        """The point of the plane under the cursor; None beside it, or while nothing has moved."""
        slope = float(ray.direction @ self._normal)
        if slope < GRAZING:
            return None
        target = ray.at(float((self._start - ray.origin) @ self._normal) / slope)
        still = np.linalg.norm(target - self._start) < STILL * self.work.document.diagonal
        # A click must not turn the handle; a handle brought back to where it was may.
        return None if still and not self.gesture.started else target

    def _turned(self, target: FloatArray) -> FloatArray:
        work = self.work
        return work.surface.orient(work.document, self.key, self._grabbed, target)

    def _shifted(self, target: FloatArray) -> FloatArray:
        transform = self.work.document.pose.of(self.key).copy()
        transform[:3, 3] = target - transform[:3, :3] @ self._grabbed
        return transform
