"""The solver's process: waits for requests of the window and meets them. No window is known here.

It ends with the window, however that ends: then the pipe between them closes.
"""

from __future__ import annotations

import contextlib
import ctypes
import os
import signal
import sys
from multiprocessing.connection import Connection

from app.worker.service import SolverService
from app.worker.shared import Guest, Packed, unpack

PR_SET_PDEATHSIG = 1


def serve(connection: Connection) -> None:
    """Meet requests until the other side is gone."""
    belong_to_window()
    service, guest = SolverService(), Guest()
    while True:
        try:
            name, parcel = connection.recv()
            memory = guest.attach(name)
            answer = service.answer(unpack(parcel, memory))
            connection.send(Packed(answer).put(memory))
        except (EOFError, OSError):
            return


def belong_to_window() -> None:
    """Of a process: end with the window, and leave to it what a terminal says."""
    # Ctrl+C and the like in a terminal reach both processes; the window decides what they mean.
    for key in ("SIGINT", "SIGQUIT"):
        if hasattr(signal, key):
            signal.signal(getattr(signal, key), signal.SIG_IGN)
    _end_with_parent()


def _end_with_parent() -> None:
    """Where the system can be asked for it: the bind of a window that is gone would go on."""
    if not sys.platform.startswith("linux"):
        return
    parent = os.getppid()
    with contextlib.suppress(OSError, AttributeError):
        ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGKILL)
    if os.getppid() != parent:  # it ended just before
        os._exit(1)
