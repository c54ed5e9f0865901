"""What is to be reached, and whether it is."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from benchmarks.speed import peers, steps
from benchmarks.speed.steps import Result

JUDGED = 60_000  # the vertices at which ratios are judged


@dataclass(frozen=True)
class Goal:
    """A ratio of two times on one mesh, with its limit."""

    what: str
    ratio: Callable[[dict[str, float]], float]
    limit: float
    least: bool = False

    def row(self, times: dict[str, float]) -> list[str]:
        ratio = self.ratio(times)
        reached = ratio >= self.limit if self.least else ratio <= self.limit
        return [self.what, f"{ratio:.3g}", _limit(self.limit, self.least), _yes(reached)]


RATIOS = (
    Goal(
        "bind from scratch / libigl's ARAP precomputation",
        lambda t: t[steps.BIND] / t[peers.PRECOMPUTE],
        1.5,
    ),
    Goal("rebind after a softness stroke / bind", lambda t: t[steps.SOFTNESS] / t[steps.BIND], 0.5),
    Goal("rebind after a handle stroke / bind", lambda t: t[steps.HANDLE] / t[steps.BIND], 0.8),
    Goal(
        f"{peers.ARAP} / drag frame (orient + pose, rigid 0)",
        lambda t: t[peers.ARAP] / t[steps.DRAG],
        300,
        least=True,
    ),
    Goal(
        "back-substitution of 3 columns / drag frame",
        lambda t: t[steps.SOLVE] / t[steps.DRAG],
        100,
        least=True,
    ),
    Goal(
        "rigid-1 frame / one ARAP iteration",
        lambda t: t[steps.RIGID] / (t[peers.ARAP] / peers.ITERATIONS),
        1.0,
    ),
    Goal("grab / bind", lambda t: t[steps.GRAB] / t[steps.BIND], 1 / 3),
)
# Linear is an exponent of 1; a measured one scatters about it.
GROWTH = {steps.DRAG: 1.1, steps.BIND: 1.35}
MEMORY_GROWTH = 1.15


def rows(results: Sequence[Result]) -> list[list[str]]:
    """Goal, what was measured, limit, and whether it is reached."""
    judged = min(results, key=lambda result: abs(result.vertices - JUDGED))
    found = [goal.row(judged.times) for goal in RATIOS]
    sizes = [result.vertices for result in results]
    if len(set(sizes)) < 2:
        return found
    for step, limit in GROWTH.items():
        times = [result.times[step] for result in results]
        found.append(_growth(step, sizes, times, limit))
    memory = [
        result.memory[steps.ONE] - result.memory[steps.START] for result in results if result.memory
    ]
    if len(memory) == len(results) and min(memory) > 0:
        found.append(_growth("memory that a bind adds", sizes, memory, MEMORY_GROWTH))
    return found


def exponent(sizes: Sequence[int], values: Sequence[float]) -> float:
    """k of the best fit values = c sizes^k on logarithmic axes."""
    return float(np.polyfit(np.log(sizes), np.log(values), 1)[0])


def _growth(what: str, sizes: Sequence[int], values: Sequence[float], limit: float) -> list[str]:
    k = exponent(sizes, values)
    return [f"exponent of growth: {what}", f"{k:.2f}", _limit(limit, False), _yes(k <= limit)]


def _limit(limit: float, least: bool) -> str:
    return f"{'at least' if least else 'at most'} {limit:.3g}"


def _yes(reached: bool) -> str:
    return "yes" if reached else "**no**"
