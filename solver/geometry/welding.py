"""Seams: where a surface is cut into pieces whose boundary edges coincide, it is one surface.

UV seams, hard edges and triangle soups repeat vertices. Two vertices are one where they lie in
one place and a boundary edge of the one coincides with a boundary edge of the other, so that a
closed surface that merely touches another stays apart.
"""

from __future__ import annotations

import numpy as np
from scipy.spatial import cKDTree

from solver.geometry.bounding_box import diagonal
from solver.geometry.topology import Topology, components
from solver.types import FloatArray, IntArray

# Two points are one place when they are nearer than this share of the surface's size.
COINCIDENT = 1e-9


def weld(V: FloatArray, topology: Topology) -> IntArray:
    """(n,) the number of the welded vertex of each vertex, by first appearance.

    V: (n, 3).  A surface without seams gives arange(n).
    """
    count = topology.vertex_count
    ends = topology.edges[topology.valence == 1]
    corners, flat = np.unique(ends, return_inverse=True)
    if len(corners) == 0:
        return np.arange(count)
    size = diagonal(V[topology.faces.ravel()])
    place = _places(V[corners], COINCIDENT * size)[flat.reshape(-1, 2)]
    # Both edges of a pair from the lower place to the higher one.
    turned = place[:, 0] > place[:, 1]
    place, ends = (np.where(turned[:, None], a[:, ::-1], a) for a in (place, ends))
    proper = place[:, 0] != place[:, 1]
    place, ends = place[proper], ends[proper]
    order = np.lexsort(place.T)
    same = (place[order][1:] == place[order][:-1]).all(axis=1)
    pairs = np.stack([ends[order][:-1][same], ends[order][1:][same]], axis=2)  # (k, end, side)
    return components(pairs.reshape(-1, 2), count)


def seam_links(welded: IntArray) -> IntArray:
    """(q, 2) vertices that became one: enough to join all that did."""
    order = np.argsort(welded, kind="stable")
    same = welded[order][1:] == welded[order][:-1]
    return np.column_stack([order[:-1][same], order[1:][same]])


def welded_surface(V: FloatArray, F: IntArray) -> tuple[FloatArray, IntArray, IntArray]:
    """Positions (k, 3) and triangles (m, 3) without seams, and (n,) the vertex each became."""
    welded = weld(V, Topology(F, len(V)))
    first = np.unique(welded, return_index=True)[1]
    return V[first], welded[F], welded


def weld_pieces(V: FloatArray, F: IntArray) -> tuple[IntArray, IntArray]:
    """(n,) the number of the welded vertex of each vertex, and (n,) that of its connected piece.

    Pieces are counted by their first vertex; an unreferenced vertex has none: -1.
    """
    topology = Topology(F, len(V))
    welded = weld(V, topology)
    return welded, number_pieces(components(welded[topology.edges], len(V))[welded], F)


def number_pieces(component: IntArray, faces: IntArray) -> IntArray:
    """(n,) components counted by the first vertex that a face uses; -1 where none does."""
    result = np.full(len(component), -1)
    used = np.flatnonzero(np.bincount(faces.ravel(), minlength=len(component)))
    _, first, number = np.unique(component[used], return_index=True, return_inverse=True)
    result[used] = np.argsort(np.argsort(first))[number]
    return result


def _places(points: FloatArray, tolerance: float) -> IntArray:
    """(k,) a number for each place, the same for points nearer than `tolerance` to each other."""
    order = np.lexsort(points.T)
    differs = (points[order][1:] != points[order][:-1]).any(axis=1)
    place = np.empty(len(points), dtype=np.int64)
    place[order] = np.concatenate([[0], np.cumsum(differs)])
    distinct = points[order][np.concatenate([[True], differs])]
    near = cKDTree(distinct).query_pairs(tolerance, output_type="ndarray")
    return components(near, len(distinct))[place]
