"""A function in a process of its own: what comes back, and how it ends."""

from __future__ import annotations

import multiprocessing
import os
import time
from collections.abc import Generator
from typing import Any

import numpy as np
import pytest

from app.worker.apart import apart
from app.worker.requests import WorkerError
from solver import MeshError
from solver.mesh.progress import Progress
from solver.types import FloatArray


def doubled(given: FloatArray, tell: Progress) -> FloatArray:
    tell(0.5)
    return 2 * given


def refused(given: str, tell: Progress) -> None:
    raise MeshError(given)


def broken(given: str, tell: Progress) -> None:
    raise KeyError(given)


def gone(given: object, tell: Progress) -> None:
    os._exit(3)


def endless(given: object, tell: Progress) -> None:
    tell(0.25)
    time.sleep(600)


def outcome(steps: Generator[float, None, Any]) -> tuple[Any, float]:
    """What is returned, and how far it said it was last."""
    fraction = 0.0
    while True:
        try:
            fraction = next(steps)
        except StopIteration as end:
            return end.value, fraction
        time.sleep(0.002)


def test_large_arrays_go_there_and_back() -> None:
    given = np.arange(3e6)
    found, fraction = outcome(apart(doubled, given))
    np.testing.assert_array_equal(found, 2 * given)
    assert fraction in (0.0, 0.5)


@pytest.mark.parametrize(
    ("work", "error", "said"),
    [
        (refused, MeshError, "^a mesh$"),
        (broken, WorkerError, "^KeyError: 'a mesh'$"),
        (gone, WorkerError, "has ended before"),
    ],
)
def test_what_goes_wrong_there_is_raised_here(work: Any, error: type[Exception], said: str) -> None:
    with pytest.raises(error, match=said):
        outcome(apart(work, "a mesh"))


def test_its_process_ends_where_nobody_waits_any_more() -> None:
    others = set(multiprocessing.active_children())
    steps = apart(endless, None)
    while next(steps) != 0.25:
        time.sleep(0.002)
    (process,) = set(multiprocessing.active_children()) - others
    steps.close()
    process.join(10)
    assert not process.is_alive()
