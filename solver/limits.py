"""How large numbers may be. What lies beyond is refused where it comes in.

Within these bounds squares and products of four stay far from the ends of float64, and a factor
of the system keeps digits enough; the residual of each bind says whether it did.
"""

from __future__ import annotations

import numpy as np

# Of a position, and of the diagonal of what faces use: beyond, squares of squares leave float64.
LARGEST_COORDINATE, SMALLEST_SIZE = 1e60, 1e-60
# Of what is opened: graphics cards have float32, and square lengths.
LARGEST_SHOWN, SMALLEST_SHOWN = 1e18, 1e-18
# A handle's linear part may turn, stretch, shear, mirror or flatten: its largest entry.
LARGEST_STRETCH = 1e3
# How far a handle takes the middle of the surface, or a point its target, in diagonals.
FARTHEST = 5e3
# Rounds of rotations. After some ten nothing moves any more.
HIGHEST_LEVEL = 1000
# The bending length, in diagonals.
SHORTEST_BEND, LONGEST_BEND = 1e-12, 1e3
# A gain on bending or stretching.
SMALLEST_GAIN, LARGEST_GAIN = 1e-6, 1e6


def within(value: float | np.number, low: float, high: float) -> bool:
    """Whether low <= value <= high; false for what is no number, whatever its size.

    >>> within(10**400, 0.0, 1.0), within(float("nan"), 0.0, 1.0)
    (False, False)
    """
    return bool(low <= value <= high)
