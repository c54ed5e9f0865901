"""The window's end of the solver's process: starts it, sends requests, receives answers."""

from __future__ import annotations

import multiprocessing
import os
import signal
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from multiprocessing.connection import Connection, wait
from multiprocessing.process import BaseProcess

from app.worker.child import serve
from app.worker.requests import Answer, Request
from app.worker.shared import Block, Packed, unpack

# The same everywhere: Windows and macOS know no other safe way.
CONTEXT = multiprocessing.get_context("spawn")
# More threads gain a sparse factorisation nothing (measured), and where drawing keeps the
# processors busy they wait for each other: five times as long for a rigid level.
ONE_THREAD = ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "VECLIB_MAXIMUM_THREADS")


class ProcessDied(Exception):
    """The process ended without being told to."""


class SolverProcess:
    """One process, one pipe, one block of memory; at most one request on its way at a time.

    Messages are small, the arrays lie in the memory: sending never waits for the other side.
    """

    def __init__(self) -> None:
        self._block = Block()
        self._process: BaseProcess | None = None
        self._connection: Connection | None = None

    @property
    def pid(self) -> int | None:
        """The system's number of the process, None when there is none."""
        return self._process.pid if self._process else None

    def start(self) -> None:
        """Have a process, a new one if there is none. Returns at once, while it still loads."""
        if self._process is not None:
            return
        ours, theirs = CONTEXT.Pipe()
        process = CONTEXT.Process(target=serve, args=(theirs,), name="solver", daemon=True)
        with _in_environment(dict.fromkeys(ONE_THREAD, "1")), _interrupts_held():
            process.start()
        theirs.close()  # else the pipe would stay open when the process is gone
        self._process, self._connection = process, ours

    def send(self, request: Request) -> None:
        """Hand over a request. Raises ProcessDied."""
        self.start()
        assert self._connection is not None
        packed = Packed(request)
        memory = self._block.of_size(max(packed.size, request.answer_size))
        try:
            self._connection.send((memory.name, packed.put(memory)))
        except OSError as error:
            raise ProcessDied from error

    def receive(self) -> Answer | None:
        """The answer to the request, None as long as there is none. Raises ProcessDied."""
        if self._connection is None:
            return None
        try:
            if not self._connection.poll():
                return None
            parcel = self._connection.recv()
        except (EOFError, OSError) as error:
            raise ProcessDied from error
        answer: Answer = unpack(parcel, self._block.memory)
        return answer

    def wait(self, timeout: float | None) -> None:
        """Block until there is something to receive, or `timeout` seconds have passed."""
        if self._connection is not None:
            wait([self._connection], timeout)

    def stop(self) -> None:
        """End the process at once, whatever it does: it owns nothing that could be left behind."""
        if self._process is None or self._connection is None:
            return
        self._connection.close()
        self._process.kill()
        self._process.join()
        self._process.close()
        self._process = self._connection = None
        self._block.release()  # another process could not find it

    def release(self) -> None:
        """End the process and give back the memory."""
        self.stop()
        self._block.release()


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
