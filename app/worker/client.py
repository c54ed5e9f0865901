"""What works for the window: takes requests, returns at once, and gives results when they come."""

from __future__ import annotations

import time
from dataclasses import dataclass, field
from typing import Protocol

from app.worker.process import ProcessDied, SolverProcess
from app.worker.requests import (
    BindRequest,
    Bound,
    Failure,
    RefineRequest,
    Request,
    Restarted,
    Result,
    WorkerError,
    result_of,
)
from solver.errors import SolverError

# How often a request is given to a process in whose hands the process has ended.
ATTEMPTS = 3
# Seconds that a bind of a mesh nobody looks at any more may hold up the bind of another one.
PATIENCE = 1.0


class Worker(Protocol):
    """Of the requests of one kind the newest counts: an older one that waits is dropped.

    A bind that is superseded while it runs still gives its result, unless it fails; a refinement
    goes before no bind.
    """

    def request(self, request: Request) -> None:
        """Ask for something; returns at once."""

    def poll(self) -> list[Result]:
        """What has arrived since the last call, oldest first."""

    def drop(self) -> None:
        """Forget the requests so far: no result of theirs will be polled."""

    @property
    def busy(self) -> bool:
        """Whether a result that is wanted has not been polled yet."""

    @property
    def binding(self) -> bool:
        """Whether a bind is under way; refinements wait for it."""

    def wait(self, timeout: float | None = None) -> bool:
        """Block until there is something to poll or nothing is under way; False: too long."""

    def close(self) -> None:
        """End whatever runs; nothing will be polled any more."""


@dataclass(eq=False)
class _Job:
    """wanted: whether somebody waits for the result. since: when it was asked for."""

    request: Request
    wanted: bool = True
    since: float = field(default_factory=time.monotonic)


class ProcessWorker:
    """A worker in a process of its own: CHOLMOD would hold the window's global lock.

    Runs no thread: it gets on whenever it is asked for anything. If the process ends by itself
    another is started, and what it was doing is asked of that one, ATTEMPTS times in all.

    A superseded bind runs to its end, for the next bind of the mesh shares its ordering; ended
    half-way it would cost a new process and a bind from scratch. Only where the next bind is of
    another mesh, which shares nothing, the process is replaced after PATIENCE.
    """

    def __init__(self) -> None:
        self._process = SolverProcess()
        self._process.start()  # now, to load while the window opens
        self._waiting: dict[type[Request], _Job] = {}
        self._running: _Job | None = None
        self._results: list[Result] = []
        self._deaths = 0
        self._known: int | None = None  # version of the bind that the process can refine
        self._used: BindRequest | None = None  # the bind polled last, which refinements are for
        self._closed = False

    @property
    def pid(self) -> int | None:
        """The system's number of the process, None when there is none."""
        return self._process.pid

    def request(self, request: Request) -> None:
        """See Worker."""
        if self._closed:
            return
        self._waiting[type(request)] = _Job(request)
        self._advance()

    def poll(self) -> list[Result]:
        """See Worker."""
        self._advance()
        results, self._results = self._results, []
        return results

    def drop(self) -> None:
        """See Worker."""
        self._waiting.clear()
        self._results.clear()
        self._used = None
        if self._running is not None:
            self._running.wanted = False

    @property
    def busy(self) -> bool:
        """See Worker."""
        return bool(self._results) or self._unfinished()

    @property
    def binding(self) -> bool:
        """See Worker."""
        running = self._running is not None and isinstance(self._running.request, BindRequest)
        return running or BindRequest in self._waiting

    def wait(self, timeout: float | None = None) -> bool:
        """See Worker."""
        deadline = None if timeout is None else time.monotonic() + timeout
        while True:
            self._advance()
            if self._results or not self._unfinished():
                return True
            left = PATIENCE if deadline is None else deadline - time.monotonic()
            if left <= 0:
                return False
            self._process.wait(min(left, PATIENCE))

    def close(self) -> None:
        """See Worker."""
        self.drop()
        self._closed = True
        self._running = None
        self._process.release()

    def _unfinished(self) -> bool:
        return bool(self._waiting) or (self._running is not None and self._running.wanted)

    def _advance(self) -> None:
        """Take an answer that has arrived, and give the process something to do."""
        if self._closed:
            return
        try:
            answer = self._process.receive()
            if answer is not None and self._running is not None:
                self._finish(result_of(self._running.request, answer))
            self._replace_slow()
            if self._running is None:
                self._begin()
        except ProcessDied:
            self._revive()

    def _begin(self) -> None:
        job = self._next()
        if job is not None:
            self._running = job
            try:
                self._process.send(job.request)
            except OSError as error:  # no memory, no process: it never began
                self._finish(Failure(job.request, WorkerError(f"the solver cannot work: {error}")))

    def _next(self) -> _Job | None:
        """Binds first. A refinement that the process cannot do needs the bind in use once more."""
        if BindRequest in self._waiting:
            return self._waiting.pop(BindRequest)
        job = self._waiting.get(RefineRequest)
        if job is None:
            return None
        assert isinstance(job.request, RefineRequest)
        wanted = job.request.version
        if self._used is not None and self._used.version == wanted != self._known:
            return _Job(self._used, wanted=False)
        del self._waiting[RefineRequest]
        return job if self._known == wanted else None  # None: its bind is no longer in use

    def _finish(self, result: Result) -> None:
        job, self._running = self._running, None
        assert job is not None
        if isinstance(job.request, BindRequest):  # one that fails leaves none to be refined
            self._known = job.request.version if isinstance(result, Bound) else None
        if job.wanted:
            self._deaths = 0
            if not (isinstance(result, Failure) and self._superseded(job)):
                self._results.append(result)
            if isinstance(result, Bound):
                self._used = result.request
        elif isinstance(result, Failure) and job.request is self._used:
            self._give_up(RefineRequest, result.error)  # it needed that bind

    def _superseded(self, job: _Job) -> bool:
        return isinstance(job.request, BindRequest) and BindRequest in self._waiting

    def _give_up(self, kind: type[Request], error: SolverError) -> None:
        job = self._waiting.pop(kind, None)
        if job is not None:
            self._results.append(Failure(job.request, error))

    def _replace_slow(self) -> None:
        job, following = self._running, self._waiting.get(BindRequest)
        if job is None or job.wanted or following is None:
            return
        assert isinstance(following.request, BindRequest)
        if not isinstance(job.request, BindRequest) or job.request.mesh == following.request.mesh:
            return
        if time.monotonic() - following.since > PATIENCE:
            self._stop()

    def _revive(self) -> None:
        """The process is gone: start another, which gets the request again."""
        job, worked = self._running, self._known is not None
        self._stop()
        if job is not None and job.wanted:
            self._waiting.setdefault(type(job.request), job)
        if self._waiting:
            self._deaths += 1
        if self._deaths >= ATTEMPTS:
            self._deaths = 0
            text = f"the solver stopped {ATTEMPTS} times while it worked on this"
            for kind in (BindRequest, RefineRequest):
                self._give_up(kind, WorkerError(text))
            return
        self._results.append(Restarted())
        if self._waiting or worked:  # else it may never work: not again before it is needed
            self._process.start()

    def _stop(self) -> None:
        self._process.stop()
        self._running = None
        self._known = None
