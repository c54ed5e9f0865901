"""Which pieces of a surface are closed, with an outside that triangles show."""

from __future__ import annotations

import numpy as np

from solver.geometry.topology import Topology
from solver.types import BoolArray, FloatArray, IntArray


def solid_vertices(
    vertices: FloatArray, topology: Topology, welded: IntArray, component: IntArray
) -> BoolArray:
    """(n,) the vertices of closed pieces whose triangles all face outwards.

    welded: (n,) as by `weld`.  component: (n,) the piece of each, seams welded.
    """
    flawed = np.zeros(component.max(initial=-1) + 1, dtype=bool)
    ends = topology.edges[topology.valence == 1]
    # An edge of a seam has a twin between vertices that are one with its own.
    alone = (np.bincount(welded)[welded] == 1)[ends].any(axis=1)
    flawed[component[ends[alone, 0]]] = True
    flawed[component[topology.edges[topology.valence > 2, 0]]] = True
    forward = np.bincount(topology.half_edge_edge.ravel(), topology.half_edge_forward.ravel())
    unequal = (topology.valence == 2) & (forward != 1)
    flawed[component[topology.edges[unequal, 0]]] = True
    F = topology.faces
    a, b, c = (vertices[corner] - vertices[F[:, 0]].mean(axis=0) for corner in F.T)
    volume = np.bincount(component[F[:, 0]], (np.cross(a, b) * c).sum(axis=1), len(flawed))
    return np.asarray((~flawed & (volume > 0))[component])
