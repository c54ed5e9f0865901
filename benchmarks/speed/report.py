"""Results as Markdown."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from benchmarks.speed import goals
from benchmarks.speed.steps import PAPER_LIMIT, Comparison, Result
from benchmarks.tables import table


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
        *(["## CHOLMOD and SciPy's splu", _backends(comparisons)] if comparisons else []),
    ]
    return "\n\n".join(sections) + "\n"


def _by_size(
    results: Sequence[Result],
    values: Callable[[Result], dict[str, float]],
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


def _backends(comparisons: Sequence[Comparison]) -> str:
    head = ["vertices", "bind, CHOLMOD, ms", "bind, splu, ms", "largest difference, diagonals"]
    rows = [
        [
            f"{c.vertices:,}",
            _milliseconds(c.cholmod),
            _milliseconds(c.splu),
            f"{c.difference:.1e}",
        ]
        for c in comparisons
    ]
    return table(head, rows)


def _milliseconds(seconds: float) -> str:
    return f"{1e3 * seconds:.3f}" if seconds < 0.01 else f"{1e3 * seconds:.1f}"
