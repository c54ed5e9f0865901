"""What lies across an axis: two directions, and circles around it."""

from __future__ import annotations

import numpy as np

from solver.types import FloatArray


def across(axis: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Two unit vectors (3,) across an axis (3,) of any length but 0; u, v, axis is right-handed."""
    w = axis / np.linalg.norm(axis)
    u = np.cross(w, np.eye(3)[np.abs(w).argmin()])
    u /= np.linalg.norm(u)
    return u, np.cross(w, u)


def circle(centre: FloatArray, axis: FloatArray, radius: float, count: int) -> FloatArray:
    """(count, 3) corners of a circle, evenly spread and right-handed about its axis (3,)."""
    u, v = across(axis)
    angle = np.linspace(0.0, 2.0 * np.pi, count, endpoint=False)
    around = np.outer(np.cos(angle), u) + np.outer(np.sin(angle), v)
    return np.asarray(centre + radius * around)
