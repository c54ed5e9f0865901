"""Large turns, and drags all around: what breaks, and how far the surface jumps."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace

import numpy as np

from benchmarks.cases.assets import bent_cylinder, folded_arm, folded_mannequin, twisted_bar
from benchmarks.cases.case import Case
from benchmarks.timing import seconds
from solver import Deformer
from solver.geometry.motions import moved
from solver.types import FloatArray

TURNS = (90, 120, 150, 170)
TURNED: dict[str, Callable[[float], Case]] = {
    "cylinder, bend": bent_cylinder,
    "bar, twist": twisted_bar,
    "arm, fold": folded_arm,
    "mannequin's arm, fold": folded_mannequin,
}
RINGS = (4, 7, 12, 18)
STEP = 0.01
"""Of the target in a drag, in diagonals."""


def turn_rows(rigid: int) -> list[list[str]]:
    """Broken triangles at each angle: ours / ARAP's."""
    rows = []
    for name, make in TURNED.items():
        cases = [make(degrees) for degrees in TURNS]
        deformer = cases[0].deformer()
        ours = (case.broken(deformer.pose(case.transforms, rigid)) for case in cases)
        theirs = (case.broken(case.arap()) for case in cases)
        rows.append([name, *(f"{a} / {b}" for a, b in zip(ours, theirs, strict=True))])
    return rows


def resolution_rows(rigid: int) -> list[list[str]]:
    """One bend on finer and finer triangles, and what a round costs where all of it is free."""
    rows = []
    for rings in RINGS:
        case = bent_cylinder(120, rings)
        deformer = case.deformer()
        m = case.quality(deformer.pose(case.transforms, rigid))
        # The first rounds: later ones end early on some meshes.
        two, one = (
            seconds(lambda k=k, d=deformer, c=case: d.pose(c.transforms, k), 5)  # type: ignore[misc]
            for k in (3, 2)
        )
        rows.append(
            [str(len(case.V)), f"{m.strain:.3f}", f"{m.volume:.3f}", f"{1000 * (two - one):.1f}"]
        )
    return rows


def drag_rows(rigid: int) -> list[list[str]]:
    """Of drags through `orient` in half circles around where the limb is fixed."""
    dragged = {
        "cylinder": (bent_cylinder(), [-1.6, 0, 0]),
        "arm": (folded_arm(), [0.12, 0, 0]),
        "mannequin's arm": (folded_mannequin(), [0.25, 1.425, -0.006]),
    }
    rows = []
    for name, (case, pivot) in dragged.items():
        deformer = case.deformer()
        for side in ([0, 1, 0], [0, 0, 1]):
            for reach in (0.95, 0.6):
                path = _half_circle(case, deformer, np.array(pivot), np.array(side), reach)
                rows.append(
                    [f"{name}, {'y' if side[1] else 'z'}, {reach}", *_drag(case, path, rigid)]
                )
    return rows


def _half_circle(
    case: Case, deformer: Deformer, pivot: FloatArray, side: FloatArray, reach: float
) -> Iterator[tuple[float, list[FloatArray], Deformer]]:
    """Angle, transforms and the deformer at each step, of STEP diagonals."""
    grabbed = case.V[case.handles[0]].mean(axis=0)
    radius = reach * np.linalg.norm(grabbed - pivot)
    T = np.eye(4)
    for angle in np.arange(0, np.pi, STEP * case.diagonal / radius):
        out = np.cos(angle) * np.array([1.0, 0, 0]) + np.sin(angle) * side
        T = deformer.orient(0, grabbed, pivot + radius * out, [T])
        yield float(np.degrees(angle)), [T], deformer


def _drag(
    case: Case, path: Iterator[tuple[float, list[FloatArray], Deformer]], rigid: int
) -> list[str]:
    """Largest step of the handle and of the surface, in steps of the target, up to 150 degrees
    and beyond, and the most broken triangles at once, beside ARAP's there.
    """
    steps: list[tuple[float, float, float]] = []
    before: tuple[FloatArray, FloatArray] | None = None
    worst = (0, 0.0, [np.eye(4)])
    for angle, transforms, deformer in path:
        X = deformer.pose(transforms, rigid)
        held = moved(transforms[0], case.V[case.handles[0]])
        if before is not None:
            steps.append((angle, _farthest(held, before[0]), _farthest(X, before[1])))
        before = held, X
        worst = max(worst, (case.broken(X), angle, transforms), key=lambda entry: entry[0])
    unit = STEP * case.diagonal
    early = [(a, b) for angle, a, b in steps if angle <= 150]
    late = [(a, b) for angle, a, b in steps if angle > 150]
    cells = [
        f"{max(b for _, b in part) / unit:.1f} ({max(a for a, _ in part) / unit:.1f})"
        for part in (early, late)
    ]
    arap = case.broken(replace(case, transforms=worst[2]).arap())
    return [*cells, f"{worst[0]} / {arap} at {worst[1]:.0f}"]


def _farthest(a: FloatArray, b: FloatArray) -> float:
    return float(np.linalg.norm(a - b, axis=1).max())
