"""Whether a process gets anywhere with what it was asked: its processor time grows."""

from __future__ import annotations

import time

import psutil

from app.worker.requests import BindRequest, Request

SILENCE = 10.0  # seconds that a process with a request may take no processor time at all
# Seconds for a request, and more a vertex: forty times what a bind takes. [docs/scaling.md]
LONGEST, LONGEST_EACH = 60.0, 2e-3
PAUSE = 0.25  # seconds between two looks
# A longer gap is not the process's: the window was stopped too, or the machine slept.
GAP = 4 * PAUSE


class Pulse:
    """Of one process with one request, as far as it has been looked at.

    spent: seconds since the request.
    """

    def __init__(self, pid: int | None, request: Request) -> None:
        self.spent = 0.0
        self._silent = 0.0
        self._pid = pid
        self._longest = LONGEST + LONGEST_EACH * _vertex_count(request)
        self._taken = self._processor_time()
        self._last = time.monotonic()

    @property
    def stands_still(self) -> bool:
        """Whether it has taken no time for SILENCE.

        A bind takes some, also where a factorisation lets no thread of Python's run; a process
        that is stopped or waits for itself takes none.
        """
        return self._silent > SILENCE

    @property
    def overdue(self) -> bool:
        """Whether it has taken so long that no answer is to be expected."""
        return self.spent > self._longest

    def look(self) -> None:
        """Once a frame or so."""
        now = time.monotonic()
        if now - self._last < PAUSE:
            return
        passed, self._last = min(now - self._last, GAP), now
        taken = self._processor_time()
        self.spent += passed
        self._silent = self._silent + passed if taken == self._taken else 0.0
        self._taken = taken

    def _processor_time(self) -> float:
        """Seconds; another number each time where the system does not say."""
        try:
            times = psutil.Process(self._pid).cpu_times()
        except psutil.Error:
            return time.monotonic()
        return float(times.user + times.system)


def _vertex_count(request: Request) -> int:
    if isinstance(request, BindRequest):
        return len(request.vertices)
    return request.vertex_count
