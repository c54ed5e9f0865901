"""The steps of this program and of its peers on one mesh, all in one process."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import cycle

import numpy as np

from app.model.settings import COARSE, LARGE
from benchmarks.cases.mannequin import Mannequin, drag_of, dragged
from benchmarks.machine import peak_memory
from benchmarks.speed import parts, peers
from benchmarks.timing import Task, medians
from solver import Deformer
from solver.types import FloatArray

BIND = "bind from scratch"
SOFTNESS = "rebind after a softness stroke"
HANDLE = "rebind after a handle stroke"
GRAB = "grab"
SOLVE = "one back-substitution, 3 columns"
POSE = "drag: pose, rigid 0"
DRAG = "drag: orient + pose, rigid 0"
FIRST = "pose, rigid 1, the first after a bind"
RIGID = "pose, rigid 1"
SETTLED = "pose, rigid 4"
COARSE_HANDLE = "coarse frames: rebind after a handle stroke"
COARSE_DRAG = "coarse frames: orient + pose, rigid 0"
COARSE_SETTLED = "coarse frames: pose, rigid 4"

START = "the program with the mesh"
ONE = "and one bind"
ALL = "and all steps"

ROUNDS = 5
# Above this many vertices a spsolve takes too long to wait for.
PAPER_LIMIT = 30_000


@dataclass(frozen=True)
class Result:
    """What was measured on one mesh.

    times: seconds a step.  parts: seconds of a bind's parts.  memory: peak bytes since the
    process started, empty where the system does not say.
    """

    vertices: int
    free: int
    times: dict[str, float]
    parts: dict[str, float]
    memory: dict[str, float]


class Session:
    """One mannequin, bound; each stroke replaces its deformer, as in the window.

    coarse: how many vertices frames are for, None for the exact solution.
    """

    def __init__(self, mannequin: Mannequin, coarse: int | None = None) -> None:
        self._mannequin, self._coarse = mannequin, coarse
        self._grabbed, self._dragged = drag_of(mannequin.V, mannequin.hand)
        self._brush = mannequin.brush
        self._handles = cycle([mannequin.forearm, mannequin.hand])
        self._softness = cycle([mannequin.softness(0.1), mannequin.softness(0.15)])
        self.bind()
        self.T = self.orient()
        size = len(self.deformer.system.free), 3
        self._columns = np.random.default_rng(0).normal(size=size)

    def drop(self) -> None:
        del self.deformer

    def bind(self) -> None:
        self.deformer = bind(self._mannequin, self._coarse)

    def rebind_softness(self) -> None:
        self.deformer = _ready(self.deformer.rebind(softness=next(self._softness)))

    def release(self) -> None:
        """Two factors are never in memory at once."""
        self.deformer = self.deformer.rebind(fixed=(), handles=())

    def rebind_handle(self) -> None:
        held = {"fixed": self._mannequin.fixed, "handles": [next(self._handles)]}
        self.deformer = _ready(self.deformer.rebind(**held))

    def grab(self) -> None:
        _ready(self.deformer.grab(self._brush))

    def solve(self) -> None:
        self.deformer.system.factor.solve(self._columns)

    def orient(self) -> FloatArray:
        return self.deformer.orient(0, self._grabbed, self._dragged, [np.eye(4)])

    def drag(self) -> None:
        self.deformer.pose([self.orient()])

    def pose(self, rigid: int) -> None:
        self.deformer.pose([self.T], rigid)

    def tasks(self) -> dict[str, Task]:
        return {
            BIND: Task(self.bind, before=self.drop),
            SOFTNESS: Task(self.rebind_softness),
            GRAB: Task(self.grab),
            SOLVE: Task(self.solve, 3),
            POSE: Task(lambda: self.pose(0), 50),
            DRAG: Task(self.drag, 50),
            FIRST: Task(lambda: self.pose(1)),
            RIGID: Task(lambda: self.pose(1), 5),
            SETTLED: Task(lambda: self.pose(4), 3),
            # The last, as it changes what is free.
            HANDLE: Task(self.rebind_handle, before=self.release),
        }

    def coarse_tasks(self) -> dict[str, Task]:
        """What the window does with meshes of this size."""
        return {
            COARSE_HANDLE: Task(self.rebind_handle, before=self.release),
            COARSE_DRAG: Task(self.drag, 50),
            COARSE_SETTLED: Task(lambda: self.pose(4), 3),
        }


def bind(mannequin: Mannequin, coarse: int | None = None) -> Deformer:
    held = mannequin.fixed, [mannequin.hand]
    return _ready(Deformer(mannequin.V, mannequin.F, *held, coarse=coarse))


def _ready(deformer: Deformer) -> Deformer:
    """With what a drag needs, which is otherwise made by the first one."""
    assert deformer.drag_model is not None
    return deformer


def measure(mannequin: Mannequin) -> Result:
    """Everything on one mesh."""
    memory = {START: peak_memory()}
    session = Session(mannequin)
    memory[ONE] = peak_memory()
    free = len(session.deformer.system.free)
    medians(session.tasks(), 1)
    memory[ALL] = peak_memory()  # before coarse frames and the peers have taken theirs
    others = _coarse_tasks(mannequin) | _peers(session.deformer, mannequin)
    medians(others, 1)
    times = medians(session.tasks() | others, ROUNDS)
    held, goal = dragged(mannequin.V, mannequin.fixed, mannequin.hand)
    times |= peers.programs(mannequin.V, mannequin.F, held, goal, ROUNDS)
    session.drop()
    where = parts.profile(lambda: bind(mannequin), 3)
    known = {name: peak for name, peak in memory.items() if peak is not None}
    return Result(len(mannequin.V), free, times, where, known)


def _coarse_tasks(mannequin: Mannequin) -> dict[str, Task]:
    if len(mannequin.V) <= LARGE:
        return {}
    return Session(mannequin, COARSE).coarse_tasks()


def _peers(deformer: Deformer, mannequin: Mannequin) -> dict[str, Task]:
    V, F = mannequin.V, mannequin.F
    held, goal = dragged(V, mannequin.fixed, mannequin.hand)
    tasks = peers.Arap(V, F, held, goal).tasks() | peers.harmonic(V, F, held, goal)
    return tasks | (peers.paper(deformer) if len(V) <= PAPER_LIMIT else {})
