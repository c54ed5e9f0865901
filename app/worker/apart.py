"""A function in a process of its own: one that keeps the interpreter would hold up the window."""

from __future__ import annotations

import contextlib
import traceback
from collections.abc import Callable, Generator
from multiprocessing.connection import Connection
from threading import Thread
from typing import Any, TypeVar

from app.worker.child import belong_to_window
from app.worker.process import CONTEXT, started
from app.worker.requests import WorkerError
from solver.errors import SolverError
from solver.mesh.progress import Progress

T = TypeVar("T")


def apart(work: Callable[[Any, Progress], T], given: Any) -> Generator[float, None, T]:
    """What `work` returns or raises; yields how far it is. Its process ends where this is closed.

    work: a module's function of what is given and of what it tells how far it is, from 0 to 1.
    Raises WorkerError where its process does not get to an end.
    """
    ours, theirs = CONTEXT.Pipe()
    process = started("apart", _serve, theirs)
    # In a thread: what is given may be large, and the process reads it when it has loaded.
    Thread(target=_send, args=(ours, (work, given)), name="apart", daemon=True).start()
    try:
        fraction = 0.0
        while True:
            if not ours.poll():
                yield fraction
                continue
            done, said = ours.recv()
            if isinstance(said, SolverError):
                raise said
            if done:
                outcome: T = said
                return outcome
            fraction = said
    except (EOFError, OSError) as error:
        raise WorkerError("the process that did it has ended before it was done") from error
    finally:
        process.kill()
        ours.close()


def _send(connection: Connection, message: object) -> None:
    with contextlib.suppress(OSError):  # nobody waits for it any more
        connection.send(message)


def _serve(connection: Connection) -> None:
    """Of the process: do what is asked, and say what came of it."""
    belong_to_window()
    said: object
    try:
        work, given = connection.recv()
        try:
            said = work(given, lambda fraction: connection.send((False, fraction)))
        except SolverError as error:
            said = error
        connection.send((True, said))
    except (EOFError, OSError):  # the window is gone
        return
    except Exception as error:
        traceback.print_exc()
        connection.send((True, WorkerError(f"{type(error).__name__}: {error}")))
