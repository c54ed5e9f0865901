"""Regions of vertices, larger, smaller or with a smoother border."""

from __future__ import annotations

import numpy as np
import scipy.sparse as sp

from solver.types import BoolArray, FloatArray, IntArray

ROUNDS = 8  # of averaging, and so the width in edges on both sides of a border that is smoothed


def grown(graph: sp.csr_array, region: BoolArray) -> BoolArray:
    """(n,) the region and all that an edge joins to it.  graph: (n, n), symmetric."""
    larger = region.copy()
    larger[graph[np.flatnonzero(region)].indices] = True
    return larger


def shrunk(graph: sp.csr_array, region: BoolArray) -> BoolArray:
    """(n,) the region without what an edge joins to anything else."""
    return ~grown(graph, ~region)


def smoothed_region(graph: sp.csr_array, region: BoolArray, area: FloatArray) -> BoolArray:
    """(n,) the region with a smoother border and about the same area; area: (n,) of each vertex.

    The region's indicator is averaged over neighbours some times, near its border, and the
    vertices where it is largest are taken until they have the area that the region had.
    """
    near = _band(graph, region)
    rows = graph[near]
    degree = np.maximum(np.diff(rows.indptr), 1)
    values = region.astype(np.float64)
    for _ in range(ROUNDS):
        values[near] = 0.5 * values[near] + 0.5 * (rows @ values) / degree
    order = near[np.argsort(-values[near], kind="stable")]
    wanted = area[near][region[near]].sum()
    taken = np.cumsum(area[order]) - 0.5 * area[order] < wanted
    smooth = region.copy()
    smooth[order] = taken
    return smooth


def _band(graph: sp.csr_array, region: BoolArray) -> IntArray:
    """The vertices within ROUNDS edges of the border."""
    outside, inside = grown(graph, region) & ~region, grown(graph, ~region) & region
    band = outside | inside
    for _ in range(ROUNDS - 1):
        band = grown(graph, band)
    return np.flatnonzero(band)
