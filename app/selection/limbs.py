"""Limbs of a surface: what sticks out of it, and where it is cut off best.

What is far from the rest of a surface sticks out: the mean geodesic distance to all of it is least
in the middle of a body and largest at the tips of its limbs. [Hilaga et al. 2001] As its level
falls, what lies above grows from a tip along a limb towards the body, and ends in a loop across it.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import scipy.sparse as sp
from scipy.sparse.csgraph import connected_components, dijkstra

from solver.coarse.simplification import simplify
from solver.geometry.cross_products import triangle_areas, vertex_areas
from solver.geometry.crossings import crossed_triangles
from solver.geometry.topology import Topology
from solver.geometry.welding import welded_surface
from solver.types import BoolArray, FloatArray, IntArray

SAMPLES = 32  # points that distances are taken from, as far from each other as can be
LEVELS = 64
SHORTEST = 0.05  # of the way from the body to the tip: what is nearer to the tip is no limb yet
# Limbs of a larger surface are found on a simplified one, of so many vertices.
LARGE = 10_000
# A neck: the border, squared and for its area, is that much longer on both sides of it.
NARROWER = 1.15
# Another limb that joins counts from this share of the area on.
JOINING = 0.1
# A limb is cut off by a shorter border than a half-sphere of its area, and is no more than half.
HALF_SPHERE, HALF = 2 * np.pi, 0.5


@dataclass(frozen=True, eq=False)
class _Cut:
    """What lies beyond a level. inside: (n,).  area.  ratio: of its border squared to its area.

    joins: whether another limb joins at the next level.
    """

    inside: BoolArray
    area: float
    ratio: float
    joins: bool


class Limbs:
    """The limbs of one connected surface, vertices (n, 3) and faces (m, 3). Built once, in some
    tenths of a second; a vertex that no face uses belongs to no limb.
    """

    def __init__(self, vertices: FloatArray, faces: IntArray) -> None:
        used, corners = np.unique(faces, return_inverse=True)
        V, F, cell = welded_surface(vertices[used], corners.reshape(-1, 3))
        if len(V) > LARGE:
            simple = simplify(V, Topology(F, len(V)), LARGE)
            V, F, cell = simple.vertices, simple.faces, simple.cell[cell]
        self._vertices, self._faces = V, F
        self._cell = np.full(len(vertices), -1)
        self._cell[used] = cell
        topology = Topology(F, len(V))
        self._edges = topology.edges
        self._area = vertex_areas(triangle_areas(V, F), F, len(V))
        self._remoteness = _mean_distance(V, topology, self._area)
        self._body = int(self._remoteness.argmin())

    def around(self, vertex: int) -> Iterator[BoolArray]:
        """(n,) the limbs that hold a vertex, from the smallest to the largest.

        A limb ends at a neck, where its border is least for its area, or just before it would
        join another limb. Its border is one loop where the surface is closed and has no holes.
        """
        at = int(self._cell[vertex])
        for cut in _places(self._cuts(at)):
            small = cut.area <= HALF * self._area.sum()
            if small and cut.ratio < HALF_SPHERE and cut.inside[at]:
                yield np.append(cut.inside, False)[self._cell]

    def _cuts(self, at: int) -> list[_Cut]:
        """What lies beyond falling levels, around the tip of the limb that a vertex is on."""
        height = self._remoteness
        tip = int(np.where(self._connected(height >= height[at], at), height, -np.inf).argmax())
        reach = height[tip] - height.min()
        levels = np.linspace(height[tip] - SHORTEST * reach, height.min(), LEVELS, endpoint=False)
        cuts: list[_Cut] = []
        inside = self._beyond(levels[0], tip)
        for level, below in pairwise(levels):
            following = self._beyond(below, tip)
            area = float(self._area[inside].sum())
            other = float(self._area[following & ~inside & (height >= level)].sum())
            ratio = self._border(inside, level) ** 2 / area if area > 0 else np.inf
            cuts.append(_Cut(inside, area, ratio, other > JOINING * area))
            inside = following
            if inside[self._body]:
                break
        return cuts

    def _beyond(self, level: float, tip: int) -> BoolArray:
        """(n,) all that a cut at a level takes away from the body, the tip's side of it."""
        limb = self._connected(self._remoteness >= level, tip)
        return limb if limb[self._body] else ~self._connected(~limb, self._body)

    def _connected(self, region: BoolArray, vertex: int) -> BoolArray:
        """(n,) the connected part of a region that holds a vertex."""
        ends = self._edges[region[self._edges].all(axis=1)]
        count = len(region)
        graph = sp.coo_array((np.ones(len(ends)), (ends[:, 0], ends[:, 1])), shape=(count, count))
        label = connected_components(graph, directed=False)[1]
        return np.asarray(region & (label == label[vertex]))

    def _border(self, inside: BoolArray, level: float) -> float:
        """How long the line is along which the level leaves a region."""
        a, b, c = crossed_triangles(self._faces, inside).T
        ends = self._crossing(a, b, level) - self._crossing(a, c, level)
        return float(np.linalg.norm(ends, axis=1).sum())

    def _crossing(self, a: IntArray, b: IntArray, level: float) -> FloatArray:
        """(k, 3) where edges have a level; their middle where both ends do."""
        start, end = self._remoteness[a], self._remoteness[b]
        with np.errstate(divide="ignore", invalid="ignore"):
            t = np.clip((level - start) / (end - start), 0.0, 1.0)
        t = np.where(np.isfinite(t), t, 0.5)[:, None]
        return (1 - t) * self._vertices[a] + t * self._vertices[b]


def _places(cuts: list[_Cut]) -> Iterator[_Cut]:
    """Those of the cuts from a tip to the body that end a limb: necks, and the last before a joint.

    A neck has a ratio that is NARROWER than one before it, since the last place, and one after it.
    """
    least: _Cut | None = None
    highest = np.inf
    for cut in cuts:
        highest = max(highest, cut.ratio)
        if cut.ratio < (highest / NARROWER if least is None else least.ratio):
            least = cut
        elif least is not None and cut.ratio > NARROWER * least.ratio:
            yield least
            least, highest = None, cut.ratio
        if cut.joins:
            yield cut
            least, highest = None, np.inf


def _mean_distance(V: FloatArray, topology: Topology, area: FloatArray) -> FloatArray:
    """(n,) the mean geodesic distance of each vertex to all of a connected surface.

    From some vertices, each as far as can be from those before, for the area nearest to it.
    """
    graph = _straighter_edges(V, topology)
    nearest = dijkstra(graph, directed=False, indices=0)
    away: list[FloatArray] = []
    for _ in range(SAMPLES):
        away.append(dijkstra(graph, directed=False, indices=int(nearest.argmax())))
        nearest = np.minimum(nearest, away[-1]) if len(away) > 1 else away[0]
    shares = np.bincount(np.argmin(away, axis=0), area, SAMPLES)
    return np.asarray(shares @ np.array(away) / max(float(shares.sum()), 1e-300))


def _straighter_edges(V: FloatArray, topology: Topology) -> sp.csr_array:
    """(n, n) the lengths of edges, and of the ways across them between opposite corners."""
    F, pairs = topology.faces, topology.pairs
    opposite = np.column_stack(
        [F[pairs.first, pairs.half_first], F[pairs.second, pairs.half_second]]
    )
    links = np.sort(np.concatenate([topology.edges, opposite]), axis=1)
    links = np.unique(links[links[:, 0] != links[:, 1]], axis=0)
    lengths = np.maximum(np.linalg.norm(V[links[:, 0]] - V[links[:, 1]], axis=1), 1e-300)
    return sp.csr_array((lengths, (links[:, 0], links[:, 1])), shape=(len(V), len(V)))
