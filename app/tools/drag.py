"""Dragging a handle: it follows the cursor in a plane parallel to the screen."""

from __future__ import annotations

from typing import ClassVar

import numpy as np

from app.model.handles import Handle
from app.model.history import Gesture
from app.tools.tool import on_surface
from app.viewpoint.camera import Ray
from app.viewpoint.events import Input
from app.workspace.picking import Hit
from app.workspace.workspace import Interaction, Workspace
from solver.types import FloatArray

GRAZING = 1e-6  # cosine below which a ray counts as parallel to the plane
STILL = 1e-5  # in diagonals, far below a pixel: the cursor has not moved


class Drag:
    """Moves one handle by the point it was grabbed at. Waits while the solver is still binding."""

    drags: ClassVar[bool] = True

    def __init__(self, work: Workspace, press: Input, hit: Hit, handle: Handle) -> None:
        self._work = work
        self._handle = handle
        self._gesture = Gesture(work.document)
        self._done: tuple[object, ...] = ()
        self._start = hit.position
        self._normal = press.camera.forward
        T = work.document.pose.of(handle.key)
        A, t = T[:3, :3], T[:3, 3]
        # A session file may hold any affine transform, even one that flattens.
        self._grabbed = np.linalg.pinv(A) @ (hit.position - t)

    def move(self, frame: Input) -> None:
        """Take the grabbed point to where the cursor's ray meets the plane. Raises SolverError."""
        target = None if frame.ray is None else self._target(frame.ray)
        if target is None or not self._work.surface.holds(self._handle.key):
            return
        asked = (self._work.surface.bound, self._work.turn, *target)
        if asked == self._done:  # the cursor rests
            return
        self._done = asked
        transform = self._turned(target) if self._work.turn else self._shifted(target)
        pose = self._work.document.pose.moved(self._handle.key, transform)
        self._gesture.change("pose", pose)

    def finish(self) -> None:
        """Keep the drag as one entry of the history."""
        self._work.history.record(self._gesture.finish(f"Drag {self._handle.name}"))

    def cancel(self) -> None:
        """Put the handle back."""
        self._gesture.cancel()

    def _target(self, ray: Ray) -> FloatArray | None:
        """The point of the plane under the cursor; None beside it, or while nothing has moved."""
        slope = float(ray.direction @ self._normal)
        if slope < GRAZING:
            return None
        target = ray.at(float((self._start - ray.origin) @ self._normal) / slope)
        still = np.linalg.norm(target - self._start) < STILL * self._work.document.diagonal
        # A click must not turn the handle; a handle brought back to where it was may.
        return None if still and not self._gesture.started else target

    def _turned(self, target: FloatArray) -> FloatArray:
        work = self._work
        return work.surface.orient(work.document, self._handle.key, self._grabbed, target)

    def _shifted(self, target: FloatArray) -> FloatArray:
        transform = self._work.document.pose.of(self._handle.key).copy()
        transform[:3, 3] = target - transform[:3, :3] @ self._grabbed
        return transform


@on_surface
def begin_drag(work: Workspace, press: Input, hit: Hit) -> Interaction | None:
    """A drag of the handle under the cursor, which becomes the active one."""
    document = work.document
    handle = document.find(int(document.role[hit.vertex]))
    if handle is None:
        return None
    work.activate(handle.key, alone=False)
    return Drag(work, press, hit, handle)
