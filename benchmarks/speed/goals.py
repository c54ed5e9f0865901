"""What is to be reached, and whether it is."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from benchmarks.speed import peers, steps
from benchmarks.speed.steps import Result

JUDGED = 60_000  # the vertices at which ratios are judged


@dataclass(frozen=True)
class Goal:
    """A ratio of two times on one mesh, with its limit.

    share: what part of `whole` counts, where that is several iterations.
    """

    what: str
    part: str
    whole: str
    limit: float
    least: bool = False
    share: float = 1.0

    def row(self, times: dict[str, float]) -> list[str]:
        ratio = times[self.part] / (self.share * times[self.whole])
        reached = ratio >= self.limit if self.least else ratio <= self.limit
        return [self.what, f"{ratio:.3g}", _limit(self.limit, self.least), _yes(reached)]

    def known(self, times: dict[str, float]) -> bool:
        """Whether both were measured: not every program is installed, nor every size coarse."""
        return self.part in times and self.whole in times


ONE = 1 / peers.ITERATIONS
RATIOS = (
    Goal(
        "bind from scratch / libigl's ARAP precomputation", steps.BIND, peers.PRECOMPUTE, limit=1.5
    ),
    Goal("rebind after a softness stroke / bind", steps.SOFTNESS, steps.BIND, limit=0.5),
    Goal("rebind after a handle stroke / bind", steps.HANDLE, steps.BIND, limit=0.8),
    Goal(
        f"{peers.ARAP} / drag frame (orient + pose, rigid 0)",
        peers.ARAP,
        steps.DRAG,
        limit=300,
        least=True,
    ),
    Goal(
        "back-substitution of 3 columns / drag frame",
        steps.SOLVE,
        steps.DRAG,
        limit=100,
        least=True,
    ),
    Goal("rigid-1 frame / one ARAP iteration", steps.RIGID, peers.ARAP, limit=1.0, share=ONE),
    Goal("grab / bind", steps.GRAB, steps.BIND, limit=1 / 3),
    Goal(
        "coarse frames: a new handle / libigl's ARAP precomputation",
        steps.COARSE_HANDLE,
        peers.PRECOMPUTE,
        limit=0.5,
    ),
    Goal(
        "coarse frames: a new handle / CGAL's preprocessing",
        steps.COARSE_HANDLE,
        peers.CGAL_PREPROCESS,
        limit=1.0,
    ),
    Goal(
        "coarse frames: rigid-4 frame / one ARAP iteration",
        steps.COARSE_SETTLED,
        peers.ARAP,
        limit=1.5,
        share=ONE,
    ),
    Goal(
        "coarse frames: drag frame / one ARAP iteration",
        steps.COARSE_DRAG,
        peers.ARAP,
        limit=0.1,
        share=ONE,
    ),
)
# Linear is an exponent of 1; a measured one scatters about it.
GROWTH = {steps.DRAG: 1.1, steps.BIND: 1.35}
MEMORY_GROWTH = 1.15


def rows(results: Sequence[Result]) -> list[list[str]]:
    """Goal, what was measured, limit, and whether it is reached."""
    judged = min(results, key=lambda result: abs(result.vertices - JUDGED))
    found = [goal.row(judged.times) for goal in RATIOS if goal.known(judged.times)]
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
