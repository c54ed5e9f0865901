"""One deformation of a mesh, what other methods make of it, and how results are judged."""

from __future__ import annotations

from dataclasses import dataclass, field

import igl
import numpy as np

from solver import Deformer
from solver.geometry.bounding_box import diagonal
from solver.geometry.motions import moved
from solver.measure.quality import Quality, broken_triangles, quality
from solver.measure.sections import Fold, Limb
from solver.types import BoolArray, FloatArray, IntArray

ARAP_ITERATIONS = 100
# The band in which a limb's bend is looked for, half its width in diagonals.
BAND = 0.1


@dataclass(frozen=True)
class Case:
    """One deformation: handles[h] moves by transforms[h], `fixed` stays.

    published: results of other methods by name. limb, joint: of a folded arm.
    """

    name: str
    V: FloatArray
    F: IntArray
    fixed: IntArray
    handles: list[IntArray]
    transforms: list[FloatArray]
    softness: FloatArray | None = None
    published: dict[str, FloatArray] = field(default_factory=dict)
    limb: Limb | None = None
    joint: float = 0.0

    @property
    def free(self) -> BoolArray:
        free = np.ones(len(self.V), dtype=bool)
        free[np.concatenate((self.fixed, *self.handles))] = False
        return free

    @property
    def diagonal(self) -> float:
        return diagonal(self.V)

    def deformer(self, **options: object) -> Deformer:
        return Deformer(self.V, self.F, self.fixed, self.handles, self.softness, **options)  # type: ignore[arg-type]

    def targets(self) -> tuple[IntArray, FloatArray]:
        """The constrained vertices and where they go."""
        goals = [self.V[self.fixed]]
        goals += [moved(T, self.V[h]) for T, h in zip(self.transforms, self.handles, strict=True)]
        return np.concatenate((self.fixed, *self.handles)), np.concatenate(goals)

    def arap(self, iterations: int = ARAP_ITERATIONS) -> FloatArray:
        """libigl's as-rigid-as-possible, spokes and rims, from the biharmonic result."""
        held, goals = self.targets()
        data = igl.ARAPData()
        data.max_iter = iterations
        data.energy = igl.ARAPEnergyType.ARAP_ENERGY_TYPE_SPOKES_AND_RIMS
        igl.arap_precomputation(self.V, self.F, 3, held.astype(np.int32), data)
        X: FloatArray = igl.arap_solve(goals, data, self.harmonic())
        return X

    def harmonic(self, order: int = 2) -> FloatArray:
        """k-harmonic displacements."""
        held, goals = self.targets()
        D: FloatArray = igl.harmonic(self.V, self.F, held, goals - self.V[held], order)
        return self.V + D

    def quality(self, X: FloatArray) -> Quality:
        """Of the result X, (n, 3)."""
        return quality(self.V, self.F, self.free, X)

    def broken(self, X: FloatArray) -> int:
        """Collapsed and inverted triangles of X, (n, 3)."""
        return broken_triangles(self.V, self.F, self.free, X)

    def fold(self, X: FloatArray) -> Fold:
        """Of X, (n, 3), where the case has a limb: within BAND of its joint."""
        assert self.limb is not None
        return self.limb.fold(X, self.joint, BAND * self.diagonal)
