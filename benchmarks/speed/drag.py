"""What a drag costs on the mannequin of the default session: `python -m benchmarks.speed.drag`."""

from __future__ import annotations

import numpy as np

from benchmarks.cases.assets import folded_mannequin
from benchmarks.cases.case import Case
from benchmarks.cases.mannequin import drag_of, dragged
from benchmarks.speed.peers import Arap
from benchmarks.tables import table
from benchmarks.timing import medians, seconds
from solver.types import FloatArray

GOAL = 20.0


def measure(case: Case) -> dict[str, float]:
    """Seconds of every step."""
    deformer = case.deformer()
    grabbed, target = drag_of(case.V, case.handles[0])
    start = [np.eye(4)]
    T = deformer.orient(0, grabbed, target, start)
    factor, free = deformer.system.factor, len(deformer.system.free)
    assert case.softness is not None
    other = case.softness**2
    columns = np.random.default_rng(0).normal(size=(free, 3))

    def drag() -> FloatArray:
        return deformer.pose([deformer.orient(0, grabbed, target, start)])

    return {
        "bind": seconds(case.deformer, 5),
        "rebind another softness": seconds(lambda: deformer.rebind(softness=other), 5),
        "back-substitution, 3 columns": seconds(lambda: factor.solve(columns), 50),
        "pose, rigid 0": seconds(lambda: deformer.pose([T]), 200),
        "orient": seconds(lambda: deformer.orient(0, grabbed, target, start), 200),
        "orient + pose, rigid 0": seconds(drag, 200),
        "pose, rigid 1": seconds(lambda: deformer.pose([T], rigid=1), 50),
    }


def measure_arap(case: Case) -> dict[str, float]:
    """Seconds of libigl's as-rigid-as-possible deformation under the same constraints."""
    held, goal = dragged(case.V, case.fixed, case.handles[0])
    return medians(Arap(case.V, case.F, held, goal).tasks(), 3)


def main() -> None:
    case = folded_mannequin()
    times = measure(case) | measure_arap(case)
    n, m = len(case.V), len(case.F)
    print(f"mannequin: {n} vertices, {m} faces, {n - len(case.fixed)} vertices not fixed\n")
    rows = [[name, f"{1000 * t:.3f}"] for name, t in times.items()]
    print(table(["step", "median, ms"], rows))
    ratio = times["back-substitution, 3 columns"] / times["pose, rigid 0"]
    print(
        f"\nA drag frame (pose, rigid 0) is {ratio:.1f} times faster than one back-substitution "
        f"of 3 columns; the goal is {GOAL:.0f}."
    )


if __name__ == "__main__":
    main()
