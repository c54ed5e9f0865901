"""The plots of docs/quality.md."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

from benchmarks.cases.case import Case
from benchmarks.plotting import load_pyplot, save
from benchmarks.quality.study import (
    GAINS,
    LENGTHS,
    PLAIN_ROUNDS,
    SETTLED,
    Study,
    strain_and_dihedral,
)

# Colours that colour-blind readers tell apart. [Okabe & Ito]
OURS, PLAIN, OTHERS = "#0072B2", "#D55E00", "#555555"


def draw(cases: list[Case], folder: Path) -> bool:
    """Write the SVG files; False where matplotlib is missing."""
    pyplot = load_pyplot("quality")
    if pyplot is None:
        return False
    pyplot.rcParams.update({"svg.fonttype": "none", "font.size": 9})
    folder.mkdir(exist_ok=True)
    limbs = [case for case in cases if case.limb]
    plots: dict[str, list[Callable[[Any], None]]] = {
        "frontier": [partial(_frontier, case=case) for case in cases[:2]],
        "fold": [partial(_fold, case=case) for case in limbs],
        "length": [partial(_length, case=case) for case in (cases[0], limbs[0])],
        "rounds": [partial(_rounds, cases=cases)],
    }
    for name, panels in plots.items():
        size = (4.2 * max(len(panels), 1.5), 3.6)
        figure, axes = pyplot.subplots(
            1, len(panels), figsize=size, layout="constrained", squeeze=False
        )
        for axis, plot in zip(axes[0], panels, strict=True):
            plot(axis)
            axis.grid(alpha=0.3)
        save(figure, folder / f"{name}.svg")
    return True


def _frontier(axis: Any, case: Case) -> None:
    """Strain against dihedral error: every l_r, every number of plain rounds, other methods."""
    study = Study(case)
    ours = [strain_and_dihedral(case, study.refined(length, SETTLED)) for length in LENGTHS]
    plain = [
        strain_and_dihedral(case, X)
        for number, X in enumerate(study.plain(max(PLAIN_ROUNDS)), start=1)
        if number in PLAIN_ROUNDS
    ]
    _line(axis, ours, OURS, "rounds as built, by l_r", [f"{length:g}" for length in LENGTHS])
    _line(axis, plain, PLAIN, "plain rounds, by their number", [str(k) for k in PLAIN_ROUNDS])
    others = {**case.published, "ARAP": case.arap()}
    for name, X in others.items():
        strain, dihedral = strain_and_dihedral(case, X)
        axis.plot(strain, dihedral, "s", color=OTHERS, markersize=4)
        axis.annotate(
            name.split(" (")[0], (strain, dihedral), (3, -9), textcoords="offset points", fontsize=6
        )
    axis.set(xlabel="edge strain, rms", ylabel="dihedral error, rms", title=case.name)
    axis.set_yscale("log")
    axis.legend(fontsize=7)


def _fold(axis: Any, case: Case) -> None:
    """The elbow's section against the share of the bend, for gains of the soft band."""
    lines = {"rigid 1": (OTHERS, 1), "rigid 4": (OURS, 4)}
    studies = [Study(case, gain) for gain in GAINS]
    for label, (color, rounds) in lines.items():
        folds = [case.fold(study.refined(LENGTHS[3], rounds)) for study in studies]
        points = [(fold.share, fold.section) for fold in folds]
        _line(axis, points, color, label, [f"gain {gain:g}" for gain in GAINS])
    plain = list(Study(case).plain(max(PLAIN_ROUNDS)))
    folds = [case.fold(plain[k - 1]) for k in PLAIN_ROUNDS]
    points = [(fold.share, fold.section) for fold in folds]
    _line(axis, points, PLAIN, "plain rounds, gain 0.1", [str(k) for k in PLAIN_ROUNDS])
    axis.axhline(0.75, color="k", linewidth=0.6)
    axis.axvline(0.8, color="k", linewidth=0.6)
    axis.set(xlabel="share of the bend in the band", ylabel="section / rest", title=case.name)
    axis.legend(fontsize=7)


def _length(axis: Any, case: Case) -> None:
    """What l_r trades."""
    study = Study(case)
    results = [study.refined(length, SETTLED) for length in LENGTHS]
    strain, dihedral = zip(*(strain_and_dihedral(case, X) for X in results), strict=True)
    axis.semilogx(LENGTHS, strain, "o-", color=OURS, markersize=4, label="strain")
    axis.semilogx(LENGTHS, dihedral, "s-", color=PLAIN, markersize=4, label="dihedral error")
    if case.limb:
        section = [case.fold(X).section / 10 for X in results]
        axis.semilogx(LENGTHS, section, "^-", color=OTHERS, markersize=4, label="section / 10")
    axis.set(xlabel="l_r in diagonals", title=case.name)
    axis.axvline(LENGTHS[3], color="k", linewidth=0.6)
    axis.set_ylim(bottom=0)
    axis.legend(fontsize=7)


def _rounds(axis: Any, cases: list[Case]) -> None:
    """How far from settled each level is."""
    levels = range(1, 13)
    for case in cases:
        study = Study(case)
        settled = study.refined(LENGTHS[3], SETTLED)
        away = [_distance(case, study.refined(LENGTHS[3], k), settled) for k in levels]
        axis.semilogy(levels, away, ".-", label=case.name)
    axis.set(xlabel="rigid", ylabel="rms distance to the settled surface, diagonals")
    axis.legend(fontsize=6)


def _distance(case: Case, X: Any, Y: Any) -> float:
    away = (((X - Y) ** 2).sum(axis=1)[case.free]).mean() ** 0.5 / case.diagonal
    return float(max(away, 1e-9))


def _line(
    axis: Any, points: list[tuple[float, float]], color: str, label: str, names: list[str]
) -> None:
    x, y = zip(*points, strict=True)
    axis.plot(x, y, "o-", color=color, markersize=4, linewidth=1, label=label)
    for name, point in zip(names, points, strict=True):
        axis.annotate(name, point, (3, 3), textcoords="offset points", fontsize=6, color=color)
