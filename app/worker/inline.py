"""A worker without a process, for tests and for scripts that nobody watches."""

from __future__ import annotations

from app.worker.bench import Bench
from app.worker.requests import Request, Result, result_of


class InlineWorker:
    """Meets every request at once, in the caller's process: where nobody waits for a frame."""

    binding = False

    def __init__(self) -> None:
        self._bench = Bench()
        self._results: list[Result] = []

    def request(self, request: Request) -> None:
        """See Worker; returns when it is done."""
        self._results.append(result_of(request, self._bench.answer(request)))

    def poll(self) -> list[Result]:
        """See Worker."""
        results, self._results = self._results, []
        return results

    def drop(self) -> None:
        """See Worker."""
        self._results.clear()

    @property
    def busy(self) -> bool:
        """See Worker."""
        return bool(self._results)

    def wait(self, timeout: float | None = None) -> bool:
        """See Worker."""
        return True

    def close(self) -> None:
        """See Worker."""
