"""Triangles on the border of a set of vertices."""

from __future__ import annotations

import numpy as np

from solver.types import BoolArray, IntArray


def crossed_triangles(F: IntArray, inside: BoolArray) -> IntArray:
    """(k, 3) those of triangles (m, 3) that have corners inside and outside.

    Turned so that the corner that is alone on its side is the first: the border crosses both edges
    at it.  inside: (n,) of each vertex.
    """
    within = inside[F]
    count = within.sum(axis=1)
    crossed = np.flatnonzero((count == 1) | (count == 2))
    within, alone = within[crossed], count[crossed] == 1
    first = np.where(alone, within.argmax(axis=1), within.argmin(axis=1))
    order = (first[:, None] + np.arange(3)) % 3
    return np.take_along_axis(F[crossed], order, axis=1)
