"""What the softness brush leaves on the vertices it touches, in each of its modes."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from app.model.history import Gesture
from app.tools.marks import Marks, Paint
from app.workspace.workspace import Workspace
from solver.types import FloatArray, IntArray

# Where the brush is at least this strong (half its radius) a stroke pins what it paints: its rim,
# where little was painted, is what a fill is there to decide.
PINNING = 0.5
# Vertices under the brush for each round of smoothing: an area that holds four times as many needs
# four times the rounds to become as smooth, so that a fine mesh takes no more strokes.
A_ROUND, MOST_ROUNDS = 25, 100

Target = Callable[[FloatArray, float], FloatArray]


class SoftnessPaint:
    """s = s0 + strength w (target - s0), with w the largest weight the stroke gave the vertex.

    target: of the softness before and the brush's value, what strength 1 makes of it.
    """

    def __init__(self, work: Workspace, label: str, target: Target) -> None:
        self.label = label
        self._target = target
        self._value = work.brush.value
        self._strength = work.brush.strength
        self._before = work.document.softness.copy()
        self._weights = np.zeros(len(self._before))

    def dab(self, gesture: Gesture, vertices: IntArray, weights: FloatArray) -> None:
        """Only the vertices where the weight has grown."""
        grown = vertices[weights > self._weights[vertices]]
        self._weights[vertices] = np.maximum(self._weights[vertices], weights)
        before, amount = self._before[grown], self._strength * self._weights[grown]
        target = self._target(before, self._value)
        gesture.change("softness", np.clip(before + amount * (target - before), 0, 1), grown)
        self._pin(gesture, vertices, weights)

    def _pin(self, gesture: Gesture, vertices: IntArray, weights: FloatArray) -> None:
        gesture.change("pinned", True, vertices[weights >= PINNING * weights.max(initial=0.0)])

    def finish(self, gesture: Gesture) -> None:
        """Nothing is left to do."""


class SoftnessEraser(SoftnessPaint):
    """Towards 0, and nothing it touches stays pinned."""

    def __init__(self, work: Workspace) -> None:
        super().__init__(work, "Erase softness", lambda before, value: np.zeros_like(before))

    def _pin(self, gesture: Gesture, vertices: IntArray, weights: FloatArray) -> None:
        gesture.change("pinned", False, vertices)


class SoftnessSmoothing:
    """Moves softness towards the mean of the neighbours, the more the longer it is rubbed.

    Pins stay pins, at what becomes of their softness.
    """

    label = "Smooth softness"

    def __init__(self, work: Workspace) -> None:
        self._work = work
        self._strength = work.brush.strength

    def dab(self, gesture: Gesture, vertices: IntArray, weights: FloatArray) -> None:
        """The stronger towards the middle of the brush."""
        rounds = min(1 + len(vertices) // A_ROUND, MOST_ROUNDS)
        amounts = self._strength * weights
        softness = self._work.document.softness
        smooth = self._work.neighbours.smoothed(softness, vertices, amounts, rounds)
        gesture.change("softness", smooth, vertices)

    def finish(self, gesture: Gesture) -> None:
        """Nothing is left to do."""


def _painting(label: str, target: Target) -> Callable[[Workspace], Paint]:
    return lambda work: SoftnessPaint(work, label, target)


# What a softness stroke does, by the mode of the brush.
SOFTNESS_MODES: dict[str, Callable[[Workspace], Paint]] = {
    "set": _painting("Paint softness", lambda before, value: np.full_like(before, value)),
    "add": _painting("Add softness", lambda before, value: before + value),
    "subtract": _painting("Subtract softness", lambda before, value: before - value),
    "smooth": SoftnessSmoothing,
}


def _softness_paint(work: Workspace, erase: bool, gesture: Gesture) -> Paint:
    """In the mode of the brush."""
    return SoftnessEraser(work) if erase else SOFTNESS_MODES[work.brush.mode](work)


SOFTNESS_MARKS = Marks(
    _softness_paint,
    lambda work: work.document.softness > 0,
    lambda work: np.ones(len(work.document.softness), dtype=bool),
)
