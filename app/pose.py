"""The surface on screen: where the vertices are, given the handles' transforms."""

from __future__ import annotations

import time

import numpy as np

from app.document import Document, clock
from app.worker import Bound
from solver.errors import SolverError
from solver.mesh import Mesh
from solver.orientation import rigid_fit
from solver.types import FloatArray

FRAME_BUDGET = 0.030  # seconds a pose may take while somebody drags


class PoseError(SolverError):
    """The solver returned positions that cannot be shown."""


class Surface:
    """Positions (n, 3) on screen; a new array each time they change, never written in place.

    version: grows with each change. bound: the deformer in use, None at rest.
    orient_seconds, pose_seconds: what the last drag frame spent.
    """

    def __init__(self, mesh: Mesh) -> None:
        self._rest = mesh.vertices
        self.positions = mesh.vertices
        self.version = next(clock)
        self.bound: Bound | None = None
        self.orient_seconds = self.pose_seconds = 0.0
        self._cost: dict[int, float] = {}
        self._shown: tuple[object, ...] = ()

    def attach(self, bound: Bound | None) -> None:
        """Use another deformer from the next `show` on; None: the rest shape."""
        self.bound = bound
        self._cost.clear()

    def show(self, document: Document, live: bool = False) -> None:
        """Pose the surface as the document asks, if anything changed since it was last posed.

        live: somebody drags, so a rigid level that lately passed the budget is put off (to 0).
        Raises SolverError, and keeps the positions, if there is no pose to show.
        """
        level = document.rigid
        if live and self._cost.get(level, 0.0) > FRAME_BUDGET:
            level = 0
        wanted = (self.bound, document.revision["handles"], level)
        if wanted == self._shown:
            return
        self._shown = wanted  # first: a pose that is refused is not tried again every frame
        start = time.perf_counter()
        positions = self._pose(document, level)
        self._cost[level] = self.pose_seconds = time.perf_counter() - start
        if not np.isfinite(positions).all():
            raise PoseError("the solver returned positions that are not finite; pose not shown")
        self.positions = positions
        self.version = next(clock)

    def orient(
        self, document: Document, key: int, grabbed: FloatArray, target: FloatArray
    ) -> FloatArray:
        """The best rigid transform (4, 4) of a handle that takes rest point `grabbed` to `target`.

        The handle must be bound (`holds`). Raises SolverError.
        """
        assert self.bound is not None
        start = time.perf_counter()
        number = self.bound.request.keys.index(key)
        transform: FloatArray = self.bound.deformer.orient(
            number, grabbed, target, self.transforms(document)
        )
        self.orient_seconds = time.perf_counter() - start
        if not np.isfinite(transform).all():
            raise PoseError("the solver returned a rotation that is not finite; drag ended")
        return transform

    def holds(self, key: int) -> bool:
        """Whether the deformer in use knows this handle."""
        return self.bound is not None and key in self.bound.request.keys

    def transforms(self, document: Document) -> list[FloatArray]:
        """The handles' transforms in the order the deformer knows them."""
        keys = self.bound.request.keys if self.bound else ()
        handles = [document.find(key) for key in keys]
        return [np.eye(4) if handle is None else handle.transform for handle in handles]

    def _pose(self, document: Document, level: int) -> FloatArray:
        transforms = self.transforms(document)
        if self.bound is None or all(np.array_equal(T, np.eye(4)) for T in transforms):
            return self._rest
        positions: FloatArray = self.bound.deformer.pose(transforms, rigid=level)
        return positions


def rigid_motion(rest: FloatArray, moved: FloatArray) -> FloatArray:
    """argmin over rigid T, (4, 4), of sum ||T rest - moved||^2, for points (k, 3) each."""
    transform = np.eye(4)
    transform[:3, :3] = R = rigid_fit(rest, moved)
    transform[:3, 3] = moved.mean(axis=0) - R @ rest.mean(axis=0)
    return transform
