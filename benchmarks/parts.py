"""Where the time of a bind goes."""

from __future__ import annotations

import cProfile
import pstats
from collections.abc import Callable
from pathlib import Path
from statistics import median

# Functions by file and name, None for one of a compiled module. No two of a row or of different
# rows run within each other, but for those taken away again.
Function = tuple[str | None, str]
SYMBOLIC: Function = (None, "<built-in method cvxopt.cholmod.symbolic>")
PARTS: dict[str, tuple[tuple[Function, ...], tuple[Function, ...]]] = {
    "connectivity": (
        (
            ("topology.py", "__init__"),
            ("topology.py", "links"),
            ("topology.py", "vertex_component"),
        ),
        (),
    ),
    "elimination order, once a mesh": ((("rest_surface.py", "elimination_order"),), ()),
    "symbolic analysis": ((SYMBOLIC,), ()),
    "places of the entries, for CHOLMOD": ((("table.py", "analyse"),), (SYMBOLIC,)),
    "numeric factorisation": (((None, "<built-in method cvxopt.cholmod.numeric>"),), ()),
    "basis: back-substitutions and products": ((("response.py", "hard_response"),), ()),
}
REST = "the rest: weights, assembly, constraints"


def profile(task: Callable[[], object], rounds: int) -> dict[str, float]:
    """Median seconds of every part of a bind; functions that are not called give no row."""
    runs = [_once(task) for _ in range(rounds + 1)][1:]
    middle = {part: median(run[part] for run in runs) for part in runs[0]}
    return {part: time for part, time in middle.items() if time > 0}


def _once(task: Callable[[], object]) -> dict[str, float]:
    profiler = cProfile.Profile()
    profiler.runcall(task)
    stats = pstats.Stats(profiler)
    times: dict[Function, float] = {}
    for (file, _, name), (_, _, _, cumulative, _) in vars(stats)["stats"].items():
        key = (None if file == "~" else Path(file).name, name)
        if key[0] is None or "solver" in Path(file).parts:
            times[key] = times.get(key, 0.0) + cumulative
    parts = {
        part: sum(times.get(f, 0.0) for f in add) - sum(times.get(f, 0.0) for f in less)
        for part, (add, less) in PARTS.items()
    }
    return parts | {REST: vars(stats)["total_tt"] - sum(parts.values())}
