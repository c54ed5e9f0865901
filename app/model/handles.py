"""Handles: which regions of a mesh move, and a pose, which says where they are."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

import numpy as np

from solver.types import FloatArray

# The roles of vertices. A handle's key is the role of its vertices.
FREE, FIXED, FIRST_HANDLE = 0, 1, 2
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
    """

    transforms: Mapping[int, FloatArray] = field(default_factory=dict)

    def of(self, key: int) -> FloatArray:
        """The transform of a handle, (4, 4)."""
        return self.transforms.get(key, np.eye(4))

    def stacked(self, keys: Iterable[int]) -> FloatArray:
        """(h, 4, 4): those of some handles."""
        return np.array([self.of(key) for key in keys]).reshape(-1, 4, 4)

    def moved(self, key: int, transform: FloatArray) -> Pose:
        """Another pose, with one handle elsewhere."""
        return Pose({**self.transforms, key: transform})

    def without(self, key: int) -> Pose:
        """Another pose, with one handle at rest."""
        return Pose({k: T for k, T in self.transforms.items() if k != key})

    @property
    def at_rest(self) -> bool:
        """Whether every handle is where it was."""
        return all(np.array_equal(T, np.eye(4)) for T in self.transforms.values())

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Pose):
            return NotImplemented
        keys = {**self.transforms, **other.transforms}
        return all(np.array_equal(self.of(key), other.of(key)) for key in keys)
