"""Connectivity of a triangle mesh: edges, neighbouring triangles, connected components.

Half-edge k of triangle t lies opposite its corner k and runs from corner k+1 to corner k+2
(indices modulo 3), so that the cotangent at corner k is the weight of half-edge k.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
import scipy.sparse as sp
from scipy.sparse.csgraph import connected_components

from solver.types import BoolArray, FloatArray, IntArray

HALF_EDGE_START = np.array([1, 2, 0])
HALF_EDGE_END = np.array([2, 0, 1])
# Pairs grow with the square of the triangles at an edge. Above so many each is paired with the
# first alone, as a spoke with its hub: all still turn together, and the factor stays sparse.
CROWDED = 16


@dataclass(frozen=True)
class FacePairs:
    """Neighbouring triangles, one row for each two triangles that share an edge.

    An edge with k > 2 triangles appears once for every two of them; above CROWDED only with its
    first and each other one.

    first, second: (p,) the triangles, first < second.
    half_first, half_second: (p,) which half-edge (0, 1, 2) of each lies on the shared edge.
    edge: (p,) the shared edge.  valence: (p,) how many triangles that edge has.
    partners: (p,) with how many others each of them is paired, in the mean: k - 1, or 2 - 2/k.
    """

    first: IntArray
    second: IntArray
    half_first: IntArray
    half_second: IntArray
    edge: IntArray
    valence: IntArray
    partners: FloatArray

    def where(self, keep: BoolArray) -> FacePairs:
        """The rows of `keep`, (p,)."""
        ends = self.first[keep], self.second[keep], self.half_first[keep], self.half_second[keep]
        return FacePairs(*ends, self.edge[keep], self.valence[keep], self.partners[keep])


class Topology:
    """Edges and neighbours of `faces` (m, 3) over `vertex_count` vertices.

    edges: (e, 2) unique, each sorted, in lexicographic order.
    half_edge_edge: (m, 3) the edge under each half-edge.
    """

    def __init__(self, faces: IntArray, vertex_count: int) -> None:
        self.faces = faces
        self.vertex_count = vertex_count
        start, end = faces[:, HALF_EDGE_START], faces[:, HALF_EDGE_END]
        low, high = np.minimum(start, end), np.maximum(start, end)
        keys, inverse = np.unique((low * vertex_count + high).ravel(), return_inverse=True)
        self.edges: IntArray = np.column_stack(np.divmod(keys, vertex_count))
        self.half_edge_edge: IntArray = inverse.reshape(faces.shape)
        self.half_edge_forward: BoolArray = start <= end

    @cached_property
    def valence(self) -> IntArray:
        """(e,) how many triangles each edge has."""
        return np.bincount(self.half_edge_edge.ravel(), minlength=len(self.edges))

    @cached_property
    def pairs(self) -> FacePairs:
        """Every two triangles that share an edge; see FacePairs."""
        edge_of = self.half_edge_edge.ravel()
        order = np.argsort(edge_of, kind="stable")  # stable: lower triangles come first
        sorted_edges = edge_of[order]
        crowded = self.valence[sorted_edges] > CROWDED
        places = np.flatnonzero(crowded)
        first = np.searchsorted(sorted_edges, sorted_edges[places])
        left, right = [order[first[first < places]]], [order[places[first < places]]]
        for step in range(1, min(int(self.valence.max(initial=1)), CROWDED)):
            same = (sorted_edges[:-step] == sorted_edges[step:]) & ~crowded[step:]
            at = np.flatnonzero(same)
            left.append(order[at])
            right.append(order[at + step])
        one, two = np.concatenate(left), np.concatenate(right)
        distinct = one // 3 != two // 3  # a triangle with a repeated vertex meets itself
        one, two = one[distinct], two[distinct]
        edge = edge_of[one]
        k = self.valence[edge]
        partners = np.where(k > CROWDED, 2.0 - 2.0 / k, k - 1.0)
        return FacePairs(one // 3, two // 3, one % 3, two % 3, edge, k, partners)

    @cached_property
    def manifold_pairs(self) -> FacePairs:
        """The pairs across edges with exactly two triangles: those with a dihedral angle."""
        return self.pairs.where(self.pairs.valence == 2)

    @cached_property
    def links(self) -> IntArray:
        """(q, 2) the triangles that a bending term joins: `pairs`, then `pinches`."""
        pairs = np.column_stack([self.pairs.first, self.pairs.second])
        return np.concatenate([pairs, self.pinches])

    @cached_property
    def vertex_component(self) -> IntArray:
        """(n,) the connected component of each vertex; an unreferenced vertex is one by itself."""
        return components(self.edges, self.vertex_count)

    @cached_property
    def face_component(self) -> IntArray:
        """(m,) components of triangles joined through shared edges."""
        return components(np.column_stack([self.pairs.first, self.pairs.second]), len(self.faces))

    @cached_property
    def pinches(self) -> IntArray:
        """(q, 2) triangles that meet at a vertex although no chain of shared edges joins them.

        Links enough of them that triangles connected through vertices are connected at all:
        without a link nothing would tell such triangles how to turn against each other.
        """
        vertex = self.faces.ravel()
        face = np.repeat(np.arange(len(self.faces)), 3)
        component = self.face_component[face]
        order = np.lexsort((component, vertex))
        vertex, face, component = vertex[order], face[order], component[order]
        meets = (vertex[:-1] == vertex[1:]) & (component[:-1] != component[1:])
        return np.column_stack([face[:-1][meets], face[1:][meets]])


def components(links: IntArray, count: int) -> IntArray:
    """(count,) the connected component of each node; links (q, 2) join them."""
    graph = sp.coo_array((np.ones(len(links)), (links[:, 0], links[:, 1])), shape=(count, count))
    labels: IntArray = connected_components(graph, directed=False)[1].astype(np.int64)
    return labels


def half_edge_vectors(P: FloatArray, faces: IntArray) -> FloatArray:
    """(m, 3, 3): row k of triangle t is the vector along its half-edge k."""
    return P[faces[:, HALF_EDGE_END]] - P[faces[:, HALF_EDGE_START]]
