"""Reflections: the plane in which a surface is its own mirror image, and which vertices match."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

from solver.geometry.bounding_box import diagonal, middle
from solver.types import FloatArray, IntArray

# Points that a plane is found from, and how often it is fitted to the pairs that it makes.
SAMPLES, ROUNDS = 3000, 20
# A surface is symmetric where its image lies this near to it, in diagonals, in the median.
SYMMETRIC = 0.01


@dataclass(frozen=True, eq=False)
class Plane:
    """The points x with normal . x = offset. normal: (3,) unit."""

    normal: FloatArray
    offset: float

    @property
    def matrix(self) -> FloatArray:
        """S, (4, 4): the reflection, its own inverse."""
        S = np.eye(4)
        S[:3, :3] -= 2 * np.outer(self.normal, self.normal)
        S[:3, 3] = 2 * self.offset * self.normal
        return S

    def reflect(self, points: FloatArray) -> FloatArray:
        """The mirror images of points (k, 3)."""
        away = points @ self.normal - self.offset
        return points - 2 * away[:, None] * self.normal


def find_plane(V: FloatArray) -> Plane | None:
    """The plane of symmetry of points (n, 3); None where they have none.

    The planes across x, y and z and across the principal axes, through the middle, are each fitted
    to the pairs of a point and what is nearest to its image, in turn; the best one counts, and of
    equally good ones the first. [Combes et al. 2008]
    """
    points = V[:: max(len(V) // SAMPLES, 1)]
    tree, size = cKDTree(points), diagonal(points)
    centre = middle(points)
    axes = np.linalg.svd(points - points.mean(axis=0), full_matrices=False)[2]
    fitted = [_fitted(Plane(n, float(n @ centre)), points, tree) for n in [*np.eye(3), *axes]]
    errors = [error for _, error in fitted]
    best = int(np.flatnonzero(np.array(errors) <= 1.05 * min(errors) + 1e-9 * size)[0])
    plane, error = fitted[best]
    return plane if error < SYMMETRIC * size else None


def _fitted(plane: Plane, points: FloatArray, tree: cKDTree) -> tuple[Plane, float]:
    """The plane between points and what is nearest to their images, and how far those are off."""
    for _ in range(ROUNDS):
        away, nearest = tree.query(plane.reflect(points))
        good = away <= 2 * np.median(away) + 1e-12
        pairs, own = points[nearest[good]], points[good]
        # The best normal maximises the sum of squared differences along it.
        difference = own - pairs
        side = own @ plane.normal - plane.offset
        difference *= np.sign(side)[:, None]
        normal = np.linalg.svd(difference, full_matrices=False)[2][0]
        normal *= np.sign(normal @ plane.normal) or 1.0
        offset = float((0.5 * (own + pairs) @ normal).mean())
        moved = abs(offset - plane.offset) + np.linalg.norm(normal - plane.normal)
        plane = Plane(normal, offset)
        if moved < 1e-12:
            break
    return plane, float(np.median(tree.query(plane.reflect(points))[0]))


def partners(V: FloatArray, plane: Plane, tolerance: FloatArray) -> IntArray:
    """(n,) the vertex nearest to the image of each of V (n, 3), -1 where none is near.

    tolerance: (n,) how far off it may be.
    """
    away, nearest = cKDTree(V).query(plane.reflect(V))
    return np.where(away <= tolerance, nearest, -1)
