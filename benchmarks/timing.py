"""Median times of tasks."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from statistics import median


def _nothing() -> None:
    pass


@dataclass(frozen=True)
class Task:
    """Something to time. repeats: of a short one in each round.  before: not timed."""

    call: Callable[[], object]
    repeats: int = 1
    before: Callable[[], object] = _nothing

    def seconds(self) -> float:
        self.before()
        times = []
        for _ in range(self.repeats):
            start = time.perf_counter()
            self.call()
            times.append(time.perf_counter() - start)
        return median(times)


def seconds(call: Callable[[], object], rounds: int) -> float:
    """Median time of `call`, after one run to warm up."""
    call()
    return Task(call, rounds).seconds()


def medians(tasks: Mapping[str, Task], rounds: int) -> dict[str, float]:
    """Median seconds of each task over rounds of all of them in their order.

    Whatever else the machine does for a while then weighs on all of them alike.
    """
    times = [{name: task.seconds() for name, task in tasks.items()} for _ in range(rounds)]
    return {name: median(row[name] for row in times) for name in tasks}
