"""Carries requests to a process and answers back, in a thread: a pipe may be full or half read."""

from __future__ import annotations

import threading
from multiprocessing.connection import Connection
from queue import Empty, SimpleQueue

from app.worker.requests import Answer, Request
from app.worker.shared import Block, Packed, unpack


class ProcessDied(Exception):
    """The process ended without being told to."""


class Courier:
    """One end of a pipe, and a block of memory beside it; at most one request on its way at a time.

    Messages are small, the arrays lie in the memory, where there is enough of it. A process that
    stands still keeps the thread waiting, and nobody else.
    """

    def __init__(self, connection: Connection) -> None:
        self._connection = connection
        self._requests: SimpleQueue[Request | None] = SimpleQueue()
        self._answers: SimpleQueue[Answer | Exception] = SimpleQueue()
        self._arrived = threading.Event()
        # A daemon: the end of the program does not wait for a process that stands still.
        self._thread = threading.Thread(target=self._work, name="courier", daemon=True)
        self._thread.start()

    def carry(self, request: Request) -> None:
        """Hand over a request; returns at once."""
        self._requests.put(request)

    def answer(self) -> Answer | None:
        """What has come back, None as long as nothing has.

        Raises ProcessDied, or OSError where the request could not be handed over.
        """
        self._arrived.clear()
        try:
            answer = self._answers.get_nowait()
        except Empty:
            return None
        if isinstance(answer, Exception):
            raise answer
        return answer

    def wait(self, timeout: float) -> None:
        """Block until something has come back, or `timeout` seconds have passed."""
        self._arrived.wait(timeout)

    def end(self, grace: float = 0.0) -> None:
        """Give all back, as soon as the process is gone: it may be waited for so many seconds."""
        self._requests.put(None)
        if grace:
            self._thread.join(grace)

    def _work(self) -> None:
        block = Block()
        while (request := self._requests.get()) is not None:
            answer: Answer | Exception
            try:
                answer = self._carry(request, block)
            except Exception as error:  # of a thread: nobody else would hear of it
                answer = error
            self._answers.put(answer)
            self._arrived.set()
        self._connection.close()
        block.release()  # another process could not find it

    def _carry(self, request: Request, block: Block) -> Answer:
        packed = Packed(request)
        memory = block.of_size(max(packed.size, request.answer_size))
        parcel = packed.put(memory)
        try:
            self._connection.send((memory.name, parcel))
            parcel = self._connection.recv()
        except (EOFError, OSError) as error:
            raise ProcessDied from error
        answer: Answer = unpack(parcel, memory)
        return answer
