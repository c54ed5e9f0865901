"""What a worker has been asked for and has not begun: which request goes before which."""

from __future__ import annotations

import time
from dataclasses import dataclass, field

from app.worker.errand import Errand
from app.worker.requests import BindRequest, RefineRequest, Request


@dataclass(eq=False)
class Job:
    """A request in the hands of a process, or on the way there.

    wanted: whether its result is to be polled.  errand: what it is done for, if it is for one.
    since: when it was asked for.
    """

    request: Request
    wanted: bool = True
    errand: Errand | None = None
    since: float = field(default_factory=time.monotonic)

    @property
    def needed(self) -> bool:
        """Whether anybody waits for it."""
        return self.wanted or (self.errand is not None and self.errand.waits)


class Queue:
    """The newest request of each kind, and an errand.

    Binds go first; of a refinement and an errand the older, so that neither waits for ever.
    """

    def __init__(self) -> None:
        self._waiting: dict[type[Request], Job] = {}
        self._errand: Errand | None = None

    def __bool__(self) -> bool:
        """Whether something waits whose result will be polled."""
        return bool(self._waiting)

    @property
    def bind(self) -> Job | None:
        """The bind that waits."""
        return self._waiting.get(BindRequest)

    @property
    def errand(self) -> Errand | None:
        """The errand that waits."""
        return self._errand if self._errand is not None and self._errand.waits else None

    def add(self, request: Request) -> None:
        """In place of an older one of its kind."""
        self._waiting[type(request)] = Job(request)

    def add_errand(self, errand: Errand) -> None:
        """In place of the one before, which is given up."""
        if self._errand is not None:
            self._errand.wanted = False
        self._errand = errand

    def put_back(self, job: Job) -> None:
        """It has come to nothing, and is to be done again, unless a newer one waits."""
        if job.errand is not None:
            self._errand = self._errand or job.errand
        elif job.wanted:
            self._waiting.setdefault(type(job.request), job)

    def take(self, kind: type[Request]) -> Job | None:
        """The request of this kind, which waits no longer."""
        return self._waiting.pop(kind, None)

    def clear(self) -> None:
        """Forget all but the errand."""
        self._waiting.clear()

    def next(self, known: int | None, used: BindRequest | None) -> Job | None:
        """What a process does next: it waits no longer.

        known: version of the bind that the process can refine.  used: the bind that refinements
        are asked for; what needs another one than the process has is bound to it once more.
        """
        if BindRequest in self._waiting:
            return self.take(BindRequest)
        job, errand = self._waiting.get(RefineRequest), self.errand
        if errand is not None and (job is None or errand.since < job.since):
            return self._part_of(errand, known)
        if job is None:
            return None
        assert isinstance(job.request, RefineRequest)
        wanted = job.request.version
        if used is not None and used.version == wanted != known:
            return Job(used, wanted=False)
        self.take(RefineRequest)
        return job if known == wanted else None  # None: its bind is no longer in use

    def held_up(self, running: Job) -> float:
        """Seconds that a bind waits for the bind of another mesh, which nobody needs; else 0."""
        following, bind = self.bind, running.request
        if following is None or running.needed or not isinstance(bind, BindRequest):
            return 0.0
        assert isinstance(following.request, BindRequest)
        other = bind.mesh != following.request.mesh
        return time.monotonic() - following.since if other else 0.0

    def _part_of(self, errand: Errand, known: int | None) -> Job:
        bind = errand.snapshot.bind
        if bind.version != known:
            return Job(bind, wanted=False, errand=errand)
        self._errand = None
        return Job(errand.snapshot.refinement, wanted=False, errand=errand)
