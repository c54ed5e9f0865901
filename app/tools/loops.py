"""Lasso and box: a loop drawn over the scene, which takes the vertices inside it."""

from __future__ import annotations

from typing import ClassVar

import numpy as np

from app.model.history import Gesture
from app.scene.overlay import ERASING, PAINTING, Outline
from app.selection.loop import inside_loop
from app.selection.sight import in_sight
from app.tools.marks import Marks
from app.viewpoint.camera import Camera, Pixel
from app.viewpoint.events import Input
from app.workspace.workspace import Workspace
from solver.types import FloatArray, IntArray

APART = 2.0  # pixels between two corners of a lasso
SMALLEST = 3.0  # pixels: a smaller loop was a click


class Loop:
    """A loop that grows while the mouse is held, through pixels of the window.

    Wherever the camera goes meanwhile, what counts is where the vertices are seen at the end.
    """

    drags: ClassVar[bool] = False

    def __init__(self, work: Workspace, press: Input, marks: Marks) -> None:
        assert press.pixel is not None
        self._work = work
        self._marks = marks
        self._erase = press.shift
        self._camera = press.camera
        self._path: list[Pixel] = [press.pixel]

    def move(self, frame: Input) -> None:
        """Draw on to where the cursor is."""
        self._camera = frame.camera
        if frame.pixel is not None:
            self._extend(frame.pixel)

    def _extend(self, pixel: Pixel) -> None:
        if np.hypot(*np.subtract(pixel, self._path[-1])) >= APART:
            self._path.append(pixel)

    @property
    def corners(self) -> FloatArray:
        """(k, 2) pixels."""
        return np.array(self._path)

    def outline(self, camera: Camera) -> Outline:
        """What is drawn while the mouse is held."""
        points = camera.all_at_depth(self.corners, self._work.document.diagonal)
        return Outline.through(points, ERASING if self._erase else PAINTING)

    def finish(self) -> None:
        """Mark what is inside, as one entry of the history."""
        gesture = Gesture(self._work.document)
        label = self._marks.leave(self._work, gesture, self._inside(), self._erase)
        self._work.history.record(gesture.finish(label))

    def cancel(self) -> None:
        """Nothing has been marked yet."""

    def _inside(self) -> IntArray:
        work, corners = self._work, self.corners
        if np.ptp(corners, axis=0).max() < SMALLEST:
            return np.empty(0, dtype=np.int64)
        inside = inside_loop(self._camera.project(work.positions), corners)
        vertices = np.flatnonzero(inside & work.parts.visible)
        if work.marking.through:
            return vertices
        surface = work.positions, work.parts.faces
        seen = in_sight(self._camera, *surface, vertices, work.neighbours.solid)
        return vertices[seen]


class Box(Loop):
    """An upright rectangle, from where the button went down to where the cursor is."""

    def _extend(self, pixel: Pixel) -> None:
        self._path[1:] = [pixel]

    @property
    def corners(self) -> FloatArray:
        """(4, 2) pixels."""
        (left, top), (right, bottom) = self._path[0], self._path[-1]
        return np.array([(left, top), (right, top), (right, bottom), (left, bottom)])
