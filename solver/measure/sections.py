"""Cross-sections of a limb: planes across it at rest, and what becomes of them in a pose."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from solver.types import FloatArray, IntArray


class Section:
    """The closed polyline in which the plane x = `place` cuts a limb at rest.

    V: (n, 3) rest positions.  edges: (k, 2) of the limb.  The polyline has a vertex on each edge
    that is cut, in order around the limb, which is taken to be star-shaped there.
    """

    def __init__(self, V: FloatArray, edges: IntArray, place: float) -> None:
        height = V[edges, 0] - place
        cut = (height[:, 0] > 0) != (height[:, 1] > 0)
        share = height[cut, 0] / (height[cut, 0] - height[cut, 1])
        points = _between(V, edges[cut], share)
        y, z = (points - points.mean(axis=0))[:, 1:].T
        order = np.argsort(np.arctan2(z, y))
        self._edges, self._share = edges[cut][order], share[order]

    def ring(self, X: FloatArray) -> FloatArray:
        """(k, 3): the polyline's vertices in the pose X (n, 3)."""
        return _between(X, self._edges, self._share)

    def vector_area(self, X: FloatArray) -> FloatArray:
        """(3,): normal times area of the polyline in the pose X."""
        ring = self.ring(X)
        ring = ring - ring.mean(axis=0)
        return 0.5 * np.cross(ring, np.roll(ring, -1, axis=0)).sum(axis=0)


@dataclass(frozen=True)
class Fold:
    """Of a folded limb: the share of the bend inside a band around the joint, and the smallest
    area of a cross-section in it against rest.
    """

    share: float
    section: float


class Limb:
    """Cross-sections of a limb at several places along the rest x axis, in rising order.

    V: (n, 3) rest positions.  edges: (k, 2) of the limb.
    """

    def __init__(self, V: FloatArray, edges: IntArray, places: FloatArray) -> None:
        self.places = places
        self.sections: Sequence[Section] = [Section(V, edges, place) for place in places]
        self._rest = V

    def centres(self, X: FloatArray) -> FloatArray:
        """(k, 3): the centre line in the pose X (n, 3), a point for each section."""
        return np.array([section.ring(X).mean(axis=0) for section in self.sections])

    def vector_areas(self, X: FloatArray) -> FloatArray:
        """(k, 3): normal times area of each section in the pose X."""
        return np.array([section.vector_area(X) for section in self.sections])

    def fold(self, X: FloatArray, joint: float, half_width: float) -> Fold:
        """How the pose X is folded, told by the direction of the centre line.

        joint: x of the joint.  half_width: of the band, in world units.
        """
        along = np.diff(self.centres(X), axis=0)
        along /= np.linalg.norm(along, axis=1, keepdims=True)
        middle = 0.5 * (self.places[1:] + self.places[:-1])
        first, last = along[:3].mean(axis=0), along[-3:].mean(axis=0)
        lo, hi = np.flatnonzero(np.abs(middle - joint) <= half_width)[[0, -1]]
        share = angle_between(along[lo], along[hi]) / angle_between(first, last)
        now, rest = (np.linalg.norm(self.vector_areas(Y), axis=1) for Y in (X, self._rest))
        inside = np.abs(self.places - joint) <= half_width
        return Fold(share, float((now / rest)[inside].min()))


def angle_between(u: FloatArray, v: FloatArray) -> float:
    """Of two vectors (3,), radians in [0, pi]."""
    return float(np.arctan2(np.linalg.norm(np.cross(u, v)), u @ v))


def _between(X: FloatArray, edges: IntArray, share: FloatArray) -> FloatArray:
    return X[edges[:, 0]] + share[:, None] * (X[edges[:, 1]] - X[edges[:, 0]])
