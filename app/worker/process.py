"""The window's end of the solver's process: starts it, sends requests, receives answers."""

from __future__ import annotations

import multiprocessing
import os
import signal
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from multiprocessing.connection import Connection
from multiprocessing.process import BaseProcess

from app.worker.child import serve
from app.worker.courier import Courier, ProcessDied
from app.worker.pulse import Pulse
from app.worker.requests import Answer, Request

# The same everywhere: Windows and macOS know no other safe way.
CONTEXT = multiprocessing.get_context("spawn")
# More threads gain a sparse factorisation nothing (measured), and where drawing keeps the
# processors busy they wait for each other: five times as long for a rigid level.
ONE_THREAD = ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "VECLIB_MAXIMUM_THREADS")
GRACE = 1.0  # seconds that a killed process has to be gone before nobody waits for it


def started(name: str, target: Callable[[Connection], None], theirs: Connection) -> BaseProcess:
    """A process that has its end of a pipe. Returns at once. Raises OSError where there is none."""
    process = CONTEXT.Process(target=target, args=(theirs,), name=name, daemon=True)
    with _in_environment(dict.fromkeys(ONE_THREAD, "1")), _interrupts_held():
        process.start()
    theirs.close()  # else the pipe would stay open when the process is gone
    return process


class SolverProcess:
    """One process and its courier; at most one request on its way at a time. Nothing here waits."""

    def __init__(self) -> None:
        self._process: BaseProcess | None = None
        self._courier: Courier | None = None
        self._pulse: Pulse | None = None
        self._killed: BaseProcess | None = None

    @property
    def pulse(self) -> Pulse:
        """Whether it gets anywhere with the last request."""
        assert self._pulse is not None
        return self._pulse

    @property
    def pid(self) -> int | None:
        """The system's number of the process, None when there is none."""
        return self._process.pid if self._process else None

    def start(self) -> None:
        """Have a process, a new one if there is none. Returns at once, while it still loads.

        Raises OSError where the system gives none.
        """
        if self._process is not None:
            return
        ours, theirs = CONTEXT.Pipe()
        self._process, self._courier = started("solver", serve, theirs), Courier(ours)

    def send(self, request: Request) -> None:
        """Hand over a request. Raises OSError where there is no process."""
        self.start()
        assert self._courier is not None
        self._pulse = Pulse(self.pid, request)
        self._courier.carry(request)

    def receive(self) -> Answer | None:
        """The answer to the request, None as long as there is none.

        Raises ProcessDied, or OSError where there was no memory to hand the request over.
        """
        if self._killed is not None and not self._killed.is_alive():  # asking takes note of it
            self._killed = None
        if self._courier is None or self._process is None:
            return None
        answer = self._courier.answer()
        if answer is None and not self._process.is_alive():
            raise ProcessDied
        return answer

    def wait(self, timeout: float) -> None:
        """Block until there is something to receive, or `timeout` seconds have passed."""
        if self._courier is not None:
            self._courier.wait(timeout)

    def stop(self, grace: float = 0.0) -> None:
        """End the process at once, whatever it does: it owns nothing that could be left behind.

        grace: seconds to wait until it is gone, at most.
        """
        process, courier = self._process, self._courier
        self._process = self._courier = None
        if process is not None and courier is not None:
            process.kill()
            courier.end(grace)
            process.join(grace)
            self._killed = process


@contextmanager
def _in_environment(values: dict[str, str]) -> Iterator[None]:
    """Processes started within see these variables too, unless somebody has set them already."""
    added = {name: value for name, value in values.items() if name not in os.environ}
    os.environ.update(added)
    try:
        yield
    finally:
        for name in added:
            del os.environ[name]


@contextmanager
def _interrupts_held() -> Iterator[None]:
    """A process started within hears no Ctrl+C, also before it can say that it wants none.

    It reaches all processes of a terminal. This one hears it afterwards.
    """
    if sys.platform == "win32":
        yield
        return
    from multiprocessing import resource_tracker

    resource_tracker.ensure_running()  # it would be started within, and lets all signals through
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)
