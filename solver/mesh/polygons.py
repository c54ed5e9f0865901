"""Polygons as a surface's file lists them, and their split into triangles."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from solver.mesh.ear_clipping import clip_ears, flatten
from solver.mesh.ear_cutting import cut_ears
from solver.types import BoolArray, FloatArray, IntArray

# Clipping ears takes the square of the corners: a second for a thousand polygons of so many. Above,
# an algorithm takes over that sorts them, and cares less for the shape of the triangles.
MANY = 100


@dataclass(frozen=True, eq=False)
class Polygons:
    """p polygons: `sizes` (p,) counts their corners, `corners` (sum,) are their vertices."""

    sizes: IntArray
    corners: IntArray

    @classmethod
    def from_array(cls, faces: IntArray) -> Polygons:
        """Polygons of one size, (p, k)."""
        return cls(np.full(len(faces), faces.shape[1], dtype=np.int64), faces.ravel())

    @property
    def starts(self) -> IntArray:
        """(p,) where the corners of each polygon start."""
        return np.cumsum(self.sizes) - self.sizes

    def where(self, keep: BoolArray) -> Polygons:
        """Those of `keep`, (p,)."""
        return Polygons(self.sizes[keep], self.corners[np.repeat(keep, self.sizes)])

    def rows(self) -> IntArray | list[list[int]]:
        """(p, k) where all have k corners, else one list of vertices a polygon."""
        if len(self.sizes) and (self.sizes == self.sizes[0]).all():
            return self.corners.reshape(-1, int(self.sizes[0]))
        return self.tolist()

    def tolist(self) -> list[list[int]]:
        """One list of vertices a polygon."""
        flat = self.corners.tolist()
        ends = np.cumsum(self.sizes).tolist()
        starts = self.starts.tolist()
        return [flat[a:b] for a, b in zip(starts, ends, strict=True)]


def triangulate(V: FloatArray, polygons: Polygons) -> IntArray:
    """Split every polygon: (m, 3) positions in `polygons.corners`, so that F = corners[result].

    A polygon of k corners gives k - 2 triangles, next to each other, in the order of the polygons.
    Quads are split along the diagonal that keeps both triangles facing the same way (the shorter
    one where both do), larger polygons by clipping ears in the plane of their Newell normal, those
    of more than MANY corners by cutting them as they come.
    """
    counts = polygons.sizes - 2
    first = np.cumsum(counts) - counts
    result = np.empty((int(counts.sum()), 3), dtype=np.int64)
    for size in np.unique(polygons.sizes):
        chosen = np.flatnonzero(polygons.sizes == size)
        start = polygons.starts[chosen]
        split = _split(V[polygons.corners[start[:, None] + np.arange(size)]])
        rows = first[chosen, None] + np.arange(size - 2)
        result[rows] = start[:, None, None] + split
    return result


def _split(P: FloatArray) -> IntArray:
    """(g, k, 3) corners of g polygons -> (g, k-2, 3) corner numbers in 0..k-1."""
    if P.shape[1] == 3:
        return np.tile(np.arange(3), (len(P), 1, 1))
    if P.shape[1] == 4:
        return _split_quads(P)
    if P.shape[1] <= MANY:
        return clip_ears(P)
    return np.stack([cut_ears(p) for p in flatten(P)])


def _split_quads(P: FloatArray) -> IntArray:
    # Squares of very large or small edges leave the range of float64, so each quad is scaled.
    size = np.ptp(P, axis=1).max(axis=1)[:, None, None]
    P = (P - P[:, :1]) / np.where(size > 0, size, 1)
    diagonal_02 = np.array([[0, 1, 2], [0, 2, 3]])
    diagonal_13 = np.array([[0, 1, 3], [1, 2, 3]])
    faces_02, faces_13 = _same_side(P, diagonal_02), _same_side(P, diagonal_13)
    length_02 = np.linalg.norm(P[:, 2] - P[:, 0], axis=1)
    length_13 = np.linalg.norm(P[:, 3] - P[:, 1], axis=1)
    # A tie must not be decided by rounding: a regular grid is split one way throughout.
    shorter_13 = length_13 < (1 - 1e-9) * length_02
    use_13 = np.where(faces_02 == faces_13, shorter_13, faces_13)
    return np.where(use_13[:, None, None], diagonal_13, diagonal_02)


def _same_side(P: FloatArray, split: IntArray) -> BoolArray:
    """Whether the two triangles face the same way; a triangle without area faces nowhere."""
    a, b, c = (P[:, split[:, k]] for k in range(3))
    normals = np.cross(b - a, c - a)
    return np.asarray((normals[:, 0] * normals[:, 1]).sum(axis=1) > 1e-14)
