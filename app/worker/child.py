"""The solver's process: waits for requests of the window and meets them. No window is known here.

It ends with the window, however that ends: then the pipe between them closes.
"""

from __future__ import annotations

import signal
from multiprocessing.connection import Connection

from app.worker.service import SolverService
from app.worker.shared import Guest, Packed, unpack


def serve(connection: Connection) -> None:
    """Meet requests until the other side is gone."""
    # Ctrl+C in a terminal reaches both processes; the window decides what it means.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    service, guest = SolverService(), Guest()
    while True:
        try:
            name, parcel = connection.recv()
            memory = guest.attach(name)
            answer = service.answer(unpack(parcel, memory))
            connection.send(Packed(answer).put(memory))
        except (EOFError, OSError):
            return
