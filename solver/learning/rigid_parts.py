"""Parts of a surface that move rigidly in all poses: what to fix and what to take hold of."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import scipy.sparse as sp
from numpy.typing import ArrayLike
from scipy.sparse.csgraph import dijkstra

from solver.errors import ConstraintError
from solver.geometry.cross_products import triangle_areas, vertex_areas
from solver.geometry.topology import components
from solver.learning.surface import LearningSurface
from solver.linear.rest_surface import RestSurface
from solver.setup import Setup
from solver.types import BoolArray, FloatArray, IntArray

# Two parts are one while all of it fits a rigid motion to this share of the diagonal, rms, in every
# pose.
RIGID = 0.01
# A handle has at least this share of the area of its piece, and more than this times the squared
# length of its border: a flat disc has 0.08, a ragged one less, half a sphere 0.16. A foot is an
# end, a knee is not.
LEAST_AREA, LEAST_BULGE = 0.005, 0.09
# What is left is in one where so much of it is connected: a part may have islands.
WHOLE = 0.95
# Of a part, what is this far from its border is held, as a share of the farthest.
CORE = 0.5


class _Parts:
    """Parts of vertices, each with its moments in all poses, by which its rigidity is known."""

    def __init__(self, points: FloatArray, poses: FloatArray, mass: FloatArray) -> None:
        """points: (n, 3).  poses: (p, n, 3).  mass: (n,)."""
        self.owner = np.arange(len(points))
        m = mass[:, None]
        self._mass = mass.copy()
        self._rest, self._posed = m * points, m * poses
        self._squares = mass * ((points**2).sum(axis=1) + (poses**2).sum(axis=2))  # (p, n)
        self._mixed = np.einsum("n,ni,pnj->pnij", mass, points, poses)

    def root(self, vertex: int) -> int:
        """The part that a vertex belongs to."""
        owner = self.owner
        while owner[vertex] != vertex:
            owner[vertex] = vertex = owner[owner[vertex]]
        return int(vertex)

    def join(self, one: int, two: int) -> None:
        """One part of two, where that moves rigidly."""
        a, b = self.root(one), self.root(two)
        if a == b:
            return
        mass, rest = self._mass[a] + self._mass[b], self._rest[a] + self._rest[b]
        posed, mixed = self._posed[:, a] + self._posed[:, b], self._mixed[:, a] + self._mixed[:, b]
        squares = self._squares[:, a] + self._squares[:, b]
        M = mixed - rest[:, None] * posed[:, None, :] / mass
        singular = np.linalg.svd(M, compute_uv=False)
        best = singular[:, :2].sum(axis=1) + np.sign(np.linalg.det(M)) * singular[:, 2]
        spread = squares - ((rest**2).sum() + (posed**2).sum(axis=1)) / mass
        if ((spread - 2.0 * best) > RIGID**2 * mass).any():
            return
        self.owner[b] = a
        self._mass[a], self._rest[a], self._posed[:, a] = mass, rest, posed
        self._mixed[:, a], self._squares[:, a] = mixed, squares


def rigid_parts(rest: RestSurface, poses: FloatArray) -> IntArray:
    """(n,) the number of each vertex's part, for poses (p, n, 3) in the units of `rest.points`.

    Neighbours are joined, first those between which the edge keeps its length and direction best
    among its neighbours, as long as what they make moves rigidly.
    """
    P, edges = rest.points, rest.topology.edges
    mass = vertex_areas(triangle_areas(P, rest.faces), rest.faces, len(P)) + np.finfo(float).tiny
    parts = _Parts(P, poses, mass)
    for one, two in edges[np.argsort(_bends(rest, poses), kind="stable")]:
        parts.join(int(one), int(two))
    return np.unique([parts.root(v) for v in range(len(P))], return_inverse=True)[1]


def _bends(rest: RestSurface, poses: FloatArray) -> FloatArray:
    """(e,) how much the surface around an edge changes its shape, the most of all poses."""
    edges, n = rest.topology.edges, len(rest.points)
    a, b = edges.T
    around = []
    for X in poses:
        before, after = (((P[a] - P[b]) ** 2).sum(axis=1) for P in (rest.points, X))
        around.append(np.abs(after - before))
    change = np.max(around, axis=0)
    degree = np.maximum(np.bincount(edges.ravel(), minlength=n), 1)
    mean = np.bincount(edges.ravel(), np.repeat(change, 2), n) / degree
    return np.asarray(mean[edges].sum(axis=1))


def find_parts(
    surface: LearningSurface,
    poses: Sequence[FloatArray],
    fixed: ArrayLike | None,
    handles: Sequence[ArrayLike] | None,
) -> tuple[ArrayLike, Sequence[ArrayLike]]:
    """The fixed region (k,) and the handles, found from poses (n, 3) each where they are None.

    Fixed is the core of the largest part, handles are those of the others at which the surface
    ends: what lies between is what softness is learned from. Raises ConstraintError where there is
    no such end.
    """
    rest = surface.rest
    part = rigid_parts(rest, np.array([surface.pose(X) for X in poses]))
    area = vertex_areas(triangle_areas(rest.points, rest.faces), rest.faces, len(part))
    given = Setup(() if fixed is None else fixed, () if handles is None else handles)
    taken = given.groups(len(poses[0])) >= 0
    trunk = int(np.bincount(part, area).argmax())
    if fixed is None:
        fixed = np.flatnonzero(surface.shown_where(_core(rest, part == trunk)) & ~taken)
    if handles is None:
        taken[np.asarray(fixed, dtype=np.int64)] = True
        cores = [_core(rest, part == number) for number in _ends(rest, part, area, trunk)]
        ends = [surface.shown_where(core) & ~taken for core in cores]
        handles = [np.flatnonzero(end) for end in ends if end.any()]
    if len(handles) == 0:
        raise ConstraintError("poses show no end that moves rigidly, expected handles to be given")
    return fixed, handles


def _ends(rest: RestSurface, part: IntArray, area: FloatArray, trunk: int) -> list[int]:
    """The parts that bulge beyond a short border and leave the rest of their piece in one."""
    component = rest.topology.vertex_component
    size = np.bincount(part, area)
    a, b = rest.topology.edges.T
    border = part[a] != part[b]
    length = np.linalg.norm(rest.points[a] - rest.points[b], axis=1) * border
    around = 0.5 * (
        np.bincount(part[a], length, len(size)) + np.bincount(part[b], length, len(size))
    )
    found = []
    for number in np.flatnonzero((around > 0) & (size > LEAST_BULGE * around**2)):
        own = part == number
        piece = component == component[own.argmax()]
        large = size[number] > LEAST_AREA * area[piece].sum()
        if number != trunk and large and _in_one(rest, piece & ~own):
            found.append(int(number))
    return found


def _core(rest: RestSurface, own: BoolArray) -> BoolArray:
    """(n,) the vertices of a part that are at least CORE as far from its border as any of it."""
    a, b = rest.topology.edges.T
    length = np.linalg.norm(rest.points[a] - rest.points[b], axis=1)
    graph = sp.coo_array((np.maximum(length, np.finfo(float).tiny), (a, b)), shape=2 * own.shape)
    beyond = np.unique(rest.topology.edges[own[a] != own[b]])
    if len(beyond) == 0:
        return own
    away = dijkstra(graph.tocsr(), directed=False, indices=beyond[~own[beyond]], min_only=True)
    away = np.where(own & np.isfinite(away), away, 0.0)
    return own & (away >= CORE * away.max())


def _in_one(rest: RestSurface, kept: BoolArray) -> bool:
    """Whether these vertices are connected, but for a few."""
    edges = rest.topology.edges
    sizes = np.bincount(components(edges[kept[edges].all(axis=1)], len(kept))[kept])
    return bool(sizes.max(initial=0) > WHOLE * sizes.sum())
