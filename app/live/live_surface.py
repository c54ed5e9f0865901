"""The surface on screen: follows the document, asks the solver, poses, and knows what failed."""

from __future__ import annotations

import time
from collections.abc import Callable, Collection

import numpy as np

from app.live.bound_handles import oriented, placed
from app.live.pace import Pace
from app.live.refinements import Refinements, at_rest
from app.live.shapes import known_shape
from app.model.document import Document, clock
from app.model.handles import GRAB, Pose
from app.worker.client import Worker
from app.worker.errand import Snapshot
from app.worker.requests import (
    BindRequest,
    Bound,
    Failure,
    Refined,
    RefineRequest,
    Restarted,
    Result,
    checked,
)
from app.worker.snapshot import bind_request, preparation, snapshot
from solver.errors import SolverError
from solver.types import FloatArray

WAIT = 0.05  # seconds between two looks at whether the surface has settled


class BindError(SolverError):
    """What the document asks for could not be bound."""


class LiveSurface:
    """Positions (n, 3) on screen; a new array each time they change, never written in place.

    Level 0 is posed here; other levels are asked of the worker. A drag shows its newest answer,
    brought along to where the handles are by now; where a level takes longer than a frame it
    shows level 0, until the mouse is released.

    worker: what binds and refines.  version: grows with each change.
    bound: the bind in use, None at rest.  bind_error: why the last one failed, empty if it did not.
    orient_seconds, pose_seconds: what the last drag frame spent.
    """

    def __init__(self, rest: FloatArray, worker: Worker, say: Callable[[str], None]) -> None:
        """rest: (n, 3) positions to begin with.  say: what tells the person what went wrong."""
        self._rest = rest
        self.worker = worker
        self._say = say
        self._pace = Pace()
        self._requested = 0  # the document's bind_version last taken care of
        self._preparation: BindRequest | None = None  # once a mesh
        self.positions = rest
        self.version = next(clock)
        self.bind_error = ""
        self.orient_seconds = self.pose_seconds = 0.0
        self._attach(None)

    def follow(self, document: Document, editing: bool, dragging: bool) -> None:
        """Take what the worker has finished, ask for what the document needs, pose the surface.

        editing: a stroke or drag is under way: no bind is asked for, but for what it grabs.
        dragging: it moves handles. Raises SolverError if there is no pose to show.
        """
        self._follow_rest(document)
        if not editing or document.grab is not None:
            self._request_bind(document)
        self._take_results()
        # What is only being grabbed is not dragged yet: its bind makes no drag a slow one.
        dragging = dragging and (document.grab is None or self.holds(GRAB))
        self._pace.choose(document.rigid, dragging, self.worker.binding)
        # Again if a bind arrives meanwhile: what was wished for was for the one before.
        while (wish := self._wish(document)) is not None:
            self.worker.request(wish)
            self._take_results()
        self._show(document)

    def settle(self, document: Document) -> None:
        """For scripts: wait until the surface is what the document asks for.

        Raises BindError if it cannot be, SolverError as `follow`.
        """
        self.follow(document, False, False)
        while self.worker.busy:
            self.worker.wait(WAIT)
            self.follow(document, False, False)
        self.known(snapshot(document))

    def known(self, shape: Snapshot) -> FloatArray | None:
        """See `known_shape`. Raises BindError where the snapshot could not be bound."""
        if self.bind_error and self._requested == shape.bind.version:
            raise BindError(self.bind_error)
        return known_shape(shape, self.bound, self._refinements)

    def orient(
        self, document: Document, key: int, grabbed: FloatArray, target: FloatArray
    ) -> FloatArray:
        """The best rigid transform (4, 4) of a handle that takes rest point `grabbed` to `target`.

        The handle must be bound (`holds`). Raises SolverError.
        """
        assert self.bound is not None
        start = time.perf_counter()
        transforms = self._transforms(document)
        transform = oriented(self.bound, key, grabbed, target, transforms)
        self.orient_seconds = time.perf_counter() - start
        return transform

    def placed(self, pose: Pose, keys: Collection[int]) -> Pose:
        """See `bound_handles.placed`; the same pose while nothing is bound."""
        return placed(self.bound, pose, keys) if self.bound else pose

    def holds(self, key: int) -> bool:
        """Whether the bind in use knows this handle."""
        return self.bound is not None and key in self.bound.request.keys

    @property
    def slow(self) -> bool:
        """Whether some rigid level takes longer than a frame, or the one asked for just now."""
        return self._pace.slow or self._refinements.late

    def _follow_rest(self, document: Document) -> None:
        """Forget what was bound of another rest shape.

        Until the next bind comes what is seen stays, unless it is the rest shape that is asked for.
        """
        if document.rest_positions is not self._rest:
            self._rest = document.rest_positions
            self.worker.drop()
            self._attach(None)
            self._stays = True
        self._stays = self._stays and not document.pose.at_rest

    def _request_bind(self, document: Document) -> None:
        if document.bind_version == self._requested:
            return
        self._requested = document.bind_version
        self.bind_error = ""
        request = bind_request(document)
        if request.keys:
            self.worker.request(request)
        else:
            self.worker.drop()
            self._attach(None)
            if self._preparation is None:
                self._preparation = preparation(document)
                self.worker.request(self._preparation)

    def _take_results(self) -> None:
        """All of them, even if one is an error that has to be raised."""
        refusal: SolverError | None = None
        for result in self.worker.poll():
            try:
                self._take(result)
            except SolverError as error:
                refusal = error
        if refusal is not None:
            raise refusal

    def _take(self, result: Result) -> None:
        if isinstance(result, Bound | Failure) and result.request is self._preparation:
            return
        if isinstance(result, Bound):
            self._attach(result)
            if result.pose is not None:
                self._take_pose(result.pose)
        elif isinstance(result, Refined):
            self._take_pose(result)
        elif isinstance(result, Restarted):
            self._say(f"The solver {result.what} and was started again")
        else:
            self._take_failure(result)

    def _attach(self, bound: Bound | None) -> None:
        """Use another bind from the next pose on; None: the rest shape."""
        self.bound = bound
        self._stays = False  # what is seen, although nothing is bound
        self._pace.forget()
        self._refinements = Refinements()
        self._shown: tuple[object, ...] = ()

    def _take_pose(self, refined: Refined) -> None:
        """Raises PoseError."""
        if self.bound is None or refined.request.version != self.bound.request.version:
            return
        self._pace.learn(refined.request.rigid, refined.seconds)
        self._refinements.take(refined)

    def _take_failure(self, failure: Failure) -> None:
        if isinstance(failure.request, RefineRequest):
            self._refinements.refuse(failure.request, failure.error)
            raise failure.error
        self.bind_error = f"Binding failed: {failure.error}"
        self._say(self.bind_error)

    def _wish(self, document: Document) -> RefineRequest | None:
        """What the worker has to be asked for this frame's positions, None for nothing new."""
        transforms = self._transforms(document)
        linear = document.rigid == 0 or self._pace.linear
        if self.bound is None or linear or at_rest(transforms):
            return None
        return self._refinements.wish(self.bound, transforms, document.rigid)

    def _show(self, document: Document) -> None:
        """Pose the surface as the document asks, as far as that is known by now.

        Raises SolverError, and keeps the positions, if there is no pose to show.
        """
        transforms, pace = self._transforms(document), self._pace
        modes = document.rigid, pace.dragging, pace.linear, self._stays
        wanted = (self.bound, transforms.tobytes(), *modes, self._refinements.latest)
        if wanted == self._shown:
            return
        self._shown = wanted  # first: a pose that is refused is not tried again every frame
        start = time.perf_counter()
        positions = self._posed(transforms, document.rigid)
        self.pose_seconds = time.perf_counter() - start
        if not pace.linear:
            self.pose_seconds += pace.cost(document.rigid)
        if positions is not self.positions:
            self.positions = checked(positions)
            self.version = next(clock)

    def _posed(self, transforms: FloatArray, level: int) -> FloatArray:
        """The best that is known of the surface: exact, unless a drag or an answer is under way."""
        refined = self._refinements.at(level)
        if self._stays:
            return self.positions
        if self.bound is None or at_rest(transforms):
            return self._rest
        if refined is not None and refined.request.asks(transforms, level):
            return refined.positions
        if level == 0 or self._pace.linear:
            return self.bound.model.pose(transforms)
        if not self._pace.dragging:
            return self.positions  # until the answer is there
        base, start = self._rest, np.broadcast_to(np.eye(4), transforms.shape)
        if refined is not None:
            base, start = refined.positions, refined.request.transforms
        return self.bound.model.carry(base, start, transforms)

    def _transforms(self, document: Document) -> FloatArray:
        """(h, 4, 4): those of the handles in the order the bind knows them."""
        return document.pose.stacked(self.bound.request.keys if self.bound else ())
