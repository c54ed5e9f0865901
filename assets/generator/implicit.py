"""Implicit solids: negative inside, positive outside, blended by smooth unions."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import reduce

import numpy as np
from scipy.interpolate import PchipInterpolator

from solver.types import FloatArray

Field = Callable[[FloatArray], FloatArray]
"""Takes (n, 3) points, returns (n,) values; the zero level is the surface, in units of length."""


def ellipsoid(centre: Sequence[float], radii: Sequence[float]) -> Field:
    """Ellipsoid with axes along the world's; scaled so that the gradient is about 1 near it."""
    c, r = np.asarray(centre), np.asarray(radii)

    def value(p: FloatArray) -> FloatArray:
        q = (p - c) / r
        length = np.linalg.norm(q, axis=1)
        gradient = np.linalg.norm(q / r, axis=1)
        return np.asarray(length * (length - 1) / np.maximum(gradient, 1e-9))

    return value


def cone(a: Sequence[float], b: Sequence[float], ra: float, rb: float) -> Field:
    """A segment from `a` to `b` whose thickness goes evenly from `ra` to `rb`, with round ends."""
    start, axis = np.asarray(a), np.subtract(b, a)

    def value(p: FloatArray) -> FloatArray:
        t = np.clip((p - start) @ axis / (axis @ axis), 0, 1)
        off = p - start - t[:, None] * axis
        return np.asarray(np.linalg.norm(off, axis=1) - (ra + t * (rb - ra)))

    return value


def loft(axis: int, u: int, v: int, table: Sequence[Sequence[float]]) -> Field:
    """Elliptic sections along a coordinate axis, closed by round caps.

    Each row of `table` is one section: place on `axis`, centre on axes `u` and `v`, half widths
    along `u` and `v`. Monotone cubics run between the rows, so nothing overshoots them.
    """
    rows = np.asarray(table)
    sections = PchipInterpolator(rows[:, 0], rows[:, 1:])

    def value(p: FloatArray) -> FloatArray:
        t = np.clip(p[:, axis], rows[0, 0], rows[-1, 0])
        cu, cv, ru, rv = sections(t).T
        thin = np.minimum(ru, rv)
        q = np.stack(((p[:, u] - cu) / ru, (p[:, v] - cv) / rv, (p[:, axis] - t) / thin))
        return np.asarray((np.linalg.norm(q, axis=0) - 1) * thin)

    return value


def smooth_minimum(a: FloatArray, b: FloatArray, k: float) -> FloatArray:
    """C2 minimum: differs from the plain one where the two are within `k` of each other."""
    h = np.maximum(k - np.abs(a - b), 0) / k
    return np.minimum(a, b) - h**3 * k / 6


def union(k: float, *fields: Field) -> Field:
    """Smooth union with blends of width about `k`."""
    return lambda p: reduce(lambda a, b: smooth_minimum(a, b, k), (f(p) for f in fields))


def chain(k: float, points: Sequence[Sequence[float]], radii: Sequence[float]) -> Field:
    """Cones from each point to the next, with the given radii at the points."""
    ends = zip(points[:-1], points[1:], radii[:-1], radii[1:], strict=True)
    return union(k, *(cone(a, b, ra, rb) for a, b, ra, rb in ends))


def cut(k: float, solid: Field, tool: Field) -> Field:
    """`solid` without `tool`, the rim rounded over about `k`."""
    return lambda p: -smooth_minimum(-solid(p), tool(p), k)


def mirrored(field: Field, k: float) -> Field:
    """Smooth union of a solid with its mirror image in the plane x = 0."""
    flip = np.array([-1.0, 1.0, 1.0])
    return lambda p: smooth_minimum(field(p), field(p * flip), k)


def gradient(field: Field, p: FloatArray, step: float = 1e-4) -> FloatArray:
    """Central differences, (n, 3)."""
    offsets = step * np.eye(3)
    return np.stack([(field(p + o) - field(p - o)) / (2 * step) for o in offsets], axis=1)


def project(field: Field, p: FloatArray, rounds: int = 4) -> FloatArray:
    """Points moved onto the zero level by Newton steps along the gradient."""
    for _ in range(rounds):
        g = gradient(field, p)
        p = p - (field(p) / np.maximum((g * g).sum(axis=1), 0.05))[:, None] * g
    return p
