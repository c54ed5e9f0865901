"""Which point of the surface on screen lies under the cursor."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

from app.viewpoint.camera import Ray
from solver.geometry.circles import across
from solver.geometry.cross_products import cross
from solver.types import FloatArray, IntArray

# Triangles in a block: with fewer there are more spheres to ask, with more more triangles.
BLOCK = 64
# Spheres are wider than they need to be by this much, so that rounding never leaves one out.
SLACK = 1.0 + 1e-9


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
    """Ray queries against triangles whose corners move from time to time.

    Triangles that lie together at rest are one block, and stay one wherever they go: when a query
    comes with other positions than the last one (a new array), only the spheres around the blocks
    are found again. A tree would be built again, which takes ten times as long.
    """

    def __init__(self, vertices: FloatArray, faces: IntArray) -> None:
        """vertices: (n, 3) at rest.  faces: (m, 3), those that can be hit."""
        self._faces = faces
        self._blocks: IntArray = np.empty((0, BLOCK), dtype=np.int64)
        if len(faces):
            centroids = vertices[faces].mean(axis=1)
            tree = cKDTree(centroids, leafsize=BLOCK, compact_nodes=False, balanced_tree=False)
            filled = np.pad(tree.indices, (0, -len(faces) % BLOCK), mode="edge")
            self._blocks = filled.reshape(-1, BLOCK)
        self._positions: FloatArray | None = None

    def pick(self, ray: Ray, positions: FloatArray) -> Hit | None:
        """The first point of the surface that the ray meets, None when it passes by."""
        self._follow(positions)
        near = self._blocks[_met(ray, self._centres, self._radii)].ravel()
        found = _first(ray, positions, self._faces[near])
        if found is None:
            return None
        number, barycentric, distance = found
        corners = self._faces[near[number]]
        position = barycentric @ positions[corners]
        away = ((positions[corners] - position) ** 2).sum(axis=1)
        vertex = int(corners[np.argmin(away)])
        return Hit(int(near[number]), barycentric, position, vertex, distance)

    def near(self, ray: Ray, angle: float, positions: FloatArray) -> bool:
        """Whether the surface may be within an angle of a ray, in radians: no, or perhaps."""
        self._follow(positions)
        away = np.linalg.norm(self._centres - ray.origin[:, None], axis=0)
        return len(_met(ray, self._centres, self._radii + angle * (away + self._radii))) > 0

    def _follow(self, positions: FloatArray) -> None:
        if positions is not self._positions:
            self._centres, self._radii = _spheres(positions, self._faces, self._blocks)
            self._positions = positions


def _spheres(X: FloatArray, faces: IntArray, blocks: IntArray) -> tuple[FloatArray, FloatArray]:
    """Centres (3, b) and radii (b,) of spheres around the boxes of blocks of triangles."""
    corners = faces[blocks].reshape(len(blocks), 3 * BLOCK)
    # One axis after the other: all at once needs nine times the memory, and four times as long.
    along = [np.ascontiguousarray(x)[corners] for x in X.T]
    low, high = (np.stack([x.min(axis=1) for x in along]), np.stack([x.max(axis=1) for x in along]))
    return 0.5 * (low + high), 0.5 * SLACK * np.linalg.norm(high - low, axis=0)


def _met(ray: Ray, centres: FloatArray, radii: FloatArray) -> IntArray:
    """The spheres that a ray meets."""
    away = centres - ray.origin[:, None]
    direction = ray.direction[:, None]
    beside = np.linalg.norm(cross(away, np.broadcast_to(direction, away.shape)), axis=0)
    ahead = (away * direction).sum(axis=0) + radii >= 0
    return np.flatnonzero(ahead & (beside <= SLACK * radii))


def _first(ray: Ray, X: FloatArray, faces: IntArray) -> tuple[int, FloatArray, float] | None:
    """Which triangle (k, 3) a ray meets first, where as barycentric weights, and how far away.

    Seen along the ray, twice the signed areas that the ray makes with the edges have one sign.
    Two triangles find the same number for a common edge, up to its sign: no ray slips between.
    """
    side, up = across(ray.direction)
    corners = X[faces] - ray.origin
    # Not by a matrix product: that may round a corner in one triangle and not in the next.
    x, y, depth = ((corners * axis).sum(axis=2) for axis in (side, up, ray.direction))
    following, last = [1, 2, 0], [2, 0, 1]
    areas = x[:, following] * y[:, last] - y[:, following] * x[:, last]
    total = areas.sum(axis=1)
    inside = ((areas >= 0).all(axis=1) | (areas <= 0).all(axis=1)) & (total != 0)
    met = np.flatnonzero(inside)
    weights = areas[met] / total[met, None]
    distances = (weights * depth[met]).sum(axis=1)
    ahead = np.flatnonzero(distances > 0)
    if len(ahead) == 0:
        return None
    nearest = ahead[np.argmin(distances[ahead])]
    return int(met[nearest]), weights[nearest], float(distances[nearest])
