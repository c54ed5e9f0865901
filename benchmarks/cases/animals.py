"""Animals at rest and in poses, with the same vertices. [Sumner & Popovic 2004]"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from benchmarks.cases.case import Case
from solver import load_mesh
from solver.geometry.motions import moved
from solver.geometry.procrustes import rigid_motion
from solver.geometry.topology import Topology, components
from solver.types import BoolArray, FloatArray, IntArray

# As shares of the height (y) and the length (z): feet are below, the head is beyond and above,
# the tail before, and a band of the trunk is fixed, above.
FEET, HEAD, CHIN, TAIL, TRUNK, BACK = 0.07, 0.87, 0.4, 0.04, (0.42, 0.62), 0.5
# A foot has at least so many vertices.
LEAST = 5


@dataclass(frozen=True)
class Animal:
    """One animal: V (n, 3), F (m, 3) at rest, poses (n, 3) each, moved so that the trunk fits."""

    name: str
    V: FloatArray
    F: IntArray
    poses: list[FloatArray]
    fixed: IntArray
    handles: list[IntArray]

    @staticmethod
    def of(name: str, V: FloatArray, F: IntArray, poses: list[FloatArray]) -> Animal:
        """Feet, head and tail are handles, a band of the trunk is fixed; y is up, z along it."""
        fixed, handles = _regions(V, F)
        placed = [moved(rigid_motion(X[fixed], V[fixed]), X) for X in poses]
        return Animal(name, V, F, placed, fixed, handles)

    @property
    def free(self) -> BoolArray:
        """(n,) what neither is fixed nor belongs to a handle."""
        free = np.ones(len(self.V), dtype=bool)
        free[np.concatenate([self.fixed, *self.handles])] = False
        return free

    def case(self, number: int, softness: FloatArray | None = None) -> Case:
        """Handles where pose `number` has them: the best rigid fit of each."""
        X = self.poses[number]
        transforms = [rigid_motion(self.V[h], X[h]) for h in self.handles]
        return Case(self.name, self.V, self.F, self.fixed, self.handles, transforms, softness)

    def away(self, number: int, X: FloatArray) -> float:
        """The rms distance of X (n, 3) to pose `number` over what is free, in % of the diagonal."""
        offset = (X - self.poses[number])[self.free]
        size = np.linalg.norm(np.ptp(self.V, axis=0))
        return float(100 * np.sqrt((offset**2).sum(axis=1).mean()) / size)


def animals(folder: Path) -> Iterator[Animal]:
    """Every NAME/NAME-reference.obj with its poses NAME-*.obj in a folder."""
    for reference in sorted(folder.glob("*/*-reference.obj")):
        name = reference.name.removesuffix("-reference.obj")
        rest = load_mesh(reference)
        paths = sorted(set(reference.parent.glob(f"{name}-*.obj")) - {reference})
        yield Animal.of(name, rest.vertices, rest.faces, [load_mesh(p).vertices for p in paths])


def _regions(V: FloatArray, F: IntArray) -> tuple[IntArray, list[IntArray]]:
    """The fixed vertices and those of each handle."""
    low, size = V.min(axis=0), np.ptp(V, axis=0)
    _, height, along = ((V - low) / size).T
    if height[along < 1 - HEAD].mean() > height[along > HEAD].mean():  # it looks the other way
        along = 1 - along
    edges = Topology(F, len(V)).edges
    part = components(edges[(height[edges] < FEET).all(axis=1)], len(V))
    feet = [np.flatnonzero((part == k) & (height < FEET)) for k in np.unique(part[height < FEET])]
    head, tail = (along > HEAD) & (height > CHIN), (along < TAIL) & (height > FEET)
    handles = [foot for foot in feet if len(foot) >= LEAST]
    handles += [np.flatnonzero(end) for end in (head, tail) if end.any()]
    trunk = (along > TRUNK[0]) & (along < TRUNK[1]) & (height > BACK)
    return np.flatnonzero(trunk), handles
