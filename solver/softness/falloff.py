"""How a brush or a soft band fades from its centre to its rim."""

from __future__ import annotations

import numpy as np

from solver.types import FloatArray


def falloff(t: FloatArray) -> FloatArray:
    """(1 - t^2)^2 for |t| <= 1, else 0: 1 at the centre, value and slope 0 at the rim."""
    return np.clip(1 - t**2, 0, None) ** 2
