"""Grabbing bare surface: softly, on the factorisation that is there, until it is let go of.

A click puts a pin in its place: a small handle that holds, and can be dragged.
"""

from __future__ import annotations

import numpy as np

from app.model.handles import FREE, GRAB
from app.pointing.picking import Hit
from app.tools.drag import Drag
from app.tools.lateness import tell_early
from app.viewpoint.events import Input
from app.workspace.workspace import Workspace
from solver.geometry.procrustes import rigid_motion
from solver.types import FloatArray, IntArray

CLICK = 4.0  # pixels that the cursor may move in a click
PIN = 0.5  # the weights of the brush that become a pin: half of its radius


class Grab(Drag):
    """Drags a region softly: the best fit of what lies under the brush follows the cursor.

    It exists from the first movement on, since what has not moved may be a click.
    """

    def __init__(self, work: Workspace, press: Input, hit: Hit) -> None:
        super().__init__(work, press, GRAB, hit.position)
        self._pixel = press.pixel
        radius = work.brush_radius(hit.position, press.camera)
        vertices, weights = work.neighbours.dab(work.positions, hit, radius)
        free = work.document.role[vertices] == FREE
        self._vertices, self._weights = vertices[free], weights[free]

    def move(self, frame: Input) -> None:
        """As a drag; the first movement grabs."""
        if not self.gesture.started:
            if not self._left_the_spot(frame):
                return
            self._begin()
        super().move(frame)

    def finish(self) -> None:
        """Let go, or leave a pin: after a click, and where grabs are kept."""
        work, clicked = self.work, not self.gesture.started
        early = not clicked and self.early
        transform = None if clicked else work.document.pose.of(GRAB)
        self.gesture.cancel()
        if clicked or work.keep:
            key = put_pin(work, self._core(), transform)
            if early:
                self.follow_later(key)
        elif early:
            tell_early(work, "The solver was still binding, so nothing followed: grab once more")

    def _left_the_spot(self, frame: Input) -> bool:
        if frame.pixel is None or self._pixel is None:
            return False
        return float(np.hypot(*np.subtract(frame.pixel, self._pixel))) >= CLICK

    def _begin(self) -> None:
        document = self.work.document
        weights = np.zeros(len(document.role))
        weights[self._vertices] = self._weights
        transform = _fit(self.work, self._vertices)
        self.hold(transform)
        self.gesture.change("grab", weights)
        self.gesture.change("pose", document.pose.moved(GRAB, transform))

    def _core(self) -> IntArray:
        """What becomes a pin: at least the vertex that was hit."""
        largest = self._weights.max(initial=0.0)
        return np.sort(self._vertices[self._weights >= PIN * largest])


def put_pin(work: Workspace, vertices: IntArray, transform: FloatArray | None) -> int:
    """Vertices (k,) become a pin, at a transform (4, 4) or where they are on screen; its key."""
    document = work.document
    handle = document.new_handle(pin=True)
    with work.edit(f"Put {handle.name}") as gesture:
        gesture.change("handles", (*document.handles, handle))
        gesture.change("role", handle.key, vertices)
        placed = _fit(work, vertices) if transform is None else transform
        if not np.array_equal(placed, np.eye(4)):
            gesture.change("pose", document.pose.moved(handle.key, placed))
    work.chosen.activate(handle.key)
    return handle.key


def _fit(work: Workspace, vertices: IntArray) -> FloatArray:
    """(4, 4) the rigid motion that best takes vertices from rest to where they are on screen."""
    return rigid_motion(work.document.rest_positions[vertices], work.positions[vertices])
