"""Where the time of a bind goes."""

from __future__ import annotations

import cProfile
import pstats
from collections.abc import Callable
from statistics import median
from types import FunctionType
from typing import Any

from solver.factor.table import analyse
from solver.geometry.topology import Topology
from solver.linear.response import hard_response
from solver.linear.rest_surface import RestSurface

Function = tuple[str, int, str]  # as the profiler names it: file, line, name


def _python(function: Any) -> Function:
    """A function, or that of a cached property."""
    plain = function if isinstance(function, FunctionType) else function.func
    code = plain.__code__
    return code.co_filename, code.co_firstlineno, code.co_name


def _compiled(name: str) -> Function:
    return "~", 0, f"<built-in method {name}>"


SYMBOLIC, NUMERIC = _compiled("cvxopt.cholmod.symbolic"), _compiled("cvxopt.cholmod.numeric")
# The time of the first functions without that of the second. No two of a row or of different rows
# run within each other, but for those taken away again.
PARTS: dict[str, tuple[tuple[Function, ...], tuple[Function, ...]]] = {
    "connectivity": (
        (
            _python(Topology.__init__),
            _python(Topology.links),
            _python(Topology.vertex_component),
        ),
        (),
    ),
    "elimination order, once a mesh": ((_python(RestSurface.elimination_order),), ()),
    "symbolic analysis": ((SYMBOLIC,), ()),
    "places of the entries, for CHOLMOD": ((_python(analyse),), (SYMBOLIC,)),
    "numeric factorisation": ((NUMERIC,), ()),
    "basis: back-substitutions and products": ((_python(hard_response),), ()),
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
    stats = vars(pstats.Stats(profiler))
    times = {function: cumulative for function, (*_, cumulative, _) in stats["stats"].items()}
    parts = {
        part: sum(times.get(f, 0.0) for f in add) - sum(times.get(f, 0.0) for f in less)
        for part, (add, less) in PARTS.items()
    }
    return parts | {REST: stats["total_tt"] - sum(parts.values())}
