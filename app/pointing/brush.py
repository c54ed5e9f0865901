"""What a brush touches: the vertices around a point of the surface, and how strongly."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
import scipy.sparse as sp

from app.pointing.picking import Hit
from app.selection.solids import solid_vertices
from solver.geometry.topology import Topology, components
from solver.geometry.welding import seam_links, weld
from solver.softness.falloff import falloff
from solver.types import BoolArray, FloatArray, IntArray

RADIUS_STEP = 1.15  # how much larger a notch of the wheel or a key makes a brush
MAX_DABS = 32  # the most dabs put into one frame of a fast stroke


@dataclass(frozen=True)
class Brush:
    """radius: as a fraction of the mesh's diagonal, or `on_screen` of the height of the window.

    strength, value: of softness, in [0, 1].
    mode: a name in softness_strokes.SOFTNESS_MODES, what a softness stroke does with both.
    """

    radius: float = 0.03
    on_screen: bool = False
    strength: float = 1.0
    value: float = 1.0
    mode: str = "set"


class Neighbours:
    """Which vertices edges and seams join; built once a mesh. A stray vertex has no neighbours.

    edges: (e, 2).  component: (n,) the connected piece that each vertex belongs to.
    graph: (n, n) symmetric, with an entry for each pair.
    """

    def __init__(self, vertices: FloatArray, faces: IntArray) -> None:
        topology = Topology(faces, len(vertices))
        self.edges = topology.edges
        links = np.concatenate([topology.edges, seam_links(weld(vertices, topology))])
        self.component = components(links, len(vertices))
        a, b = links.T
        ends = np.concatenate([a, b]), np.concatenate([b, a])
        size = (len(vertices), len(vertices))
        self.graph = sp.csr_array((np.ones(2 * len(a)), ends), shape=size)
        self._vertices, self._faces = vertices, faces
        corners = faces.ravel(), np.arange(faces.size) // 3
        shape = (len(vertices), len(faces))
        self._faces_at = sp.csr_array((np.ones(faces.size, dtype=np.int8), corners), shape=shape)

    @cached_property
    def solid(self) -> BoolArray:
        """(n,) the vertices of closed pieces whose triangles face outwards; most never need it."""
        topology = Topology(self._faces, len(self._vertices))
        welded = weld(self._vertices, topology)
        return solid_vertices(self._vertices, topology, welded, self.component)

    def faces_around(self, vertices: IntArray) -> IntArray:
        """(m, 3) the triangles with a corner among vertices (k,)."""
        return self._faces[_distinct(self._faces_at[vertices].indices)]

    def dab(
        self, positions: FloatArray, hit: Hit, radius: float, start: FloatArray | None = None
    ) -> tuple[IntArray, FloatArray]:
        """Vertices (k,) and weights (k,) of a brush moved from `start` (default: the hit) to a hit.

        Takes the vertices nearer than `radius` to the segment, in the connected piece of them that
        holds the hit: the far side of a thin part belongs to it only if the surface that leads
        there does. The vertex nearest to the hit is always taken. Weights: `falloff`.
        """
        seed, start = np.array([hit.vertex]), hit.position if start is None else start
        reached, away = self._spread(positions, seed, start, hit.position, radius**2)
        if len(reached) == 0:
            return seed, np.ones(1)
        return reached, falloff(np.sqrt(away) / radius)

    def _spread(
        self, X: FloatArray, front: IntArray, start: FloatArray, end: FloatArray, limit: float
    ) -> tuple[IntArray, FloatArray]:
        """The vertices nearer to a segment than the root of `limit` that edges join to `front`
        through others of them, and their squared distances.

        From neighbours to neighbours, so that a dab costs what it touches, not what the mesh has.
        """
        seen = np.zeros(len(X), dtype=bool)
        found, distances = [], []
        while len(front):
            seen[front] = True
            away = _squared_distances(X[front], start, end)
            near = away < limit
            found.append(front[near])
            distances.append(away[near])
            around = self.graph[front[near]].indices
            front = _distinct(around[~seen[around]])
        return np.concatenate(found), np.concatenate(distances)

    def fading(self, vertices: IntArray, rings: int) -> FloatArray:
        """(n,) 1 at vertices (k,) and half as many rings of neighbours, 0 after so many."""
        ring = np.full(self.graph.shape[0], rings)
        front = vertices
        for number in range(rings):
            ring[front] = number
            around = self.graph[front].indices
            front = np.flatnonzero(np.bincount(around[ring[around] == rings], minlength=1))
        return falloff(np.clip(2 * ring / rings - 1, 0, 1))

    def smoothed(
        self, values: FloatArray, vertices: IntArray, amounts: FloatArray, rounds: int
    ) -> FloatArray:
        """What `values` (n,) become at some vertices (k,), moved towards the neighbours' mean.

        amounts: (k,) in [0, 1], how much of the way each goes in each round.
        """
        rows = self.graph[vertices]
        degree = np.diff(rows.indptr)
        amounts = np.where(degree > 0, amounts, 0.0)
        values = values.copy()
        for _ in range(rounds):
            mean = (rows @ values) / np.maximum(degree, 1)
            values[vertices] += amounts * (mean - values[vertices])
        return values[vertices]


def _distinct(numbers: IntArray) -> IntArray:
    """Ascending, without repetition. np.unique would hash them, and take far longer."""
    numbers = np.sort(numbers)
    return numbers[np.diff(numbers, prepend=-1) > 0].astype(np.int64)


def _squared_distances(positions: FloatArray, start: FloatArray, end: FloatArray) -> FloatArray:
    """(n,) squared distance of each position to a segment."""
    away = positions - end
    back = start - end
    length2 = float(back @ back)
    if length2 > 0:
        along = np.clip(away @ back / length2, 0, 1)
        away -= along[:, None] * back
    return np.asarray(np.einsum("ij,ij->i", away, away))
