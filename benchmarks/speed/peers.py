"""What other programs take for the same task."""

from __future__ import annotations

from statistics import median
from typing import Any

import igl
import numpy as np
from scipy.sparse.linalg import spsolve

from benchmarks.programs import blender, cgal
from benchmarks.timing import Task
from solver import Deformer
from solver.types import FloatArray, IntArray

ITERATIONS = 10
PRECOMPUTE = "libigl ARAP, precomputation"
ARAP = f"libigl ARAP, {ITERATIONS} iterations"
CGAL_PREPROCESS = "CGAL SR-ARAP, preprocessing"
CGAL = f"CGAL SR-ARAP, {ITERATIONS} iterations"
BLENDER_BIND = "Blender's Laplacian Deform, bind"
BLENDER = f"Blender's Laplacian Deform, {ITERATIONS} iterations"
HARMONIC = "libigl harmonic, k = 2"
PAPER = "SciPy spsolve of the paper's system, every drag"


class Arap:
    """libigl's as-rigid-as-possible deformation; goal: (len(held), 3) where `held` has to go."""

    def __init__(self, V: FloatArray, F: IntArray, held: IntArray, goal: FloatArray) -> None:
        self._V, self._F, self._held, self._goal = V, F, held, goal
        self._data: Any = None

    def precompute(self) -> None:
        self._data = igl.ARAPData()
        self._data.max_iter = ITERATIONS
        igl.arap_precomputation(self._V, self._F, 3, self._held, self._data)

    def solve(self) -> None:
        igl.arap_solve(self._goal, self._data, self._V)

    def tasks(self) -> dict[str, Task]:
        return {PRECOMPUTE: Task(self.precompute), ARAP: Task(self.solve)}


def harmonic(V: FloatArray, F: IntArray, held: IntArray, goal: FloatArray) -> dict[str, Task]:
    """libigl's biharmonic deformation, factorisation included."""
    return {HARMONIC: Task(lambda: igl.harmonic(V, F, held, goal - V[held], 2))}


def programs(
    V: FloatArray, F: IntArray, held: IntArray, goal: FloatArray, rounds: int
) -> dict[str, float]:
    """CGAL's and Blender's, in seconds; what is not installed is left out."""
    times: dict[str, float] = {}
    for deform, before, each in (
        (cgal.deform, CGAL_PREPROCESS, CGAL),
        (blender.deform, BLENDER_BIND, BLENDER),
    ):
        runs = [deform(V, F, held, goal, ITERATIONS) for _ in range(rounds)]
        found = [run for run in runs if run is not None]
        if found:
            times[before] = median(run.preprocessing for run in found)
            times[each] = median(run.deformation for run in found)
    return times


def paper(deformer: Deformer) -> dict[str, Task]:
    """The paper's way: assembled once, the sparse system is solved anew for every drag."""
    system = deformer.system
    A = system.matrix()[system.free][:, system.free].tocsc()
    B = np.random.default_rng(0).normal(size=(len(system.free), 3))
    return {PAPER: Task(lambda: spsolve(A, B))}
