"""Workers without a process, for tests: nobody waits for a frame there."""

from __future__ import annotations

from app.worker.errand import Errand, Snapshot
from app.worker.requests import Failure, Refined, Request, Result, result_of
from app.worker.service import SolverService


class InlineWorker:
    """Meets every request at once, in the caller's process: where nobody waits for a frame."""

    binding = False

    def __init__(self) -> None:
        self._service = SolverService()
        self._results: list[Result] = []

    def request(self, request: Request) -> None:
        """See Worker; returns when it is done."""
        self._results.append(result_of(request, self._service.answer(request)))

    def poll(self) -> list[Result]:
        """See Worker."""
        results, self._results = self._results, []
        return results

    def drop(self) -> None:
        """See Worker."""
        self._results.clear()

    def errand(self, snapshot: Snapshot) -> Errand:
        """See Worker; returns when it is done. What is bound stays so."""
        service, done = SolverService(), Errand(snapshot)
        for request in (snapshot.bind, snapshot.refinement):
            result = result_of(request, service.answer(request))
            if isinstance(result, Failure | Refined):
                done.result = result
                return done
        return done

    @property
    def busy(self) -> bool:
        """See Worker."""
        return bool(self._results)

    def wait(self, timeout: float | None = None) -> bool:
        """See Worker."""
        return True

    def close(self) -> None:
        """See Worker."""


class SlowWorker(InlineWorker):
    """Takes its time with errands: each is done at the third poll."""

    def __init__(self) -> None:
        super().__init__()
        self._polls = 0
        self._slow: Errand | None = None

    def errand(self, snapshot: Snapshot) -> Errand:
        """See Worker."""
        self._polls, self._slow = 0, Errand(snapshot)
        return self._slow

    def poll(self) -> list[Result]:
        """See Worker."""
        self._polls += 1
        if self._slow is not None and self._slow.waits and self._polls == 3:
            self._slow.result = super().errand(self._slow.snapshot).result
        return super().poll()
