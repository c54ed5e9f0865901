"""Coarse frames against the exact solution: `python -m benchmarks.coarse` prints all tables."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import igl
import numpy as np
import scipy.sparse as sp

from benchmarks.cases.assets import all_cases
from benchmarks.cases.case import Case
from benchmarks.tables import table
from benchmarks.timing import seconds
from solver import Deformer, Setup
from solver.measure.distortion import Distortion
from solver.types import FloatArray

# A mesh of so many vertices is measured as it is, with COARSE_SMALL; then subdivided, with COARSE.
SMALL, COARSE_SMALL, LARGE, COARSE = 4000, 2000, 20000, 5000


def refined(case: Case) -> Case:
    """The case on a mesh subdivided until it has LARGE vertices; what lies between held is held."""
    V, F = np.array(case.V), np.array(case.F)
    held = [np.isin(np.arange(len(V)), part) * 1.0 for part in (case.fixed, *case.handles)]
    softness = np.zeros(len(V)) if case.softness is None else case.softness
    while len(V) < LARGE:
        S, finer = igl.upsample_matrix(F, len(V))
        S = sp.csr_array(S)
        softness, held = S @ softness, [(S @ part > 0.999) * 1.0 for part in held]
        V, F = np.asarray(igl.loop(V, F)[0]), np.asarray(finer, dtype=np.int64)
    fixed, *handles = (np.flatnonzero(part) for part in held)
    soft = None if case.softness is None else softness
    return Case(case.name, V, F, fixed, handles, case.transforms, soft)


def measures(case: Case, distortion: Distortion, X: FloatArray) -> FloatArray:
    """Strain rms, dihedral rms and the largest dihedral change in degrees."""
    free = case.free
    bend = distortion.dihedral(X, free)
    largest = bend.elements[free[distortion.hinges].any(axis=1)].max()
    return np.array([distortion.strain(X, free).rms, np.degrees(bend.rms), np.degrees(largest)])


def rows(case: Case, count: int, level: int) -> list[str]:
    """One case: exact measures, what the coarse solution has of them, how far apart, times."""
    exact, coarse = case.deformer(), case.deformer(coarse=count)
    distortion = Distortion(case.V, case.F)
    X, Y = (bound.pose(case.transforms, level) for bound in (exact, coarse))
    one, two = measures(case, distortion, X), measures(case, distortion, Y)
    apart = 100 * np.sqrt(((X - Y) ** 2).sum(axis=1).mean()) / case.diagonal
    times = [1000 * seconds(lambda b=b: b.pose(case.transforms, level), 3) for b in (exact, coarse)]  # type: ignore[misc]
    return [
        case.name,
        f"{len(case.V)}",
        f"{count}",
        f"{one[0]:.3f} / {one[1]:.2f} / {one[2]:.1f}",
        *(f"{ratio:.2f}" for ratio in two / one),
        f"{apart:.2f} %",
        f"{times[0]:.1f}",
        f"{times[1]:.1f}",
    ]


def cases() -> Iterator[tuple[Case, int]]:
    for case in all_cases():
        if len(case.V) > SMALL:
            yield case, COARSE_SMALL
        yield refined(case), COARSE


def costs(case: Case) -> list[str]:
    """What a handle and a frame cost against libigl's as-rigid-as-possible."""
    held, goals = case.targets()
    data = igl.ARAPData()
    data.max_iter = 1
    fields: tuple[Any, ...] = case.V, case.F, 3, held.astype(np.int32), data
    precompute = seconds(lambda: igl.arap_precomputation(*fields), 3)
    iteration = seconds(lambda: igl.arap_solve(goals, data, case.V), 3)
    idle = Deformer(case.V, case.F, coarse=COARSE)
    setup = Setup(case.fixed, case.handles, case.softness, coarse=COARSE)
    bound = idle.rebound(setup)
    bind = seconds(lambda: idle.rebound(setup).drag_model, 3)
    drag, frame = (seconds(lambda r=r: bound.pose(case.transforms, r), 5) for r in (0, 4))  # type: ignore[misc]
    return [
        case.name,
        f"{len(case.V)}",
        f"{1000 * bind:.0f}",
        f"{bind / precompute:.2f}",
        f"{1000 * drag:.2f}",
        f"{drag / iteration:.3f}",
        f"{1000 * frame:.0f}",
        f"{frame / iteration:.2f}",
    ]


def main() -> None:
    head = ["case", "vertices", "coarse", "exact", "strain", "dihedral", "largest", "apart"]
    for level in (4, 0):
        print(f"\nLevel {level}: strain, dihedral rms and largest in degrees; then ratios\n")
        lines = [rows(case, count, level) for case, count in cases()]
        print(table([*head, "ms exact", "ms coarse"], lines))
    print("\nA new handle and frames, ms, and against libigl's precomputation and iteration\n")
    head = ["case", "vertices", "bind", "of libigl", "level 0", "of one", "level 4", "of one"]
    print(table(head, [costs(refined(case)) for case in all_cases()]))


if __name__ == "__main__":
    main()
