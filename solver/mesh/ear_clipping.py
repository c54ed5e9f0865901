"""Ear clipping, for many polygons of one size at once."""

from __future__ import annotations

import numpy as np

from solver.types import BoolArray, FloatArray, IntArray


def clip_ears(P: FloatArray) -> IntArray:
    """Split g polygons of k corners, (g, k, 3), into triangles (g, k-2, 3) of corner numbers.

    In the plane of its Newell normal, each polygon loses the ear with the shortest diagonal until
    a triangle is left. An ear is a corner that turns left and whose closed triangle holds no other
    corner. A polygon with no ear (it crosses itself, or has no area) loses its flattest corner, so
    every polygon is split.
    """
    g, k = P.shape[:2]
    ring = _Ring(flatten(P))
    cost = np.stack([ring.cost(np.full(g, i)) for i in range(k)], axis=1)
    rows = np.arange(g)
    result = np.empty((g, k - 2, 3), dtype=np.int64)
    for step in range(k - 3):
        i = cost.argmin(axis=1)
        before, after = ring.before[rows, i], ring.after[rows, i]
        result[:, step] = np.stack([before, i, after], axis=1)
        ring.remove(i)
        cost[rows, i] = np.inf
        cost[rows, before] = ring.cost(before)
        cost[rows, after] = ring.cost(after)
    last = ring.alive.argmax(axis=1)
    result[:, -1] = np.stack([last, ring.after[rows, last], ring.before[rows, last]], axis=1)
    return result


def flatten(P: FloatArray) -> FloatArray:
    """(g, k, 2) coordinates in the Newell plane, counter-clockwise, of size about 1."""
    P = P - P.mean(axis=1, keepdims=True)
    scale = np.abs(P).max(axis=(1, 2), keepdims=True)
    P = P / np.where(scale > 0, scale, 1)
    normal = np.cross(P, np.roll(P, -1, axis=1)).sum(axis=1)
    length = np.linalg.norm(normal, axis=1, keepdims=True)
    normal = np.where(length > 0, normal / np.where(length > 0, length, 1), [0.0, 0.0, 1.0])
    # The world axis farthest from the normal gives a well-defined first direction.
    axis = np.eye(3)[np.abs(normal).argmin(axis=1)]
    u = np.cross(axis, normal)
    u /= np.linalg.norm(u, axis=1, keepdims=True)
    return np.stack([np.einsum("gkc,gc->gk", P, w) for w in (u, np.cross(normal, u))], axis=2)


class _Ring:
    """What is left of each polygon: a doubly linked ring of corners."""

    def __init__(self, p: FloatArray) -> None:
        g, k = p.shape[:2]
        self.p = p
        self.rows = np.arange(g)
        self.before = np.tile((np.arange(k) - 1) % k, (g, 1))
        self.after = np.tile((np.arange(k) + 1) % k, (g, 1))
        self.alive: BoolArray = np.ones((g, k), dtype=bool)

    def remove(self, i: IntArray) -> None:
        before, after = self.before[self.rows, i], self.after[self.rows, i]
        self.after[self.rows, before] = after
        self.before[self.rows, after] = before
        self.alive[self.rows, i] = False

    def cost(self, i: IntArray) -> FloatArray:
        """Squared length of the diagonal that cuts corner i off; 100 or more if it is no ear."""
        a, b, c = (self.p[self.rows, j] for j in (self.before[self.rows, i], i, self._next(i)))
        area = _determinant(b - a, c - a)
        ear = (area > 1e-12) & ~self._holds_a_corner(a, b, c)
        # The tiny share of the corner's number keeps ties from being decided by rounding.
        return np.where(ear, ((c - a) ** 2).sum(axis=1) + 1e-9 * i, 100 + np.abs(area))

    def _next(self, i: IntArray) -> IntArray:
        return np.asarray(self.after[self.rows, i])

    def _holds_a_corner(self, a: FloatArray, b: FloatArray, c: FloatArray) -> BoolArray:
        """Whether a remaining corner lies in the closed triangle, away from its three corners."""
        a, b, c = a[:, None], b[:, None], c[:, None]
        inside = self.alive.copy()
        for start, end in ((a, b), (b, c), (c, a)):
            inside &= _determinant(end - start, self.p - start) >= -1e-12
            # A vertex that the polygon visits twice does not block the ear at its other visit.
            inside &= ((self.p - start) ** 2).sum(axis=2) > 1e-24
        return np.asarray(inside.any(axis=1))


def _determinant(a: FloatArray, b: FloatArray) -> FloatArray:
    """Of plane vectors: positive where b lies to the left of a."""
    return np.asarray(a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0])
