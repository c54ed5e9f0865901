"""Which point of the surface on screen lies under the cursor."""

from __future__ import annotations

from dataclasses import dataclass

import igl
import numpy as np

from app.workspace.camera import Ray
from solver.types import FloatArray, IntArray

# libigl takes a triangle for parallel to the ray below a fixed threshold of its own, and a small
# or finely meshed file would have nothing but such triangles: ask at this size instead.
SIZE = 1e6
# A ray exactly through an edge can slip between its two triangles, so three more go beside it,
# at this distance (a millionth of the mesh's size, far below a pixel).
BESIDE = 1.0


@dataclass(frozen=True, eq=False)
class Hit:
    """A point of the surface. barycentric: (3,) weights of the face's corners.

    position: (3,). vertex: the nearest of the three corners. distance: along the ray.
    """

    face: int
    barycentric: FloatArray
    position: FloatArray
    vertex: int
    distance: float


class Picker:
    """Ray queries against triangles `faces` (m, 3) whose corners move from time to time.

    The tree is rebuilt when a query comes with other positions than the last one (a new array),
    so moving the surface costs nothing as long as nobody points at it.
    """

    def __init__(self, faces: IntArray) -> None:
        self._faces = np.ascontiguousarray(faces, dtype=np.int64)
        # A stray vertex may lie anywhere. Counting is ten times as fast as finding what is unique.
        self._used = np.flatnonzero(np.bincount(self._faces.ravel()))
        self._positions: FloatArray | None = None

    def pick(self, ray: Ray, positions: FloatArray) -> Hit | None:
        """The first point of the surface that the ray meets, None when it passes by."""
        if positions is not self._positions:
            self._build(positions)
        origin = (ray.origin - self._centre) * self._scale
        origins = origin + _ring(ray.direction)
        directions = np.tile(ray.direction, (len(origins), 1))
        faces, distances, _ = self._tree.intersect_ray_first(
            self._scaled, self._faces, origins, directions
        )
        if (faces < 0).all():
            return None
        nearest = int(np.argmin(np.where(faces < 0, np.inf, distances)))
        return self._hit(ray, int(faces[nearest]), float(distances[nearest]) / self._scale)

    def _build(self, positions: FloatArray) -> None:
        used = positions[self._used]
        low, high = used.min(axis=0), used.max(axis=0)
        self._centre = (low + high) / 2
        self._scale = SIZE / max(float(np.linalg.norm(high - low)), np.finfo(float).tiny)
        self._scaled = (positions - self._centre) * self._scale
        self._tree = igl.AABB()
        self._tree.init(self._scaled, self._faces)
        self._positions = positions

    def _hit(self, ray: Ray, face: int, distance: float) -> Hit:
        """The point of the face at this distance, of which libigl gives single precision."""
        assert self._positions is not None
        corners = self._positions[self._faces[face]]
        barycentric = _barycentric(corners, ray.at(distance))
        position = barycentric @ corners
        away = ((corners - position) ** 2).sum(axis=1)
        vertex = int(self._faces[face, np.argmin(away)])
        along = float((position - ray.origin) @ ray.direction)
        return Hit(face, barycentric, position, vertex, along)


def _ring(direction: FloatArray) -> FloatArray:
    """(4, 3) offsets across the direction: none, and the corners of a small triangle."""
    helper = np.eye(3)[np.argmin(np.abs(direction))]
    side = np.cross(direction, helper)
    side /= np.linalg.norm(side)
    up = np.cross(direction, side)
    # turned by an odd angle, so that no two of the rays run along the same grid line
    angles = 0.7 + 2 * np.pi * np.arange(3) / 3
    ring = BESIDE * (np.cos(angles)[:, None] * side + np.sin(angles)[:, None] * up)
    return np.vstack([np.zeros(3), ring])


def _barycentric(corners: FloatArray, point: FloatArray) -> FloatArray:
    """(3,) weights of the point of the triangle that is about nearest to `point`, sum 1."""
    edges = np.column_stack([corners[1] - corners[0], corners[2] - corners[0]])
    two = np.linalg.lstsq(edges, point - corners[0], rcond=None)[0]
    weights = np.clip([1 - two.sum(), *two], 0, None)
    total = weights.sum()
    return weights / total if total > 0 else np.full(3, 1 / 3)
