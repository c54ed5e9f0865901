"""The system tells the program to end: at a log-out, by a closed terminal, by Ctrl+C there."""

from __future__ import annotations

import signal
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType

ENDING = "SIGINT", "SIGTERM", "SIGHUP", "SIGQUIT"  # no system has to know all of them


@contextmanager
def interrupts_held() -> Iterator[None]:
    """Ctrl+C meanwhile counts afterwards: for what would be left in pieces."""
    held: list[int] = []
    before = signal.signal(signal.SIGINT, lambda number, frame: held.append(number))
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)
        if held:
            signal.raise_signal(signal.SIGINT)


@contextmanager
def told_to_end() -> Iterator[list[int]]:
    """The signals received meanwhile: none of them ends the program, which may first save.

    One that comes once more does. What was ignored before still is.
    """
    told: list[int] = []

    def hear(number: int, frame: FrameType | None) -> None:
        told.append(number)
        signal.signal(number, signal.SIG_DFL)

    known = [getattr(signal, name) for name in ENDING if hasattr(signal, name)]
    before = {number: signal.getsignal(number) for number in known}
    heard = [number for number in known if before[number] != signal.SIG_IGN]
    for number in heard:
        signal.signal(number, hear)
    try:
        yield told
    finally:
        for number in heard:
            signal.signal(number, before[number])
