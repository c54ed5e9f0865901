"""Dragging a handle: it follows the cursor in a plane parallel to the screen."""

from __future__ import annotations

from typing import ClassVar

import numpy as np

from app.model.handles import Pose
from app.model.history import Gesture
from app.tools.lateness import follow_late
from app.viewpoint.camera import Ray
from app.viewpoint.events import Input
from app.workspace.workspace import Workspace
from solver.geometry.motions import moved_back
from solver.types import FloatArray

GRAZING = 1e-6  # cosine below which a ray counts as parallel to the plane
STILL = 1e-5  # in diagonals, far below a pixel: the cursor has not moved


class Drag:
    """Moves one handle by the point it was grabbed at.

    While the solver is still binding the handle keeps its orientation; it finds the one of least
    energy when the bind is there, even if the drag is over by then.

    key: of the handle.  start: (3,) where it was grabbed.
    """

    drags: ClassVar[bool] = True

    def __init__(self, work: Workspace, press: Input, key: int, start: FloatArray) -> None:
        self.work = work
        self.key = key
        self.gesture = Gesture(work.document)
        self._done: tuple[object, ...] = ()
        self._goal: FloatArray | None = None  # (3,) the last target, None before the first
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
        turns = work.turn and not self.early
        asked = (work.surface.bound, turns, *target)
        if asked == self._done:  # the cursor rests
            return
        self._done, self._goal = asked, target
        transform = self._turned(self.key, target) if turns else self._shifted(target)
        self.gesture.change("pose", self._posed(self.key, transform))

    def finish(self) -> None:
        """Keep the drag as one entry of the history."""
        handle, early = self.work.document.find(self.key), self.gesture.started and self.early
        assert handle is not None
        self.work.history.record(self.gesture.finish(f"Drag {handle.name}"))
        if early:
            self.follow_later(self.key)

    @property
    def early(self) -> bool:
        """Whether the solver has not bound the handle yet."""
        return not self.work.surface.holds(self.key)

    def follow_later(self, key: int) -> None:
        """Tell it, and let the handle turn by itself when the bind is there."""
        work, goal = self.work, self._goal

        def turned() -> Pose:
            assert goal is not None
            return self._posed(key, self._turned(key, goal))

        follow_late(work, [key], turned if work.turn and goal is not None else None)

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

    def _posed(self, key: int, transform: FloatArray) -> Pose:
        """With one handle elsewhere, and what mirrors it."""
        return self.work.mirrored(self.work.document.pose.moved(key, transform), [key])

    def _turned(self, key: int, target: FloatArray) -> FloatArray:
        work = self.work
        return work.surface.orient(work.document, key, self._grabbed, target)

    def _shifted(self, target: FloatArray) -> FloatArray:
        transform = self.work.document.pose.of(self.key).copy()
        transform[:3, 3] = target - transform[:3, :3] @ self._grabbed
        return transform
