"""The size of the interface: how many pixels its measures are on this screen."""

from __future__ import annotations

import polyscope as ps

from app.model.preferences import LARGEST, SMALLEST


def scaled(length: float) -> float:
    """Pixels of a measure; every measure in this room is given for an interface of size 1."""
    return length * ps.get_ui_scale()


def set_scale(scale: float) -> None:
    """Draw the interface so many times as large, from the next frame on."""
    if scale != ps.get_ui_scale():
        ps.set_ui_scale(min(max(scale, SMALLEST), LARGEST))
