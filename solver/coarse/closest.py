"""Closest points on a surface, no farther than a few triangles from a vertex that is known."""

from __future__ import annotations

from functools import cached_property

import igl
import numpy as np

from solver.geometry.topology import Topology
from solver.types import BoolArray, FloatArray, IntArray

# Going downhill from a vertex nearby, points arrive within a few steps.
STEPS = 20
# Triangles around a vertex that are looked at. Where thousands of points are near a vertex with
# thousands of triangles, all of them would be pairs without number.
MOST_AROUND = 64


class NearbySurface:
    """A surface (n, 3), (m, 3) on which closest points are looked for around a known vertex.

    What is found is connected to that vertex. So the two sides of a thin sheet, or two pieces
    that touch, are not taken for each other, as they would be by distance alone.
    """

    def __init__(self, vertices: FloatArray, faces: IntArray) -> None:
        self._vertices, self._faces = np.array(vertices), np.array(faces)
        corners = faces.ravel()
        self._around = np.argsort(corners, kind="stable") // 3
        degree = np.bincount(corners, minlength=len(vertices))
        self._first = np.cumsum(degree) - degree
        self._degree = np.minimum(degree, MOST_AROUND)

    @cached_property
    def _edge_keys(self) -> IntArray:
        """(e,) a number for each edge, in rising order."""
        edges = Topology(self._faces, len(self._vertices)).edges
        return edges[:, 0] * len(self._vertices) + edges[:, 1]

    def closest(self, points: FloatArray, near: IntArray) -> tuple[IntArray, FloatArray]:
        """The triangle (k,) closest to each point (k, 3), and barycentric weights (k, 3) there.

        near: (k,) a vertex, of a triangle at least, from which to go.
        """
        P, F = self._vertices, self._faces
        points = np.ascontiguousarray(points)
        face = igl.point_mesh_squared_distance(points, P, F)[1].astype(np.int64)
        far = np.flatnonzero(~self._beside(near, face))
        face[far] = self._walked(points[far], near[far])
        return face, nearest_in_triangles(points, P[F[face]])[0]

    def closest_of_few(self, points: FloatArray, near: IntArray) -> tuple[IntArray, FloatArray]:
        """As `closest`, without a tree over all triangles: for few points on a large surface."""
        face = self._walked(points, near)
        return face, nearest_in_triangles(points, self._vertices[self._faces[face]])[0]

    def _beside(self, near: IntArray, face: IntArray) -> BoolArray:
        """(k,) whether each triangle has a corner that is the vertex `near` or its neighbour."""
        count = len(self._vertices)
        keys = self._edge_keys
        beside = np.zeros(len(near), dtype=bool)
        for corner in self._faces[face].T:
            key = np.minimum(near, corner) * count + np.maximum(near, corner)
            at = np.minimum(np.searchsorted(keys, key), len(keys) - 1)
            beside |= (near == corner) | (keys[at] == key)
        return beside

    def _walked(self, points: FloatArray, near: IntArray) -> IntArray:
        """Triangles found by going from each vertex `near` to closer and closer ones."""
        if len(points) == 0:
            return np.empty(0, dtype=np.int64)
        face, distance = self._among(points, *self._stars(near[:, None]))
        todo = np.arange(len(points))
        for _ in range(STEPS):
            found, reached = self._among(points[todo], *self._stars(self._faces[face[todo]]))
            closer = reached < distance[todo]
            todo = todo[closer]
            if len(todo) == 0:
                break
            face[todo], distance[todo] = found[closer], reached[closer]
        return face

    def _stars(self, vertices: IntArray) -> tuple[IntArray, IntArray]:
        """Triangles around the vertices (k, s) of each point, and the number of its point, (q,)."""
        degree = self._degree[vertices]
        point = np.repeat(np.arange(len(vertices)), degree.sum(axis=1))
        flat = degree.ravel()
        within = np.arange(flat.sum()) - np.repeat(np.cumsum(flat) - flat, flat)
        return self._around[np.repeat(self._first[vertices].ravel(), flat) + within], point

    def _among(
        self, points: FloatArray, face: IntArray, point: IntArray
    ) -> tuple[IntArray, FloatArray]:
        """The closest of the triangles (q,) of each point, and its squared distance."""
        squared = nearest_in_triangles(points[point], self._vertices[self._faces[face]])[1]
        starts = np.searchsorted(point, np.arange(len(points)))
        least = np.minimum.reduceat(squared, starts)
        hit = np.flatnonzero(squared == least[point])
        best = hit[np.searchsorted(point[hit], np.arange(len(points)))]
        return face[best], least


def nearest_in_triangles(P: FloatArray, corners: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Barycentric weights (k, 3) of the point of each triangle closest to P (k, 3), and its
    squared distance (k,), for corners (k, 3, 3).
    """
    a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
    u, v, w = b - a, c - a, P - a
    uu, uv, vv, uw, vw = (_dot(*pair) for pair in ((u, u), (u, v), (v, v), (u, w), (v, w)))
    area = uu * vv - uv * uv
    flat = area <= 1e-20 * np.maximum(uu, vv) ** 2
    area[flat] = 1.0
    s, t = (vv * uw - uv * vw) / area, (uu * vw - uv * uw) / area
    weights = np.column_stack([1.0 - s - t, s, t])
    outside = flat | (weights < 0.0).any(axis=1)
    weights[outside] = _nearest_on_edges(P[outside], corners[outside])
    offset = w - weights[:, 1:2] * u - weights[:, 2:] * v
    return weights, _dot(offset, offset)


def _nearest_on_edges(P: FloatArray, corners: FloatArray) -> FloatArray:
    """(k, 3) weights of the closest of the three edges' points."""
    rows = np.arange(len(P))
    best, least = np.zeros((len(P), 3)), np.full(len(P), np.inf)
    for start, end in ((0, 1), (1, 2), (2, 0)):
        a, d = corners[:, start], corners[:, end] - corners[:, start]
        length = _dot(d, d)
        along = np.clip(_dot(P - a, d) / np.where(length > 0.0, length, 1.0), 0.0, 1.0)
        offset = P - a - along[:, None] * d
        squared = _dot(offset, offset)
        closer: BoolArray = squared < least
        weights = np.zeros((len(P), 3))
        weights[rows, start], weights[rows, end] = 1.0 - along, along
        best[closer], least[closer] = weights[closer], squared[closer]
    return best


def _dot(u: FloatArray, v: FloatArray) -> FloatArray:
    return np.einsum("ij,ij->i", u, v)
