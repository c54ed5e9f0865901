"""Results as Markdown."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Protocol, TypeVar

from benchmarks.speed import goals
from benchmarks.speed.backends import Comparison
from benchmarks.speed.steps import PAPER_LIMIT, Result
from benchmarks.tables import table


class Sized(Protocol):
    """What was measured on one mesh."""

    @property
    def vertices(self) -> int: ...


Measured = TypeVar("Measured", bound=Sized)


def markdown(
    results: Sequence[Result],
    comparisons: Sequence[Comparison],
    machine: str,
    plot: str | None,
) -> str:
    """The whole report. plot: the picture's file beside it, if there is one."""
    judged = min(results, key=lambda result: abs(result.vertices - goals.JUDGED))
    sections = [
        "# Benchmarks",
        "Written by `python -m benchmarks`. What it means: `docs/performance.md`.",
        machine,
        "The mannequin, decimated and subdivided, fixed below the waist, with one hand as handle."
        " Medians; each size\nin a process of its own.",
        "## Goals",
        f"Ratios at {judged.vertices:,} vertices. What the window does meanwhile is measured by "
        "`python -m benchmarks.window`.",
        table(["what", "measured", "goal", "reached"], goals.rows(results)),
        "## Times, ms",
        _by_size(results, lambda result: result.times, _milliseconds),
        "Unknowns that are free, each in three columns: "
        + ", ".join(f"{result.free:,}" for result in results)
        + f".\nSciPy's `spsolve` is left out above {PAPER_LIMIT:,} vertices: it takes too long.",
        *([f"![time against vertices]({plot})"] if plot else []),
        "## Parts of a bind from scratch, ms",
        _by_size(results, lambda result: result.parts, _milliseconds),
        "## Peak memory, MB",
        _by_size(results, lambda result: result.memory, lambda size: f"{size / 1e6:.0f}"),
        *(_libraries(comparisons) if comparisons else []),
    ]
    return "\n\n".join(sections) + "\n"


def _by_size(
    results: Sequence[Measured],
    values: Callable[[Measured], dict[str, float]],
    show: Callable[[float], str],
) -> str:
    """A row for each name that any size has, a column for each size."""
    names = dict.fromkeys(name for result in results for name in values(result))
    if not names:
        return "n/a: this system does not say."
    head = ["", *(f"{result.vertices:,} vertices" for result in results)]
    rows = []
    for name in names:
        found = [values(result).get(name) for result in results]
        rows.append([name, *("-" if value is None else show(value) for value in found)])
    return table(head, rows)


def _libraries(comparisons: Sequence[Comparison]) -> list[str]:
    return [
        "## Libraries that factorise, ms",
        _by_size(comparisons, lambda comparison: comparison.times, _milliseconds),
        "The largest difference from the surface of the first, in diagonals:",
        _by_size(comparisons, lambda comparison: comparison.difference, lambda d: f"{d:.1e}"),
    ]


def _milliseconds(seconds: float) -> str:
    return f"{1e3 * seconds:.3f}" if seconds < 0.01 else f"{1e3 * seconds:.1f}"
