"""What the window asks of the solver and what comes back: plain immutable data."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from solver import Setup
from solver.errors import SolverError
from solver.linear.drag_model import DragModel
from solver.types import FloatArray, IntArray


class WorkerError(SolverError):
    """The solver's process did not do what it was asked."""


class PoseError(SolverError):
    """The solver returned positions that cannot be shown."""


def checked(positions: FloatArray) -> FloatArray:
    """The same. Raises PoseError unless all are finite."""
    if not np.isfinite(positions).all():
        raise PoseError("the solver returned positions that are not finite; pose not shown")
    return positions


@dataclass(frozen=True, eq=False)
class BindRequest:
    """A snapshot of all that binding depends on.

    version: of the document it was taken from. mesh: a number that names the mesh.
    keys: (h,) of the handles that have vertices, in the order of the setup's.
    rigid, transforms: the level and the (h, 4, 4) that the surface is posed at for a start.
    grab: (n,) the weights of a soft handle, whose key is the last; None for none.
    """

    version: int
    mesh: int
    keys: tuple[int, ...]
    vertices: FloatArray
    faces: IntArray
    setup: Setup
    rigid: int
    transforms: FloatArray
    grab: FloatArray | None = None

    @property
    def answer_size(self) -> int:
        """Bytes that are enough for the arrays of the answer."""
        handles = len(self.keys)
        return len(self.vertices) * (24 + 24 + 8 + 32 * handles) + 128 * handles**2 + 4096

    @property
    def first_pose(self) -> RefineRequest:
        """What the surface is posed at for a start."""
        return RefineRequest(self.version, self.transforms, self.rigid, len(self.vertices))


@dataclass(frozen=True, eq=False)
class RefineRequest:
    """Positions at a rigid level of 1 or more.

    version: of the bind they are for.  transforms: (h, 4, 4).  vertex_count: n.
    """

    version: int
    transforms: FloatArray
    rigid: int
    vertex_count: int

    def asks(self, transforms: FloatArray, rigid: int) -> bool:
        """Whether it is for this pose."""
        return self.rigid == rigid and np.array_equal(self.transforms, transforms)

    @property
    def answer_size(self) -> int:
        """Bytes that are enough for the arrays of the answer."""
        return 24 * self.vertex_count + 4096


Request = BindRequest | RefineRequest


@dataclass(frozen=True, eq=False)
class Answer:
    """What became of a request, and the seconds it took.

    value: a DragModel for a bind, positions (n, 3) for a refinement, or what went wrong.
    pose: of a bind, the answer to its `first_pose`; None where the surface is at rest or linear.
    """

    value: DragModel | FloatArray | SolverError
    seconds: float
    pose: Answer | None = None


@dataclass(frozen=True, eq=False)
class Bound:
    """A finished bind. seconds: how long it took.

    pose: the surface at the request's transforms, where that is more than the model can tell.
    """

    request: BindRequest
    model: DragModel
    seconds: float
    pose: Refined | None = None

    def is_loose(self, key: int) -> bool:
        """Whether nothing but this handle, which may be unknown, holds what it is part of."""
        keys = self.request.keys
        return key in keys and self.model.is_loose(keys.index(key))


@dataclass(frozen=True, eq=False)
class Refined:
    """Positions (n, 3) that were asked for. seconds: how long they took."""

    request: RefineRequest
    positions: FloatArray
    seconds: float


@dataclass(frozen=True, eq=False)
class Failure:
    """A request that could not be met."""

    request: Request
    error: SolverError


@dataclass(frozen=True)
class Restarted:
    """Another process has taken over the work of the solver's, which `what`: say, "stopped"."""

    what: str


Result = Bound | Refined | Failure | Restarted


def result_of(request: Request, answer: Answer) -> Result:
    """An answer together with what was asked."""
    value = answer.value
    if isinstance(value, SolverError):
        return Failure(request, value)
    if isinstance(request, BindRequest):
        assert isinstance(value, DragModel)
        pose = result_of(request.first_pose, answer.pose) if answer.pose else None
        # One that failed is asked for again in its own right, and fails with a message.
        return Bound(request, value, answer.seconds, pose if isinstance(pose, Refined) else None)
    assert not isinstance(value, DragModel)
    return Refined(request, value, answer.seconds)
