"""The libraries that factorise, side by side on one mesh."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import AbstractContextManager
from dataclasses import dataclass
from unittest.mock import patch

import numpy as np

from benchmarks.cases.mannequin import Mannequin
from benchmarks.speed.steps import BIND, GRAB, HANDLE, SOFTNESS, SOLVE, Session
from benchmarks.timing import Task, medians
from solver.factor import table
from solver.factor.backend import Backend
from solver.geometry.bounding_box import diagonal

STEPS = BIND, SOFTNESS, GRAB, SOLVE, HANDLE  # the last changes what is free
ROUNDS = 5


@dataclass(frozen=True)
class Comparison:
    """What the libraries take on one mesh, and how far their surfaces are apart.

    times: seconds of a step with a library.  difference: the largest between the surface of a
    library and that of the first, in bounding-box diagonals.
    """

    vertices: int
    times: dict[str, float]
    difference: dict[str, float]


def compare(mannequin: Mannequin, backends: Sequence[Backend]) -> Comparison:
    """All `backends` on one mesh, in turn; the first is the one to compare with."""
    sessions = {backend.name: _session(mannequin, backend) for backend in backends}
    T = sessions[backends[0].name].T
    surfaces = {name: session.deformer.pose([T]) for name, session in sessions.items()}
    expected = surfaces.pop(backends[0].name)
    tasks = {
        f"{step}, {backend.name}": _with(backend, sessions[backend.name].tasks()[step])
        for step in STEPS
        for backend in backends
    }
    medians(tasks, 1)
    size = diagonal(mannequin.V)
    apart = {name: float(np.abs(X - expected).max() / size) for name, X in surfaces.items()}
    return Comparison(len(mannequin.V), medians(tasks, ROUNDS), apart)


def _session(mannequin: Mannequin, backend: Backend) -> Session:
    with _alone(backend):
        return Session(mannequin)


def _with(backend: Backend, task: Task) -> Task:
    def call() -> None:
        with _alone(backend):
            task.call()

    return Task(call, task.repeats, task.before)


def _alone(backend: Backend) -> AbstractContextManager[object]:
    return patch.object(table, "BACKENDS", (backend,))
