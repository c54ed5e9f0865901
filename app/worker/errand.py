"""One shape of a surface, as it was when somebody asked for it, whatever a document does since."""

from __future__ import annotations

import time
from dataclasses import dataclass, field, replace

from app.model.handles import Pose
from app.worker.requests import BindRequest, Failure, Refined, RefineRequest
from solver.types import FloatArray


@dataclass(frozen=True, eq=False)
class Snapshot:
    """All that one shape of a surface depends on.

    bind: what holds it.  transforms: (h, 4, 4) of the handles, in the order of `bind.keys`.
    rigid: the level.
    """

    bind: BindRequest
    transforms: FloatArray
    rigid: int

    @property
    def refinement(self) -> RefineRequest:
        """What is asked of a process that is bound to it."""
        count = len(self.bind.vertices)
        return RefineRequest(self.bind.version, self.transforms, self.rigid, count)

    def posed(self, pose: Pose) -> Snapshot:
        """The same surface in another pose."""
        return replace(self, transforms=pose.stacked(self.bind.keys))


@dataclass(eq=False)
class Errand:
    """Asked of a worker beside what the surface on screen needs.

    result: None until it is there.  wanted: whether somebody still waits for it.
    since: when it was asked for.
    """

    snapshot: Snapshot
    result: Refined | Failure | None = None
    wanted: bool = True
    since: float = field(default_factory=time.monotonic)

    @property
    def waits(self) -> bool:
        """Whether there is something left to do for it."""
        return self.wanted and self.result is None
