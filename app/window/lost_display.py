"""The display goes away: X ends a program that has lost it, which may first keep its work."""

from __future__ import annotations

import ctypes
import os
import sys
import traceback
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from app.telling import tell

LOST = 1  # the exit code, as X has it
_HANDLER = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p)


@contextmanager
def display_lost(keep: Callable[[], None]) -> Iterator[None]:
    """Meanwhile `keep` is called when the X server is gone, and then the program ends.

    It may not draw. Other systems tell a window to close, or end the program as signals do.
    """
    x11 = _library()
    if x11 is None:
        yield
        return

    def lost(display: int | None) -> int:
        try:
            tell("the display is gone", error=True)
            keep()
        except BaseException:  # nobody is there to hear of it any more
            traceback.print_exc()
        finally:
            os._exit(LOST)  # what X does, but without the ends of libraries that need a display

    handler = _HANDLER(lost)
    before = x11.XSetIOErrorHandler(handler)
    try:
        yield
    finally:
        x11.XSetIOErrorHandler(ctypes.c_void_p(before))


def _library() -> ctypes.CDLL | None:
    """The same that the window uses; None where none is."""
    if not sys.platform.startswith("linux"):
        return None
    try:
        x11 = ctypes.CDLL("libX11.so.6")
    except OSError:
        return None
    x11.XSetIOErrorHandler.restype = ctypes.c_void_p
    return x11
