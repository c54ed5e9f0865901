"""The mannequin at any resolution, fixed below the waist, to be dragged by a hand."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import igl
import numpy as np

from solver import load_mesh
from solver.geometry.bounding_box import diagonal
from solver.types import FloatArray, IntArray

ASSETS = Path(__file__).resolve().parents[2] / "assets"
# Below this many vertices it loses its hands.
COARSEST = 3000
# World coordinates on the mannequin.
WAIST, WRIST, FOREARM, ELBOW = 0.9, 0.755, 0.7, 0.465


@dataclass(frozen=True)
class Mannequin:
    """A mesh (n, 3), (m, 3), and what is painted on it, in world units."""

    V: FloatArray
    F: IntArray

    @staticmethod
    def make(target: int) -> Mannequin:
        """The mannequin with about `target` vertices: decimated, then subdivided [Loop 1987]."""
        mesh = load_mesh(ASSETS / "mannequin.obj")
        V, F = np.array(mesh.vertices), np.array(mesh.faces)
        times = 0
        while target / 4**times > len(V) and target / 4 ** (times + 1) > COARSEST:
            times += 1
        if target // 4**times < len(V):
            V, F = igl.qslim(V, F, 2 * (target // 4**times))[:2]
        for _ in range(times):
            V, F = igl.loop(V, F)
        return Mannequin(np.asarray(V, dtype=np.float64), np.asarray(F, dtype=np.int64))

    @property
    def fixed(self) -> IntArray:
        return np.flatnonzero(self.V[:, 1] < WAIST)

    @property
    def hand(self) -> IntArray:
        return np.flatnonzero(self.V[:, 0] > WRIST)

    @property
    def forearm(self) -> IntArray:
        """The hand after a stroke that adds some of the arm."""
        return np.flatnonzero(self.V[:, 0] > FOREARM)

    def softness(self, width: float) -> FloatArray:
        """(n,) of a soft elbow."""
        return np.exp(-(((self.V[:, 0] - ELBOW) / width) ** 2))

    @property
    def brush(self) -> FloatArray:
        """(n,) the weights of a grab at the other hand."""
        left = self.V[self.V[:, 0].argmin()]
        return np.exp(-((self.V - left) ** 2).sum(axis=1) / 0.01) * (self.V[:, 0] < 0.0)


def drag_of(V: FloatArray, hand: IntArray) -> tuple[FloatArray, FloatArray]:
    """The centre of the hand at rest, (3,), and where a drag takes it: inwards, up and forward."""
    centre: FloatArray = V[hand].mean(axis=0)
    return centre, centre + 0.15 * diagonal(V) * np.array([-1, 1, 1])


def dragged(V: FloatArray, fixed: IntArray, hand: IntArray) -> tuple[IntArray, FloatArray]:
    """The fixed vertices and the hand's, (k,), and where that drag takes them, (k, 3)."""
    held = np.concatenate([fixed, hand])
    centre, target = drag_of(V, hand)
    goal = V[held].copy()
    goal[len(fixed) :] += target - centre
    return held, goal
