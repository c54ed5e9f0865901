"""Small closed solids made of rings of vertices between two poles: balls, locks of hair."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy.interpolate import CubicSpline

from assets.generator.primitives import regular_triangles
from solver.types import FloatArray, IntArray


def closed(rings: FloatArray, first: FloatArray, last: FloatArray) -> tuple[FloatArray, IntArray]:
    """Rings (r, k, 3), counter-clockwise seen from the last pole, closed by the poles (3,)."""
    count, around = rings.shape[:2]
    index = np.arange(count * around).reshape(count, around)
    index = np.concatenate((index, index[:, :1]), axis=1)
    low, high = index[0], index[-1]
    start, end = np.full(around, count * around), np.full(around, count * around + 1)
    F = np.concatenate(
        (
            regular_triangles(index)[:, ::-1],
            np.stack((start, low[1:], low[:-1]), axis=1),
            np.stack((end, high[:-1], high[1:]), axis=1),
        )
    )
    return np.concatenate((rings.reshape(-1, 3), [first, last])), F


def circle(around: int) -> FloatArray:
    """(k, 2) points of the unit circle."""
    angle = 2 * np.pi * np.arange(around) / around
    return np.stack((np.cos(angle), np.sin(angle)), axis=1)


def ball(radii: Sequence[float], rings: int, around: int) -> tuple[FloatArray, IntArray]:
    """An ellipsoid about the origin with its poles on z."""
    angle = np.pi * np.arange(1, rings + 1) / (rings + 1)
    xy = np.sin(angle)[:, None, None] * circle(around)
    z = np.broadcast_to(-np.cos(angle)[:, None, None], (rings, around, 1))
    V, F = closed(np.concatenate((xy, z), axis=2), np.array([0, 0, -1.0]), np.array([0, 0, 1.0]))
    return V * radii, F


def lock(
    points: FloatArray, radius: float, sections: int, around: int
) -> tuple[FloatArray, IntArray]:
    """A tube through points (k, 3), thickest at its first third and pointed at its end."""
    path = CubicSpline(np.linspace(0, 1, len(points)), points)
    t = np.linspace(0.02, 0.98, sections)
    along = path(t, 1)
    along /= np.linalg.norm(along, axis=1, keepdims=True)
    side = np.cross(along, np.cross(points[-1] - points[0], [0.3, 0.5, 0.8]))
    side /= np.linalg.norm(side, axis=1, keepdims=True)
    thick = radius * np.sqrt(t) * (1 - t) ** 0.75 / 0.43
    c, s = circle(around).T[:, None, :, None]
    rings = path(t)[:, None] + thick[:, None, None] * (
        c * side[:, None] + s * np.cross(along, side)[:, None]
    )
    return closed(rings, points[0], points[-1])
