"""What the tools that mark vertices leave on them: under a brush, or on many at once."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import ClassVar, Protocol

import numpy as np

from app.model.history import Gesture
from app.viewpoint.events import Input
from app.workspace.workspace import Workspace
from solver.types import BoolArray, FloatArray, IntArray


class Paint(Protocol):
    """What a stroke leaves on the vertices it touches. label: its entry in the history."""

    label: str

    def dab(self, gesture: Gesture, vertices: IntArray, weights: FloatArray) -> None:
        """Change the document under the brush."""

    def finish(self, gesture: Gesture) -> None:
        """What is left to do when the stroke ends."""


@dataclass(frozen=True)
class Marks:
    """What a tool marks.

    paint: what marks vertices or, where it is to erase, unmarks them; it may begin with a change.
    marked: (n,) which are.  free: (n,) which a command may mark that takes none from another.
    across: what paints across the mirror, told whether both sides meet; None for the same paint.
    """

    paint: Callable[[Workspace, bool, Gesture], Paint]
    marked: Callable[[Workspace], BoolArray]
    free: Callable[[Workspace], BoolArray]
    across: Callable[[Workspace, Gesture, bool], Paint | None] = lambda work, gesture, meets: None

    def leave(
        self, work: Workspace, gesture: Gesture, vertices: IntArray, erase: bool = False
    ) -> str:
        """Mark or unmark vertices, and across the mirror; what the history calls it."""
        if len(vertices) == 0:
            return ""
        paint = self.paint(work, erase, gesture)
        sides = [(paint, vertices)]
        if work.symmetry is not None:
            image = work.symmetry.image(vertices)
            beyond = np.setdiff1d(image, vertices)
            other = None if erase else self.across(work, gesture, len(beyond) < len(image))
            sides.append((other or paint, beyond))
        for one, marked in sides:
            one.dab(gesture, marked, np.ones(len(marked)))
        for one in {id(one): one for one, _ in sides}.values():
            one.finish(gesture)
        return paint.label


class Mark:
    """A click that marks vertices at once; none of them is still a click, and no orbit begins."""

    drags: ClassVar[bool] = False

    def __init__(self, work: Workspace, press: Input, marks: Marks, vertices: IntArray) -> None:
        self._work = work
        self._gesture = Gesture(work.document)
        self._label = marks.leave(work, self._gesture, vertices, press.shift)

    def move(self, frame: Input) -> None:
        """What is marked stays what it is."""

    def finish(self) -> None:
        """Keep it as one entry of the history."""
        self._work.history.record(self._gesture.finish(self._label))

    def cancel(self) -> None:
        """Take it back."""
        self._gesture.cancel()
