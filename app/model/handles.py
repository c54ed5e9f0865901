"""Handles: which regions of a mesh move, and a pose, which says where they are."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

import numpy as np

from solver.geometry.procrustes import decided
from solver.geometry.turns import nearest_turn
from solver.types import FloatArray

# The roles of vertices. A handle's key is the role of its vertices.
FREE, FIXED, FIRST_HANDLE = 0, 1, 2
NO_TURN = np.zeros(3)
GRAB = -1  # the key of what is grabbed softly: it has no vertices of its own


@dataclass(frozen=True)
class Handle:
    """A named region that moves as one. `key`, FIRST_HANDLE or more, stays as long as the mesh.

    pin: whether it is a spot that a click put there, not a painted region.
    """

    key: int
    name: str
    pin: bool = False


@dataclass(frozen=True, eq=False)
class Pose:
    """Where handles are: for a key the transform, (4, 4), from rest to there, world coordinates.

    A handle that is not named is at rest. Compared by content; arrays are never written to.
    turns: (3,) for a key the turn [solver.geometry.turns] that took the handle there: its
    exponential is the rotation of the transform. One that is not named turned the shorter way.
    """

    transforms: Mapping[int, FloatArray] = field(default_factory=dict)
    turns: Mapping[int, FloatArray] = field(default_factory=dict)

    def of(self, key: int) -> FloatArray:
        """The transform of a handle, (4, 4)."""
        return self.transforms.get(key, np.eye(4))

    def stacked(self, keys: Iterable[int]) -> FloatArray:
        """(h, 4, 4): those of some handles."""
        return np.array([self.of(key) for key in keys]).reshape(-1, 4, 4)

    def turn(self, key: int) -> FloatArray:
        """The turn of a handle, (3,) in radians."""
        turn = self.turns.get(key)
        return nearest_turn(rotation_of(self.of(key)), NO_TURN) if turn is None else turn

    def moved(self, key: int, transform: FloatArray, near: FloatArray | None = None) -> Pose:
        """Another pose, with one handle elsewhere.

        near: (3,) about what its turn is there; as it was, where a motion goes on from frame to
        frame.
        """
        rotation = rotation_of(transform)
        turn = nearest_turn(rotation, self.turn(key) if near is None else near)
        return Pose({**self.transforms, key: transform}, {**self.turns, key: turn})

    def without(self, key: int) -> Pose:
        """Another pose, with one handle at rest."""
        left = (
            {k: value for k, value in values.items() if k != key}
            for values in (self.transforms, self.turns)
        )
        return Pose(*left)

    @property
    def at_rest(self) -> bool:
        """Whether every handle is where it was."""
        return all(np.array_equal(T, np.eye(4)) for T in self.transforms.values())

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Pose):
            return NotImplemented
        keys = {**self.transforms, **other.transforms}
        turned = {**self.turns, **other.turns}
        return all(np.array_equal(self.of(key), other.of(key)) for key in keys) and all(
            np.array_equal(self.turn(key), other.turn(key)) for key in turned
        )


def rotation_of(transform: FloatArray) -> FloatArray:
    """R, (3, 3): the rotation nearest to the linear part of a transform (4, 4)."""
    A = transform[:3, :3]
    return decided(A.T / (float(np.abs(A).max()) or 1.0))  # squares of what a file has may overflow
