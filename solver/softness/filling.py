"""Filling softness between dabs: harmonic where dabs are near each other, untouched elsewhere."""

from __future__ import annotations

import numpy as np
import scipy.sparse as sp
from scipy.sparse.csgraph import connected_components, dijkstra, minimum_spanning_tree

from solver.geometry.topology import Topology
from solver.geometry.welding import welded_surface
from solver.softness.harmonic import interpolate_softness
from solver.types import BoolArray, FloatArray, IntArray


def fill_between(
    V: FloatArray,
    F: IntArray,
    softness: FloatArray,
    pins: IntArray,
    open_: BoolArray,
    least: float,
) -> FloatArray:
    """Softness (n,) that is harmonic within reach of the pins, and what it was beyond.

    V (n, 3), F (m, 3).  softness: (n,) before.  pins: (k,) the vertices that keep their value.
    open_: (n,) where it may change; the field does not spread through anything else.
    least: the reach of a single dab, in world units.
    Dabs are pins that hang together, and the reach is the longest of the ways along the surface
    that it takes to join all of them: so gaps are filled, and other limbs are left alone.
    """
    inside = open_.copy()
    inside[pins] = True
    faces = F[inside[F].all(axis=1)]
    if not len(faces):
        return softness
    P, welded_faces, welded = welded_surface(V, faces)
    # Vertices without a face are their own; only those with one are asked for.
    graph = _lengths(P, welded_faces)
    sources = np.unique(welded[pins])
    away, reach = _reach(graph, sources)
    far = away[welded] > max(reach, least)
    far[pins] = False
    given = np.flatnonzero(far & inside)
    known = np.concatenate([pins, given])
    filled = interpolate_softness(V, faces, known, softness[known])
    changed = np.zeros(len(V), dtype=bool)
    changed[faces.ravel()] = True
    changed &= np.isfinite(away[welded]) & ~far
    return np.where(changed, filled, softness)


def _lengths(P: FloatArray, F: IntArray) -> sp.csr_array:
    """The graph of edges with their lengths."""
    a, b = Topology(F, len(P)).edges.T
    length = np.maximum(np.linalg.norm(P[a] - P[b], axis=1), np.finfo(float).tiny)
    ends = np.concatenate([a, b]), np.concatenate([b, a])
    return sp.csr_array((np.tile(length, 2), ends), shape=(len(P), len(P)))


def _reach(graph: sp.csr_array, sources: IntArray) -> tuple[FloatArray, float]:
    """(n,) how far each vertex is from the sources, and the longest gap between their clusters.

    A gap is measured where the territories of two clusters meet; of all gaps those count that a
    minimum spanning tree of the clusters takes.
    """
    cluster = connected_components(graph[sources][:, sources], directed=False)[1]
    away, _, nearest = dijkstra(graph, indices=sources, min_only=True, return_predecessors=True)
    number = np.full(graph.shape[0], -1)
    number[sources] = cluster
    owner = np.where(nearest >= 0, number[np.maximum(nearest, 0)], -1)
    pairs = graph.tocoo()
    a, b = owner[pairs.row], owner[pairs.col]
    meets = (a < b) & (a >= 0)
    gaps = (away[pairs.row] + pairs.data + away[pairs.col])[meets]
    if not len(gaps):
        return away, 0.0
    count = int(cluster.max()) + 1
    shortest = np.full((count, count), np.inf)
    np.minimum.at(shortest, (a[meets], b[meets]), gaps)
    tree = minimum_spanning_tree(np.where(np.isfinite(shortest), shortest, 0.0))
    return away, float(tree.data.max(initial=0.0))
