"""What works for the window: takes requests, returns at once, and gives results when they come."""

from __future__ import annotations

import time
from typing import Protocol

from app.worker.courier import ProcessDied
from app.worker.errand import Errand, Snapshot
from app.worker.process import GRACE, SolverProcess
from app.worker.queue import Job, Queue
from app.worker.requests import (
    BindRequest,
    Bound,
    Failure,
    Refined,
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

    def errand(self, snapshot: Snapshot) -> Errand:
        """Ask for one shape, whatever the document does meanwhile; returns at once.

        It gets on with each `poll`. One at a time: the one before is given up.
        """

    def wait(self, timeout: float | None = None) -> bool:
        """Block until there is something to poll or nothing is under way; False: too long."""

    def close(self) -> None:
        """End whatever runs; nothing will be polled any more."""


class ProcessWorker:
    """A worker in a process of its own: CHOLMOD would hold the window's global lock.

    It gets on whenever it is asked for anything, and never waits for the process. If that ends by
    itself, or stands still, another is started, and what it was doing is asked of that
    one, ATTEMPTS times in all.

    A superseded bind runs to its end, for the next bind of the mesh shares its ordering; ended
    half-way it would cost a new process and a bind from scratch. Only where the next bind is of
    another mesh, which shares nothing, the process is replaced after PATIENCE.
    """

    def __init__(self) -> None:
        self._process = SolverProcess()
        self._process.start()  # now, to load while the window opens
        self._queue = Queue()
        self._running: Job | None = None
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
        self._queue.add(request)
        self._advance()

    def errand(self, snapshot: Snapshot) -> Errand:
        """See Worker."""
        errand = Errand(snapshot)
        self._queue.add_errand(errand)
        self._advance()
        return errand

    def poll(self) -> list[Result]:
        """See Worker."""
        self._advance()
        results, self._results = self._results, []
        return results

    def drop(self) -> None:
        """See Worker."""
        self._queue.clear()
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
        return running or self._queue.bind is not None

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
        self._process.stop(GRACE)

    def _unfinished(self) -> bool:
        return bool(self._queue) or (self._running is not None and self._running.wanted)

    def _advance(self) -> None:
        """Take an answer that has arrived, and give the process something to do."""
        if self._closed:
            return
        try:
            answer = self._process.receive()
            if answer is not None and self._running is not None:
                self._finish(result_of(self._running.request, answer))
            self._end_hung()
            self._replace_slow()
            if self._running is None:
                self._begin()
        except ProcessDied:
            self._revive("stopped")
        except OSError as error:  # no memory, no process: the request never got there
            self._fail(f"the solver cannot work: {error}")

    def _begin(self) -> None:
        job = self._queue.next(self._known, self._used)
        if job is not None:
            self._running = job
            self._process.send(job.request)

    def _finish(self, result: Result) -> None:
        job, self._running = self._running, None
        assert job is not None
        if isinstance(job.request, BindRequest):  # one that fails leaves none to be refined
            self._known = job.request.version if isinstance(result, Bound) else None
        if job.needed:
            self._deaths = 0
        if job.errand is not None:
            if isinstance(result, Refined | Failure):  # else it was bound for what comes now
                job.errand.result = result
        elif job.wanted:
            superseded = isinstance(job.request, BindRequest) and self._queue.bind is not None
            if not (isinstance(result, Failure) and superseded):
                self._results.append(result)
            if isinstance(result, Bound):
                self._used = result.request
        elif isinstance(result, Failure) and job.request is self._used:
            self._give_up(RefineRequest, result.error)  # it needed that bind

    def _fail(self, reason: str) -> None:
        if self._running is not None:
            self._finish(Failure(self._running.request, WorkerError(reason)))

    def _give_up(self, kind: type[Request], error: SolverError) -> None:
        job = self._queue.take(kind)
        if job is not None:
            self._results.append(Failure(job.request, error))

    def _replace_slow(self) -> None:
        if self._running is not None and self._queue.held_up(self._running) > PATIENCE:
            self._stop()

    def _end_hung(self) -> None:
        """A process that stands still, or goes on for ever, has the request no longer."""
        if self._running is None:
            return
        pulse = self._process.pulse
        pulse.look()
        if pulse.stands_still:
            self._revive("did not answer")
        elif pulse.overdue:
            self._fail(f"the solver had no answer after {pulse.spent:.0f} s")
            self._stop()

    def _revive(self, what: str) -> None:
        """The process is of no use: start another, which gets the request again."""
        job, worked = self._running, self._known is not None
        self._stop()
        if job is not None:
            self._queue.put_back(job)
        errand = self._queue.errand
        if self._queue or errand is not None:
            self._deaths += 1
        if self._deaths >= ATTEMPTS:
            self._deaths = 0
            error = WorkerError(f"the solver {what} {ATTEMPTS} times while it worked on this")
            for kind in (BindRequest, RefineRequest):
                self._give_up(kind, error)
            if errand is not None:
                errand.result = Failure(errand.snapshot.refinement, error)
            return
        self._results.append(Restarted(what))
        if self._queue or errand is not None or worked:  # else it may never work: not yet again
            self._process.start()

    def _stop(self) -> None:
        self._process.stop()
        self._running = None
        self._known = None
