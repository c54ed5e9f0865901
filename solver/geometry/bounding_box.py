"""The size of a shape: lengths are given as shares of its bounding box's diagonal."""

from __future__ import annotations

import numpy as np

from solver.types import FloatArray


def diagonal(points: FloatArray) -> float:
    """Of the axis-aligned box around points (k, 3)."""
    return float(np.linalg.norm(np.ptp(points, axis=0)))
