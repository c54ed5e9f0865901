"""Straight limbs, soft in the middle, of any resolution and triangulation."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.spatial import Delaunay

from assets.generator.primitives import grid_triangles, regular_triangles
from solver.geometry.topology import Topology
from solver.measure.sections import Section
from solver.softness.falloff import falloff
from solver.types import FloatArray, IntArray

# A limb lies along x from -HALF to HALF; what is beyond HELD is held; it is soft within BAND.
HALF, HELD, BAND = 4.0, 3.0, 1.0
SIDE = np.sqrt(np.pi)  # of the bar, whose section has the area of the tube's, of radius 1
# How far a vertex of an irregular limb may be off its place, in cells of the grid.
JITTER = 0.35


@dataclass(frozen=True)
class SoftLimb:
    """A closed mesh (n, 3), (m, 3)."""

    V: FloatArray
    F: IntArray

    @property
    def root(self) -> IntArray:
        return np.flatnonzero(self.V[:, 0] < 1e-9 - HELD)

    @property
    def tip(self) -> IntArray:
        return np.flatnonzero(self.V[:, 0] > HELD - 1e-9)

    @property
    def softness(self) -> FloatArray:
        """(n,) one in the middle, zero beyond the band, C1 at its rim."""
        return falloff(self.V[:, 0] / BAND)

    def turn(self, X: FloatArray, x: float) -> float:
        """By how many degrees the section at rest coordinate x has turned about z."""
        section = Section(self.V, self._edges, x)
        (rest, length), (now, _) = (_sides(section.ring(Y)) for Y in (self.V, X))
        y = rest[:, 1] - np.average(rest[:, 1], weights=length)
        axis = (length * y) @ now  # what the section's y axis has become
        return float(np.degrees(np.arctan2(-axis[0], axis[1])))

    def share(self, X: FloatArray, total: float) -> float:
        """Percent of a bend of `total` degrees that lies within the band."""
        return 100.0 * (self.turn(X, BAND) - self.turn(X, -BAND)) / total

    @cached_property
    def _edges(self) -> IntArray:
        return Topology(self.F, len(self.V)).edges


def _sides(ring: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Middles (k, 3) and lengths (k,) of the sides of a closed polyline (k, 3)."""
    after = np.roll(ring, -1, axis=0)
    return 0.5 * (ring + after), np.linalg.norm(after - ring, axis=1)


def circle(t: FloatArray) -> FloatArray:
    """(n, 2) the tube's section, t in [0, 1)."""
    return np.stack([np.cos(2 * np.pi * t), np.sin(2 * np.pi * t)], axis=1)


def square(t: FloatArray) -> FloatArray:
    """(n, 2) the bar's section, corners at multiples of a quarter."""
    corner, along = np.divmod(4 * t + 1e-12, 1)
    u = 2 * along - 1
    one = np.ones_like(u)
    sides = [np.stack(side, axis=1) for side in ((u, -one), (one, u), (-u, one), (-one, -u))]
    return 0.5 * SIDE * np.choose(corner.astype(np.int64)[:, None] % 4, sides)


OUTLINES: dict[str, Callable[[FloatArray], FloatArray]] = {"tube": circle, "bar": square}


def limb(shape: str, triangulation: str, along: int, around: int) -> SoftLimb:
    """A limb of (along + 1) x around vertices and two in its ends.

    shape: "tube" or "bar".  triangulation: "right", "alternating" or "irregular".
    along: a multiple of 8, so that held regions end on a row.  around: a multiple of 4.
    """
    row, column = (i.ravel() for i in np.indices((along + 1, around)))
    x, t = HALF * (2 * row / along - 1), column / around
    if triangulation == "irregular":
        x, t, F = _scattered(x, t, along, around)
    else:
        cells = np.arange(len(x)).reshape(along + 1, around)
        triangles = grid_triangles if triangulation == "alternating" else regular_triangles
        F = triangles(np.hstack([cells, cells[:, :1]]))
    V = np.column_stack([x, OUTLINES[shape](t)])
    ends = np.array([[-HALF, 0, 0], [HALF, 0, 0]])
    return SoftLimb(np.vstack([V, ends]), np.concatenate([F, _caps(len(x), around)]))


def _scattered(
    x: FloatArray, t: FloatArray, along: int, around: int
) -> tuple[FloatArray, FloatArray, IntArray]:
    """Vertices off their places, triangulated anew; ends, rims and corners stay where they are."""
    dx, dt = np.random.default_rng(0).uniform(-JITTER, JITTER, (2, len(x)))
    rims = np.isin(np.round(abs(x), 9), [HELD, HALF])
    corners = np.isclose(4 * t, np.round(4 * t))
    x = x + np.where(rims, 0.0, dx) * 2 * HALF / along
    t = t + np.where(rims | corners, 0.0, dt) / around
    n, height = len(x), 2 * np.pi
    copies = np.concatenate([np.column_stack([x, height * (t + turn)]) for turn in (-1, 0, 1)])
    F = Delaunay(copies).simplices.astype(np.int64)
    one, two = (copies[F[:, k]] - copies[F[:, 0]] for k in (1, 2))
    area = one[:, 0] * two[:, 1] - one[:, 1] * two[:, 0]
    F[area < 0] = F[area < 0][:, ::-1]
    middle = copies[F, 1].mean(axis=1)
    F = F[(abs(area) > 1e-9) & (middle >= 0) & (middle < height)] % n
    return x, t % 1.0, F


def _caps(n: int, around: int) -> IntArray:
    """Fans from the vertices n and n + 1 to the first and the last row."""
    here = np.arange(around)
    there = np.roll(here, -1)
    last = n - around
    low = np.stack([there, here, np.full(around, n)], axis=1)
    high = np.stack([here + last, there + last, np.full(around, n + 1)], axis=1)
    return np.concatenate([low, high])
