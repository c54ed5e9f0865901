"""The bounding box of a shape: lengths are given as shares of its diagonal."""

from __future__ import annotations

import numpy as np

from solver.types import FloatArray


def diagonal(points: FloatArray) -> float:
    """Of the axis-aligned box around points (k, 3)."""
    return float(np.linalg.norm(np.ptp(points, axis=0)))


def middle(points: FloatArray) -> FloatArray:
    """(3,) of the axis-aligned box around points (k, 3)."""
    return np.asarray(0.5 * (points.min(axis=0) + points.max(axis=0)))
