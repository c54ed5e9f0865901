"""What was asked of the worker beyond the linear surface, and what it has answered."""

from __future__ import annotations

import time

import numpy as np

from app.worker.requests import Bound, Refined, RefineRequest, checked
from solver.errors import SolverError
from solver.types import FloatArray

NOTICED = 0.5  # seconds


class Refinements:
    """The newest question and the newest answer for one bind.

    latest: the answer, None before the first.
    """

    def __init__(self) -> None:
        self.latest: Refined | None = None
        self._asked: RefineRequest | None = None
        self._since = 0.0
        self._refused: SolverError | None = None

    def wish(self, bound: Bound, transforms: FloatArray, level: int) -> RefineRequest | None:
        """What has to be asked for the pose (h, 4, 4) at a level, None for nothing new."""
        known = [self._asked, self.latest.request if self.latest else None]
        if any(one and one.asks(transforms, level) for one in known):
            return None
        request = bound.request
        self._asked = RefineRequest(request.version, transforms, level, len(request.vertices))
        self._refused, self._since = None, time.monotonic()
        return self._asked

    @property
    def late(self) -> bool:
        """Whether the newest question has been without an answer for longer than one notices."""
        asked, latest = self._asked, self.latest
        if asked is None or self._refused is not None:
            return False
        answered = latest is not None and latest.request.asks(asked.transforms, asked.rigid)
        return not answered and time.monotonic() - self._since > NOTICED

    def take(self, refined: Refined) -> None:
        """An answer. Raises PoseError, and keeps the one before, if it is no use."""
        try:
            checked(refined.positions)
        except SolverError as error:
            self.refuse(refined.request, error)
            raise
        self.latest = refined

    def refuse(self, request: RefineRequest, error: SolverError) -> None:
        """The worker cannot give what it was asked for."""
        if request is self._asked:
            self._refused = error

    def refusal(self, request: RefineRequest) -> SolverError | None:
        """Why what a request asks for cannot be had, None as far as is known."""
        asked = self._asked
        if asked is None or asked.version != request.version:
            return None
        return self._refused if asked.asks(request.transforms, request.rigid) else None

    def at(self, level: int) -> Refined | None:
        """The newest answer, if it is of this level."""
        return self.latest if self.latest and self.latest.request.rigid == level else None


def at_rest(transforms: FloatArray) -> bool:
    """Whether (h, 4, 4) are all the identity."""
    return bool((transforms == np.eye(4)).all())
