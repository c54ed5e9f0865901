"""The entries of K that come from attachments between pieces of the surface."""

from __future__ import annotations

import numpy as np

from solver.linear.constraints import Constraints
from solver.linear.rest_surface import RestSurface
from solver.types import BoolArray, FloatArray, IntArray

# The lower triangle of the 7 x 7 block of a term's first residual.
OWN_ROW, OWN_COLUMN = np.tril_indices(7)


class Joints:
    """The attachments in force that something can strain, as entries of K's lower triangle.

    rows, columns: (z,) places in K, rows >= columns; values there add up.
    faces: (j,) triangles whose frames they join.  links: (k, 2) those of each attachment.
    """

    def __init__(self, rest: RestSurface, constraints: Constraints) -> None:
        n = len(rest.vertices)
        attachments = constraints.attachments
        rows = attachments.rows(rest.faces, n)
        frames = n + 3 * np.column_stack([attachments.own_face, attachments.face])
        strained = _strained(constraints, np.column_stack([rows, frames]))
        self._attachments = attachments = attachments.where(strained)
        rows, frames = rows[strained], frames[strained]
        one, two = rows[:, OWN_ROW], rows[:, OWN_COLUMN]
        # A triangle that repeats a vertex: what stands beside the diagonal falls on it, twice.
        self._times = np.where((OWN_ROW != OWN_COLUMN) & (one == two), 2.0, 1.0)
        axes = np.arange(3)
        first, second = (frames[:, [side]] + axes for side in (0, 1))
        high, low = np.maximum(first, second), np.minimum(first, second)
        self.rows: IntArray = np.concatenate(
            [np.maximum(one, two), first, second, high], axis=1
        ).ravel()
        self.columns: IntArray = np.concatenate(
            [np.minimum(one, two), first, second, low], axis=1
        ).ravel()
        self.links = np.column_stack([attachments.own_face, attachments.face])
        self.faces = np.unique(self.links)

    def values(self, bending_length: float) -> FloatArray:
        """(z,) the entries at `rows`, `columns`."""
        c = self._attachments.coefficients
        weight = self._attachments.weight[:, None]
        first = weight * self._times * c[:, OWN_ROW] * c[:, OWN_COLUMN]
        link = bending_length**2 * weight * np.repeat([1.0, 1.0, -1.0], 3)
        return np.concatenate([first, link], axis=1).ravel()

    def bending(self, bending_length: float) -> FloatArray:
        """(k,) the weight of the second residual of each attachment."""
        return bending_length**2 * self._attachments.weight

    def stretching(self, face_count: int) -> FloatArray:
        """(m,) the sum over a triangle's attachments of a_b ||p_b - q||^2."""
        squares = self._attachments.weight * (self._attachments.offset**2).sum(axis=1)
        return np.bincount(self._attachments.face, squares, face_count).astype(np.float64)


def _strained(constraints: Constraints, rows: IntArray) -> BoolArray:
    """Which terms (k, r) of rows can be strained: not those that move as one."""
    group = constraints.row_group
    free = np.zeros(len(group), dtype=bool)
    free[constraints.free] = True
    return np.asarray(free[rows].any(axis=1) | (group[rows] != group[rows[:, :1]]).any(axis=1))
