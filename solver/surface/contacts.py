"""Which pieces of a surface belong together, and where they are attached to each other."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import igl
import numpy as np
import scipy.sparse as sp
from scipy.sparse.csgraph import minimum_spanning_tree

from solver.geometry.cross_products import triangle_areas, vertex_areas
from solver.geometry.topology import Topology
from solver.surface.attachments import Attachments, joined
from solver.types import FloatArray, IntArray

# In diagonals of the surface. Pieces nearer than CONTACT touch; what is farther than REACH from
# everything stays where it is. Weights fall off over FALLOFF behind the closest point.
CONTACT, REACH, FALLOFF = 0.004, 0.05, 0.03
# Stiff enough that a chair stays a chair; ten times more bends small pieces by some percent.
STIFFNESS = 10.0
# The mean distance of this share of a piece's vertices, the nearest ones, says how near it is.
NEAREST_SHARE = 0.1
# One term for each cell of this size is enough: pieces deform over longer distances.
CELL = 0.01
# The least that the weights of a pair add up to: the smallest piece must not be lost in rounding.
LEAST = 0.01


@dataclass(frozen=True, eq=False)
class _Near:
    """Vertices of one piece that come within REACH of another, with their closest points there.

    mean: the distance of the nearest share of the smaller piece's vertices.
    """

    smaller: int
    larger: int
    vertex: IntArray
    face: IntArray
    point: FloatArray
    distance: FloatArray
    mean: float

    @property
    def touches(self) -> bool:
        return bool(self.distance.min() < CONTACT)


class _Pieces:
    """The pieces of a surface: vertices, triangles, boxes, and their order by area."""

    def __init__(self, P: FloatArray, faces: IntArray, piece: IntArray) -> None:
        count = int(piece.max()) + 1
        self.P, self.faces, self.count = P, faces, count
        self.vertices = _split(piece, count)
        self.triangles = _split(piece[faces[:, 0]], count)
        self.low = np.array([P[v].min(axis=0) for v in self.vertices])
        self.high = np.array([P[v].max(axis=0) for v in self.vertices])
        area = [float(triangle_areas(P, faces[t]).sum()) for t in self.triangles]
        self.rank = np.argsort(np.argsort(-np.array(area), kind="stable"))

    def near(self, larger: int) -> list[_Near]:
        """The smaller pieces that come within REACH of one."""
        P, faces = self.P, self.faces[self.triangles[larger]]
        low, high = self.low[larger] - REACH, self.high[larger] + REACH
        meets = ((self.low <= high) & (self.high >= low)).all(axis=1)
        pieces = np.flatnonzero(meets & (self.rank > self.rank[larger])).tolist()
        vertices = [self.vertices[piece] for piece in pieces]
        inside = [v[((P[v] >= low) & (P[v] <= high)).all(axis=1)] for v in vertices]
        asked = np.concatenate([np.empty(0, dtype=np.int64), *inside])
        if len(asked) == 0:
            return []
        distance, face, point = _closest(P[asked], P, faces)
        found = []
        for piece, end, own in zip(
            pieces, np.cumsum([len(v) for v in inside]), inside, strict=True
        ):
            part = slice(end - len(own), end)
            if len(own) == 0 or distance[part].min() > REACH:
                continue
            nearest = max(1, round(NEAREST_SHARE * len(self.vertices[piece])))
            mean = float(np.sort(distance[part])[:nearest].mean())
            at = self.triangles[larger][face[part]]
            found.append(_Near(piece, larger, own, at, point[part], distance[part], mean))
        return found


def find_attachments(P: FloatArray, topology: Topology, piece: IntArray) -> Attachments:
    """Join every two pieces that touch, and the others along a shortest forest.

    P: (n, 3) in diagonals.  piece: (n,) the number of each vertex's piece, -1 for none.
    """
    if piece.max(initial=-1) < 1:
        return Attachments.none()
    pieces = _Pieces(P, topology.faces, piece)
    near = [pair for larger in range(pieces.count) for pair in pieces.near(larger)]
    touching = [pair for pair in near if pair.touches]
    others = [pair for pair in near if not pair.touches]
    chosen = touching + _spanning(others, touching, pieces.count)
    own, area = _largest_faces(P, topology)
    return joined([_terms(pieces, pair, own, area) for pair in chosen])


def _split(number: IntArray, count: int) -> list[IntArray]:
    """The indices of each number from 0 to count - 1."""
    order = np.argsort(number, kind="stable")
    ends = np.searchsorted(number[order], np.arange(count + 1))
    return [order[a:b] for a, b in pairwise(ends)]


def _closest(
    points: FloatArray, P: FloatArray, faces: IntArray
) -> tuple[FloatArray, IntArray, FloatArray]:
    """Distance, triangle and closest point of each of some points (k, 3) on triangles."""
    own, local = np.unique(faces, return_inverse=True)
    corners, local = np.ascontiguousarray(P[own]), local.reshape(-1, 3)
    tree = igl.AABB()
    tree.init(corners, local)
    squared, face, point = tree.squared_distance(corners, local, np.ascontiguousarray(points))
    return np.sqrt(squared), face, point


def _spanning(near: list[_Near], touching: list[_Near], count: int) -> list[_Near]:
    """Of the pairs that do not touch, those of a shortest forest that joins what touches."""
    lengths = np.array([1e-12] * len(touching) + [pair.mean + 1e-9 for pair in near])
    ends = np.array([(pair.smaller, pair.larger) for pair in [*touching, *near]]).reshape(-1, 2)
    graph = sp.coo_array((lengths, (ends[:, 0], ends[:, 1])), shape=(count, count))
    tree = minimum_spanning_tree(graph.tocsr()).tocoo()
    kept = set(zip(tree.coords[0].tolist(), tree.coords[1].tolist(), strict=True))
    return [pair for pair in near if (pair.smaller, pair.larger) in kept and pair.mean <= REACH]


def _terms(pieces: _Pieces, pair: _Near, own_face: IntArray, area: FloatArray) -> Attachments:
    """The terms of one pair: one vertex a cell, with the weight of all that lie in it."""
    P = pieces.P
    away = (pair.distance - pair.distance.min()) / FALLOFF
    # A piece that is collapsed has no area, and is attached all the same.
    weight = np.maximum(area[pair.vertex], 1e-30) * np.exp(-(away**2)) / FALLOFF**2
    cells = np.floor(P[pair.vertex] / CELL).astype(np.int64)
    order = np.lexsort((-weight, *cells.T))  # the heaviest of each cell comes first
    first = np.concatenate([[True], (np.diff(cells[order], axis=0) != 0).any(axis=1)])
    total = np.add.reduceat(weight[order], np.flatnonzero(first))
    chosen = order[first]
    total *= STIFFNESS * max(1.0, LEAST / total.sum())
    keep = total > 1e-4 * total.max()
    chosen, total = chosen[keep], total[keep]
    vertex, face, point = pair.vertex[chosen], pair.face[chosen], pair.point[chosen]
    follower = np.full(len(vertex), pair.smaller)
    barycentric = _barycentric(P[pieces.faces[face]], point)
    return Attachments(
        vertex, own_face[vertex], face, barycentric, P[vertex] - point, total, follower
    )


def _largest_faces(P: FloatArray, topology: Topology) -> tuple[IntArray, FloatArray]:
    """(n,) the largest triangle at each vertex, and a third of the area of all of them."""
    faces = topology.faces
    area = triangle_areas(P, faces)
    order = np.argsort(area, kind="stable")
    own = np.zeros(topology.vertex_count, dtype=np.int64)
    own[faces[order].ravel()] = np.repeat(order, 3)  # the last one written is the largest
    return own, vertex_areas(area, faces, topology.vertex_count)


def _barycentric(corners: FloatArray, points: FloatArray) -> FloatArray:
    """(k, 3) weights of points (k, 3) of triangles (k, 3, 3), sum 1."""
    one, two = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    edges = np.stack([one, two], axis=2)
    solved = np.linalg.pinv(edges) @ (points - corners[:, 0])[:, :, None]
    return np.column_stack([1.0 - solved[:, 0, 0] - solved[:, 1, 0], solved[:, :, 0]])
