"""Binds, frames and memory against size: `python -m benchmarks.speed.sizes [VERTICES ...]`."""

from __future__ import annotations

import argparse
import time
from collections.abc import Callable, Sequence

from app.model.settings import COARSE, LARGE
from app.worker.memory import OutOfMemory, check_memory
from benchmarks.cases.mannequin import Mannequin
from benchmarks.machine import peak_memory
from benchmarks.speed.__main__ import apart
from benchmarks.speed.steps import Session
from benchmarks.tables import table
from benchmarks.timing import seconds
from solver import Deformer

SIZES = 1_000, 10_000, 40_000, 160_000, 640_000, 1_000_000, 2_500_000, 4_000_000
# An exact bind of more takes minutes, where it fits at all.
MOST_EXACT = 1_000_000
HEAD = (
    "vertices",
    "once a mesh, s",
    "a new handle, s",
    "drag frame, ms",
    "level 4, first, s",
    "level 4, ms",
    "peak, MB",
)


def measure(count: int, coarse: int | None) -> list[str] | None:
    """A row, in a process of its own; None where it would not fit into memory.

    Once a mesh: what a window does when it opens it. A new handle: bound after another one was let
    go of.
    """
    mannequin = Mannequin.make(count)
    before = peak_memory() or 0.0
    try:
        check_memory(len(mannequin.V), coarse)
    except OutOfMemory as error:
        print(error)
        return None
    once = _seconds(lambda: Deformer(mannequin.V, mannequin.F, coarse=coarse).prepare())
    session = Session(mannequin, coarse)
    session.release()
    handle = _seconds(session.rebind_handle)
    drag = seconds(session.drag, 20)
    first = _seconds(lambda: session.pose(4))
    level = seconds(lambda: session.pose(4), 3)
    peak = (peak_memory() or 0.0) - before
    return [
        f"{len(mannequin.V):,}",
        f"{once:.2f}",
        f"{handle:.2f}",
        f"{1e3 * drag:.2f}",
        f"{first:.2f}",
        f"{1e3 * level:.0f}",
        f"{peak / 1e6:.0f}",
    ]


def _seconds(call: Callable[[], object]) -> float:
    start = time.perf_counter()
    call()
    return time.perf_counter() - start


def rows(sizes: Sequence[int], coarse: int | None) -> list[list[str]]:
    """What was measured at each size that fits."""
    found = (apart(measure, size, coarse) for size in sizes)
    return [row for row in found if row is not None]


def main(arguments: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.speed.sizes", description=__doc__)
    parser.add_argument("sizes", type=int, nargs="*", default=SIZES, metavar="VERTICES")
    sizes = parser.parse_args(arguments).sizes
    print("\nExact\n")
    print(table(HEAD, rows([size for size in sizes if size <= MOST_EXACT], None)), flush=True)
    print(f"\nCoarse frames ({COARSE:,} vertices), as the window has them above {LARGE:,}\n")
    print(table(HEAD, rows([size for size in sizes if size > LARGE], COARSE)))


if __name__ == "__main__":
    main()
