"""The surface on screen: where the vertices are, given the handles' transforms."""

from __future__ import annotations

import time

import numpy as np

from app.model.document import Document, clock
from app.worker.requests import Bound, Refined, RefineRequest
from solver.errors import SolverError
from solver.mesh.mesh import Mesh
from solver.types import FloatArray

FRAME_BUDGET = 0.030  # seconds a rigid level may take for a drag to begin with it
SLACK = 1.5  # budgets that it may take before a drag that has begun with it gives it up


class PoseError(SolverError):
    """The solver returned positions that cannot be shown."""


class Surface:
    """Positions (n, 3) on screen; a new array each time they change, never written in place.

    Level 0 is posed here. Other levels are asked of the worker: `wish` says what for, `take`
    gets the answer. A drag shows its newest answer, brought along to where the handles are by
    now; where a level takes longer than a frame it shows level 0, until the mouse is released.

    version: grows with each change. bound: the bind in use, None at rest.
    orient_seconds, pose_seconds: what the last drag frame spent.
    """

    def __init__(self, mesh: Mesh) -> None:
        self._rest = mesh.vertices
        self.positions = mesh.vertices
        self.version = next(clock)
        self.orient_seconds = self.pose_seconds = 0.0
        self._dragged = False
        self._linear = False  # the drag under way is shown at level 0
        self.attach(None)

    def attach(self, bound: Bound | None) -> None:
        """Use another bind from the next `show` on; None: the rest shape."""
        self.bound = bound
        self._cost: dict[int, float] = {}
        self._asked: RefineRequest | None = None
        self._refused: SolverError | None = None
        self._refined: Refined | None = None
        self._shown: tuple[object, ...] = ()

    def choose(self, document: Document, dragging: bool, binding: bool) -> None:
        """Decide how a drag is shown, once a frame. It may turn to level 0, and stays there.

        binding: a bind is under way, so that no rigid level can be had.
        """
        limit = FRAME_BUDGET * (SLACK if self._dragged else 1.0)
        slow = binding or self._cost.get(document.rigid, 0.0) > limit
        self._linear = dragging and (self._linear or slow)
        self._dragged = dragging

    def wish(self, document: Document) -> RefineRequest | None:
        """What the worker has to be asked for this frame's positions, None for nothing new."""
        transforms = self._stacked(document)
        if self.bound is None or document.rigid == 0 or self._linear or _at_rest(transforms):
            return None
        known = [self._asked, self._refined.request if self._refined else None]
        if any(one and _answers(one, transforms, document.rigid) for one in known):
            return None
        request = self.bound.request
        self._asked = RefineRequest(
            request.version, transforms, document.rigid, len(request.vertices)
        )
        self._refused = None
        return self._asked

    def take(self, refined: Refined) -> None:
        """An answer of the worker. Raises PoseError, and keeps what was before, if it is no use."""
        if self.bound is None or refined.request.version != self.bound.request.version:
            return
        self._cost[refined.request.rigid] = refined.seconds
        try:
            _check(refined.positions)
        except PoseError as error:
            self.refuse(refined.request, error)
            raise
        self._refined = refined

    def refuse(self, request: RefineRequest, error: SolverError) -> None:
        """The worker cannot give what it was asked for."""
        if request is self._asked:
            self._refused = error

    def refusal(self, document: Document) -> SolverError | None:
        """Why the positions that the document asks for cannot be had, None if they can."""
        asked = self._asked
        current = asked and _answers(asked, self._stacked(document), document.rigid)
        return self._refused if current else None

    def show(self, document: Document) -> None:
        """Pose the surface as the document asks, as far as that is known by now.

        Raises SolverError, and keeps the positions, if there is no pose to show.
        """
        transforms = self._stacked(document)
        modes = document.rigid, self._dragged, self._linear
        wanted = (self.bound, transforms.tobytes(), *modes, self._refined)
        if wanted == self._shown:
            return
        self._shown = wanted  # first: a pose that is refused is not tried again every frame
        start = time.perf_counter()
        positions = self._posed(transforms, document.rigid)
        self.pose_seconds = time.perf_counter() - start
        if not self._linear:
            self.pose_seconds += self._cost.get(document.rigid, 0.0)
        if positions is not self.positions:
            _check(positions)
            self.positions = positions
            self.version = next(clock)

    def _posed(self, transforms: FloatArray, level: int) -> FloatArray:
        """The best that is known of the surface: exact, unless a drag or an answer is under way."""
        refined = self._refined if self._refined and self._refined.request.rigid == level else None
        if self.bound is None or _at_rest(transforms):
            return self._rest
        if refined is not None and _answers(refined.request, transforms, level):
            return refined.positions
        if level == 0 or self._linear:
            return self.bound.model.pose(transforms)
        if not self._dragged:
            return self.positions  # until the answer is there
        base, start = self._rest, np.broadcast_to(np.eye(4), transforms.shape)
        if refined is not None:
            base, start = refined.positions, refined.request.transforms
        return self.bound.model.carry(base, start, transforms)

    @property
    def slow(self) -> bool:
        """Whether some rigid level takes longer than a frame."""
        return max(self._cost.values(), default=0.0) > FRAME_BUDGET

    def orient(
        self, document: Document, key: int, grabbed: FloatArray, target: FloatArray
    ) -> FloatArray:
        """The best rigid transform (4, 4) of a handle that takes rest point `grabbed` to `target`.

        The handle must be bound (`holds`). Raises SolverError.
        """
        assert self.bound is not None
        start = time.perf_counter()
        number = self.bound.request.keys.index(key)
        transform = self.bound.model.orient(number, grabbed, target, self._stacked(document))
        self.orient_seconds = time.perf_counter() - start
        if not np.isfinite(transform).all():
            raise PoseError("the solver returned a rotation that is not finite; drag ended")
        return transform

    def holds(self, key: int) -> bool:
        """Whether the bind in use knows this handle."""
        return self.bound is not None and key in self.bound.request.keys

    def _stacked(self, document: Document) -> FloatArray:
        """(h, 4, 4): the handles' transforms in the order the bind knows them."""
        keys = self.bound.request.keys if self.bound else ()
        handles = [document.find(key) for key in keys]
        transforms = [np.eye(4) if handle is None else handle.transform for handle in handles]
        return np.array(transforms).reshape(-1, 4, 4)


def _at_rest(transforms: FloatArray) -> bool:
    return bool((transforms == np.eye(4)).all())


def _answers(request: RefineRequest, transforms: FloatArray, level: int) -> bool:
    return request.rigid == level and np.array_equal(request.transforms, transforms)


def _check(positions: FloatArray) -> None:
    if not np.isfinite(positions).all():
        raise PoseError("the solver returned positions that are not finite; pose not shown")
