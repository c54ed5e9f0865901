"""Which points lie inside a loop drawn over the scene."""

from __future__ import annotations

import numpy as np

from solver.types import BoolArray, FloatArray


def inside_loop(points: FloatArray, corners: FloatArray) -> BoolArray:
    """(n,) which of the points (n, 2) lie inside the closed loop through corners (k, 2).

    By the parity of the edges to the right of a point: where a loop crosses itself, what it goes
    around twice is outside. A point that is NaN is outside. Each edge only looks at the points
    of its own heights, so that a long loop around a million points takes no longer than a box.
    """
    inside = np.zeros(len(points), dtype=bool)
    low, high = corners.min(axis=0, initial=np.inf), corners.max(axis=0, initial=-np.inf)
    near = np.flatnonzero(((points >= low) & (points <= high)).all(axis=1))
    near = near[np.argsort(points[near, 1])]
    x, y = points[near].T
    odd = np.zeros(len(near), dtype=bool)
    starts, ends = corners, np.roll(corners, -1, axis=0)
    lower = np.searchsorted(y, np.minimum(starts[:, 1], ends[:, 1]))
    upper = np.searchsorted(y, np.maximum(starts[:, 1], ends[:, 1]))
    for (x0, y0), (x1, y1), first, last in zip(starts, ends, lower, upper, strict=True):
        if first < last:
            crossing = x0 + (x1 - x0) * (y[first:last] - y0) / (y1 - y0)
            odd[first:last] ^= x[first:last] < crossing
    inside[near] = odd
    return inside
