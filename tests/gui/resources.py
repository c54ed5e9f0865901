"""What a desktop tells all programs about its screen; no tool of the tests has a word for it."""

from __future__ import annotations

import ctypes

STRING, REPLACE = 31, 0  # of Xlib


def set_resolution(display: str, dots_per_inch: int) -> None:
    """Say how fine the screen is; 96 is an ordinary one. For programs that start afterwards."""
    x11 = ctypes.CDLL("libX11.so.6")
    x11.XOpenDisplay.restype = ctypes.c_void_p
    x11.XInternAtom.restype = x11.XDefaultRootWindow.restype = ctypes.c_ulong
    connection = ctypes.c_void_p(x11.XOpenDisplay(display.encode()))
    root = ctypes.c_ulong(x11.XDefaultRootWindow(connection))
    name = ctypes.c_ulong(x11.XInternAtom(connection, b"RESOURCE_MANAGER", 0))
    text = f"Xft.dpi:\t{dots_per_inch}\n".encode()
    kind = ctypes.c_ulong(STRING)
    x11.XChangeProperty(connection, root, name, kind, 8, REPLACE, text, len(text))
    x11.XSync(connection, 0)
    # Without this the server forgets what a client said when the last one leaves.
    x11.XSetCloseDownMode(connection, 1)
    x11.XCloseDisplay(connection)
