"""What makes a deformed surface good: numbers of one result X against the rest shape."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from solver import fundamental_forms
from solver.types import BoolArray, FloatArray, IntArray

# A triangle of less than this share of its rest area counts as collapsed.
COLLAPSED = 1e-3
# A surface counts as closed with fewer boundary edges than this share: pinholes hold no volume.
OPEN = 0.01


@dataclass(frozen=True)
class Metrics:
    """strain: rms of l'/l - 1 over edges with a free vertex.  dihedral: rms of the change of
    dihedral angles there, radians.  volume: ratio to rest, NaN for an open surface.
    broken: triangles with a free vertex that are collapsed or turned against a neighbour.
    """

    strain: float
    dihedral: float
    volume: float
    broken: int


def measure(V: FloatArray, F: IntArray, free: BoolArray, X: FloatArray) -> Metrics:
    """Metrics of X (n, 3); free: (n,) the vertices that are not constrained."""
    rest, now = fundamental_forms(V, F), fundamental_forms(X, F)
    edges = free[rest.edges].any(axis=1)
    strain = (now.lengths / rest.lengths - 1)[edges]
    turn = np.angle(np.exp(1j * (now.dihedral_angles - rest.dihedral_angles)))[edges]
    closed = np.isnan(rest.dihedral_angles).mean() < OPEN
    return Metrics(
        float(np.sqrt(np.mean(strain**2))),
        float(np.sqrt(np.nanmean(turn**2))),
        volume(X, F) / volume(V, F) if closed else np.nan,
        broken_triangles(V, F, free, X),
    )


def broken_triangles(V: FloatArray, F: IntArray, free: BoolArray, X: FloatArray) -> int:
    """Triangles that lost their area, or whose normal turned by more than 90 degrees against
    that of a neighbour more than it was turned at rest.
    """
    rest, now = _normals(V, F), _normals(X, F)
    area, area_now = np.linalg.norm(rest, axis=1), np.linalg.norm(now, axis=1)
    broken = area_now < COLLAPSED * area
    pairs = _neighbours(F)
    before = np.einsum("ij,ij->i", *rest[pairs.T])
    after = np.einsum("ij,ij->i", *now[pairs.T])
    broken[pairs[(before > 0) & (after < 0)].ravel()] = True
    return int((broken & free[F].any(axis=1)).sum())


def _normals(X: FloatArray, F: IntArray) -> FloatArray:
    a, b, c = X[F.T]
    return np.cross(b - a, c - a)


def _neighbours(F: IntArray) -> IntArray:
    """(k, 2) the triangles that share an edge, two by two."""
    sides = np.sort(np.concatenate((F[:, [0, 1]], F[:, [1, 2]], F[:, [2, 0]])), axis=1)
    face = np.tile(np.arange(len(F)), 3)
    order = np.lexsort(sides.T)
    same = (sides[order][1:] == sides[order][:-1]).all(axis=1)
    return np.column_stack((face[order][:-1][same], face[order][1:][same]))


def volume(X: FloatArray, F: IntArray) -> float:
    """The volume inside a closed surface."""
    a, b, c = X[F.T]
    return float(np.einsum("ij,ij->", a, np.cross(b, c)) / 6)


@dataclass(frozen=True)
class Fold:
    """Of a folded limb: the share of the bend inside a band around the joint, and the smallest
    area of a cross-section in it against rest.
    """

    share: float
    section: float


class Limb:
    """A tube along the rest x axis, cut into slices; a slice of rest turns into a ring."""

    def __init__(
        self, V: FloatArray, F: IntArray, axis: FloatArray, span: tuple[float, float], slices: int
    ) -> None:
        """axis: (2,) y and z of the limb.  span: x from where to where."""
        near = np.linalg.norm(V[:, 1:] - axis, axis=1) < 0.5 * (span[1] - span[0])
        self._V, self._F = V, F
        self.places = np.linspace(*span, slices)
        self._cuts = [_crossings(V, F, near, x) for x in self.places]

    def rings(self, X: FloatArray) -> list[FloatArray]:
        """Closed polylines: where the rest slices have gone."""
        return [(1 - t) * X[a] + t * X[b] for a, b, t in self._cuts]

    def fold(self, X: FloatArray, joint: float, half_width: float) -> Fold:
        """joint: x of the joint.  half_width: of the band, in world units."""
        rest, now = self.rings(self._V), self.rings(X)
        centre = np.array([ring.mean(axis=0) for ring in now])
        along = np.diff(centre, axis=0)
        along /= np.linalg.norm(along, axis=1, keepdims=True)
        middle = 0.5 * (self.places[1:] + self.places[:-1])
        first, last = along[:3].mean(axis=0), along[-3:].mean(axis=0)
        inside = np.abs(middle - joint) <= half_width
        lo, hi = np.flatnonzero(inside)[[0, -1]]
        share = _angle(along[lo], along[hi]) / _angle(first, last)
        ratios = [_area(b) / _area(a) for a, b in zip(rest, now, strict=True)]
        return Fold(share, min(np.array(ratios)[np.abs(self.places - joint) <= half_width]))


def _angle(u: FloatArray, v: FloatArray) -> float:
    return float(np.arctan2(np.linalg.norm(np.cross(u, v)), u @ v))


def _area(ring: FloatArray) -> float:
    """Area of a closed polyline, as the length of its vector area."""
    p = ring - ring.mean(axis=0)
    return float(np.linalg.norm(np.cross(p, np.roll(p, -1, axis=0)).sum(axis=0)) / 2)


def _crossings(
    V: FloatArray, F: IntArray, near: BoolArray, x: float
) -> tuple[IntArray, IntArray, FloatArray]:
    """Edges (a, b) cut by the plane at x, with b's share (k, 1), in order around the limb."""
    sides = np.sort(np.concatenate((F[:, [0, 1]], F[:, [1, 2]], F[:, [2, 0]])), axis=1)
    sides = np.unique(sides[near[sides].all(axis=1)], axis=0)
    height = V[sides, 0] - x
    a, b = sides[height[:, 0] * height[:, 1] < 0].T
    t = ((x - V[a, 0]) / (V[b, 0] - V[a, 0]))[:, None]
    points = (1 - t) * V[a] + t * V[b]
    offset = points - points.mean(axis=0)
    order = np.argsort(np.arctan2(offset[:, 2], offset[:, 1]))
    return a[order], b[order], t[order]
