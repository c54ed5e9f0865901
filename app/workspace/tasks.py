"""What takes longer than a frame: it goes on in steps, and the window draws and answers meanwhile.

The steps are a generator that yields how far it is, from 0 to 1, or None where nobody can tell.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Generator, Hashable
from concurrent.futures import Future
from threading import Event, Thread
from typing import TypeVar

from solver.errors import SolverError
from solver.mesh.progress import Progress

T = TypeVar("T")
Steps = Generator[float | None, None, T]


class Cancelled(SolverError):
    """Thrown into steps: a person takes back what they do."""


class Closing(SolverError):
    """Thrown into steps: the program ends. What has to be waited for is given up."""


class Task:
    """Steps under way. name: what they do, say "Exporting a.obj".  fraction: how far they are.

    since: when they began.
    """

    def __init__(self, name: str, steps: Steps[None]) -> None:
        self.name = name
        self.fraction: float | None = None
        self.since = time.monotonic()
        self._steps = steps
        self._thrown: SolverError | None = None

    def go_on(self) -> bool:
        """A step; whether it was the last. Raises what goes wrong."""
        thrown, self._thrown = self._thrown, None
        try:
            self.fraction = next(self._steps) if thrown is None else self._steps.throw(thrown)
        except StopIteration:
            return True
        return False

    def throw(self, error: SolverError) -> None:
        """Let the next step begin with this error: most end with it."""
        self._thrown = error


class Tasks:
    """What is under way in a workspace: one task at a time, the others wait for their turn.

    now: that one, None where nothing is.
    """

    def __init__(self, say: Callable[[str], None]) -> None:
        """say: what tells a person that one was cancelled."""
        self.now: Task | None = None
        self._say = say
        self._waiting: dict[tuple[str, Hashable], Steps[None]] = {}

    def begin(self, name: str, steps: Steps[None], about: Hashable = None) -> None:
        """Do the first step, or wait, in place of one of this name that is about the same.

        Raises what goes wrong.
        """
        if self.now is not None:
            self._waiting[name, about] = steps
            return
        self.now = Task(name, steps)
        self.advance()

    def advance(self) -> None:
        """Once a frame: do a step. Raises what goes wrong with it; then the task is over."""
        task, self.now = self.now, None
        try:
            if task is not None and not task.go_on():
                self.now = task
        except Cancelled:
            assert task is not None
            self._say(f"{task.name} was cancelled")
        finally:
            if self.now is None and self._waiting:
                first = next(iter(self._waiting))
                self.now = Task(first[0], self._waiting.pop(first))

    def cancel(self) -> None:
        """Take back what is under way; what waits for it begins."""
        if self.now is not None:
            self.now.throw(Cancelled())
            self.advance()

    def close(self) -> list[str]:
        """End all, but for a file that is being written; the names of what was not done.

        Raises what goes wrong.
        """
        task, self.now = self.now, None
        undone, self._waiting = [name for name, _ in self._waiting], {}
        over = task is None
        try:
            while task is not None and not over:
                task.throw(Closing())
                over = task.go_on()
        except Closing:
            return [task.name, *undone] if task is not None else undone
        except Cancelled:  # by a person, just before
            return undone
        return undone


def in_background(work: Callable[[Progress], T], start: float = 0.0) -> Steps[T]:
    """What a function returns or raises that runs in a thread. It is done also where it is closed.

    work: is given what it tells how far it is, which raises Cancelled where it has to end.
    start: how far the task is when it begins; it takes it to its end.
    """
    outcome: Future[T] = Future()
    cancelled, told = Event(), [0.0]

    def tell(fraction: float) -> None:
        if cancelled.is_set():
            raise Cancelled
        told[0] = fraction

    def run() -> None:
        try:
            outcome.set_result(work(tell))
        except BaseException as error:
            outcome.set_exception(error)

    thread = Thread(target=run, name="task")
    thread.start()
    while thread.is_alive():
        try:
            yield start + (1.0 - start) * told[0]
        except Cancelled:
            cancelled.set()
        except Closing:
            thread.join()
    return outcome.result()
