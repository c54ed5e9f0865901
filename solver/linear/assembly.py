"""Assembly of the energy's matrix K: its sparsity pattern, made once, and its entries, often."""

from __future__ import annotations

import numpy as np
import scipy.sparse as sp

from solver.geometry.cotangent_weights import (
    ElementWeights,
)
from solver.geometry.topology import HALF_EDGE_END, HALF_EDGE_START, Topology
from solver.linear.energy import Gains, RestEnergy
from solver.types import BoolArray, FloatArray, IntArray

# The lower triangle of a triangle's own 3 x 3 block.
OWN_ROW, OWN_COLUMN = np.tril_indices(3)


class Pattern:
    """The entries of K's lower triangle that come from some of a mesh's triangles.

    rows, columns: (z,) places in K (n + 3m, n + 3m), rows >= columns. A place occurs twice only
    where a triangle repeats a vertex or two triangles share two edges; values there add up.
    links: (q,) which of the topology's links join two of these triangles.
    """

    def __init__(self, topology: Topology, active: BoolArray) -> None:
        """active: (m,) the triangles that count. A link counts where both of its triangles do."""
        n = topology.vertex_count
        self._faces = faces = np.flatnonzero(active)
        self.links = np.flatnonzero(active[topology.links].all(axis=1))
        links = topology.links[self.links]
        self._corners = topology.faces[faces]
        self._face_count = len(topology.faces)
        self._link_ends = links
        self._half_edge_edge = topology.half_edge_edge[faces].ravel()
        used = np.bincount(self._half_edge_edge, minlength=len(topology.edges)) > 0
        proper = topology.edges[:, 0] != topology.edges[:, 1]  # a repeated vertex makes a loop
        self._edges = np.flatnonzero(used & proper)
        self._ends = topology.edges[self._edges]
        self._vertices = np.unique(self._corners)
        frame = n + 3 * np.arange(len(topology.faces))
        axes = np.arange(3)
        own = frame[faces][:, None]
        low, high = frame[links.min(axis=1)], frame[links.max(axis=1)]
        self.rows: IntArray = np.concatenate(
            [
                self._ends[:, 1],
                self._vertices,
                np.tile((own + axes)[:, None, :], (1, 3, 1)).ravel(),
                (own + OWN_ROW).ravel(),
                (high[:, None] + axes).ravel(),
            ]
        )
        self.columns: IntArray = np.concatenate(
            [
                self._ends[:, 0],
                self._vertices,
                np.repeat(self._corners, 3),
                (own + OWN_COLUMN).ravel(),
                (low[:, None] + axes).ravel(),
            ]
        )

    def values(self, energy: RestEnergy, weights: ElementWeights) -> FloatArray:
        """(z,) the entries at `rows`, `columns`."""
        d, w = energy.vectors[self._faces], weights.stretching[self._faces]
        bending = weights.bending[self.links]
        edge = np.bincount(self._half_edge_edge, w.ravel())[self._edges]
        degree = np.bincount(self._ends.ravel(), np.repeat(edge, 2))
        wd = w[:, :, None] * d
        # Corner k starts half-edge k + 2 and ends half-edge k + 1.
        mixed = wd[:, HALF_EDGE_END] - wd[:, HALF_EDGE_START]
        own = np.matmul(wd.transpose(0, 2, 1), d)[:, OWN_ROW, OWN_COLUMN]
        joint = np.bincount(self._link_ends.ravel(), np.repeat(bending, 2), self._face_count)
        own[:, OWN_ROW == OWN_COLUMN] += joint[self._faces, None]
        across = np.repeat(-bending, 3)
        padded = np.append(degree, np.zeros(self._vertices.max(initial=-1) + 1 - len(degree)))
        return np.concatenate([-edge, padded[self._vertices], mixed.ravel(), own.ravel(), across])


def symmetric(
    rows: IntArray, columns: IntArray, values: FloatArray, shape: tuple[int, int]
) -> sp.csr_array:
    """The symmetric matrix with that lower triangle."""
    off = rows != columns
    entries = (
        np.concatenate([values, values[off]]),
        (np.concatenate([rows, columns[off]]), np.concatenate([columns, rows[off]])),
    )
    return sp.csr_array(sp.coo_array(entries, shape=shape))


def deformation_matrix(
    P: FloatArray, topology: Topology, bending_length: float, gains: Gains
) -> sp.csr_array:
    """K, (n + 3m, n + 3m), of the whole energy relative to the rest surface P (n, 3)."""
    energy = RestEnergy(P, topology)
    pattern = Pattern(topology, np.ones(len(topology.faces), dtype=bool))
    values = pattern.values(energy, energy.weights(bending_length, gains))
    size = topology.vertex_count + 3 * len(topology.faces)
    return symmetric(pattern.rows, pattern.columns, values, (size, size))
