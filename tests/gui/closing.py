"""What a window manager sends when a person closes a window; xdotool has no word for it."""

from __future__ import annotations

import ctypes

CLIENT_MESSAGE = 33


class _ClientMessage(ctypes.Structure):
    """XClientMessageEvent of Xlib, padded to the size of XEvent."""

    _fields_ = (
        ("type", ctypes.c_int),
        ("serial", ctypes.c_ulong),
        ("send_event", ctypes.c_int),
        ("display", ctypes.c_void_p),
        ("window", ctypes.c_ulong),
        ("message_type", ctypes.c_ulong),
        ("format", ctypes.c_int),
        ("data", ctypes.c_long * 5),
        ("padding", ctypes.c_long * 12),
    )


# An X error ends a program unless somebody hears of it; a window that is gone needs no closing.
_heard = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p, ctypes.c_void_p)(lambda *_: 0)


def request_close(display: str, window: int) -> None:
    """Ask the window to close (WM_DELETE_WINDOW); it may refuse or take its time."""
    x11 = ctypes.CDLL("libX11.so.6")
    x11.XSetErrorHandler(_heard)
    x11.XOpenDisplay.restype = ctypes.c_void_p
    x11.XInternAtom.restype = ctypes.c_ulong
    connection = ctypes.c_void_p(x11.XOpenDisplay(display.encode()))
    event = _ClientMessage(type=CLIENT_MESSAGE, window=window, format=32)
    event.message_type = x11.XInternAtom(connection, b"WM_PROTOCOLS", 0)
    event.data[0] = x11.XInternAtom(connection, b"WM_DELETE_WINDOW", 0)
    no_mask = ctypes.c_long(0)
    x11.XSendEvent(connection, ctypes.c_ulong(window), 0, no_mask, ctypes.byref(event))
    x11.XCloseDisplay(connection)
