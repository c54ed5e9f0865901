"""Every step at several sizes: `python -m benchmarks [--sizes N ...] [-o FILE]`."""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Callable, Sequence
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from pathlib import Path
from typing import TypeVar
from unittest.mock import patch

from app.worker.process import ONE_THREAD
from benchmarks import machine
from benchmarks.cases.mannequin import Mannequin
from benchmarks.speed import backends, plot, report, steps
from solver.factor import BACKENDS
from solver.factor.superlu import BACKEND as SUPERLU

SMALLEST = 1000  # the mannequin has no hand below
SIZES = 10_000, 25_000, 60_000, 120_000
# Above this many vertices a bind with splu takes too long to wait for.
SPLU_LIMIT = 30_000
RESULTS = Path(__file__).resolve().parents[1] / "RESULTS.md"

Answer = TypeVar("Answer")


def apart(task: Callable[..., Answer], *arguments: object) -> Answer:
    """What `task` returns in a fresh process: its memory is its own, and its heap is clean."""
    pool = ProcessPoolExecutor(max_workers=1, mp_context=get_context("spawn"))
    # As the window's solver process has it.
    with patch.dict(os.environ, dict.fromkeys(ONE_THREAD, "1")), pool:
        return pool.submit(task, *arguments).result()


def run(sizes: Sequence[int], output: Path) -> str:
    """Measure, write the report to `output` and its plot beside it, and return the report."""
    about = machine.description()
    results, comparisons = [], []
    for size in sorted(sizes):
        print(f"{size} vertices ...", file=sys.stderr, flush=True)
        mannequin = apart(Mannequin.make, size)
        results.append(apart(steps.measure, mannequin))
        libraries = [b for b in BACKENDS if b is not SUPERLU or size <= SPLU_LIMIT]
        if len(libraries) > 1:
            comparisons.append(apart(backends.compare, mannequin, libraries))
    picture = output.with_name(f"{output.stem.lower()}.svg")
    drawn = picture.name if plot.draw(results, picture) else None
    text = report.markdown(results, comparisons, about, drawn)
    output.write_text(text, encoding="utf-8")
    return text


def main(arguments: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(prog="python -m benchmarks", description=__doc__)
    parser.add_argument("--sizes", type=int, nargs="+", default=SIZES, metavar="VERTICES")
    parser.add_argument("-o", "--output", type=Path, default=RESULTS, metavar="FILE")
    options = parser.parse_args(arguments)
    if min(options.sizes) < SMALLEST:
        parser.error(f"sizes must be at least {SMALLEST} vertices, got {min(options.sizes)}")
    if not options.output.parent.is_dir():
        parser.error(f"no such folder: {options.output.parent}")
    print(run(options.sizes, options.output))


if __name__ == "__main__":
    main()
