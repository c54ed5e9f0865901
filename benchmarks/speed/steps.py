"""The steps of this program and of its peers on one mesh, all in one process."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import cycle

import numpy as np

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
    """One mannequin, bound; each stroke replaces its deformer, as in the window."""

    def __init__(self, mannequin: Mannequin) -> None:
        self._mannequin = mannequin
        self._grabbed, self._dragged = drag_of(mannequin.V, mannequin.hand)
        self._brush, self._forearm = mannequin.brush, mannequin.forearm
        self._softness = cycle([mannequin.softness(0.1), mannequin.softness(0.15)])
        self.bind()
        self.T = self.orient()
        size = len(self.deformer.system.free), 3
        self._columns = np.random.default_rng(0).normal(size=size)

    def drop(self) -> None:
        del self.deformer

    def bind(self) -> None:
        self.deformer = bind(self._mannequin)

    def rebind_softness(self) -> None:
        self.deformer = _ready(self.deformer.rebind(softness=next(self._softness)))

    def rebind_handle(self) -> None:
        self.deformer = _ready(self.deformer.rebind(handles=[self._forearm]))

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
            HANDLE: Task(self.rebind_handle),  # the last, as it changes what is free
        }


def bind(mannequin: Mannequin) -> Deformer:
    return _ready(Deformer(mannequin.V, mannequin.F, mannequin.fixed, [mannequin.hand]))


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
    peer_tasks = _peers(session.deformer, mannequin)
    medians(session.tasks(), 1)
    memory[ALL] = peak_memory()  # before the peers have taken theirs
    medians(peer_tasks, 1)
    times = medians(session.tasks() | peer_tasks, ROUNDS)
    held, goal = dragged(mannequin.V, mannequin.fixed, mannequin.hand)
    times |= peers.programs(mannequin.V, mannequin.F, held, goal, ROUNDS)
    session.drop()
    where = parts.profile(lambda: bind(mannequin), 3)
    known = {name: peak for name, peak in memory.items() if peak is not None}
    return Result(len(mannequin.V), free, times, where, known)


def _peers(deformer: Deformer, mannequin: Mannequin) -> dict[str, Task]:
    V, F = mannequin.V, mannequin.F
    held, goal = dragged(V, mannequin.fixed, mannequin.hand)
    tasks = peers.Arap(V, F, held, goal).tasks() | peers.harmonic(V, F, held, goal)
    return tasks | (peers.paper(deformer) if len(V) <= PAPER_LIMIT else {})
