"""What carries a coarse surface's motion to the fine one: the operator E, once a mesh."""

from __future__ import annotations

from functools import cached_property

import numpy as np
import scipy.sparse as sp

from solver.coarse.closest import NearbySurface
from solver.coarse.simplification import Simplification, simplify
from solver.factor import minimum_degree
from solver.geometry.cross_products import triangle_areas
from solver.geometry.topology import Topology
from solver.linear.rest_surface import RestSurface
from solver.surface.attachments import Attachments
from solver.types import FloatArray, IntArray

# Of averaging the weights: two take the coarse edges away, more only fill the matrix.
SWEEPS = 2
# Edges at a vertex: at poles of spheres there are some hundred.
CROWDED = 500


class Carrier:
    """A fine surface that hangs on a coarse one.

    Coarse vertices carry a fine vertex v as each would by itself, in the mean M_i of the frames
    around it, with weights w_i that add up to 1:

        x = sum w_i (x_i + M_i (v - p_i))

    which is exact for affine motions. The weights are barycentric at the closest point of v, made
    smoother by a few sweeps of averaging between fine neighbours: otherwise the coarse edges show.

    fine, coarse: both surfaces at rest.  cell: (n,) see Simplification.
    corners, barycentric: (n, 3) of the coarse triangle closest to each fine vertex.
    """

    def __init__(self, fine: RestSurface, count: int) -> None:
        """count: of coarse vertices at most; fewer than fine ones, or nothing is gained."""
        self.fine = fine
        simple = simplify(fine.vertices, fine.topology, count)
        surface = NearbySurface(simple.vertices, simple.faces)
        self.cell = simple.cell
        used = np.flatnonzero(simple.cell >= 0)
        face, barycentric = surface.closest(fine.vertices[used], simple.cell[used])
        self.corners: IntArray = np.zeros((len(simple.cell), 3), dtype=np.int64)
        self.barycentric: FloatArray = np.zeros((len(simple.cell), 3))
        self.corners[used], self.barycentric[used] = simple.faces[face], barycentric
        self.coarse = _coarse_rest(fine, simple, surface)

    def prepare(self) -> None:
        """Find now what is otherwise found when it is first needed."""
        _ = self.weights, self._arms, self.vertex_means, self.elimination_order

    @cached_property
    def elimination_order(self) -> IntArray | None:
        """(n,) an order of the fine vertices that keeps factors sparse, see RestSurface."""
        rest, terms = self.fine, self.fine.attachments
        joined = np.column_stack([np.repeat(terms.vertex, 3), rest.faces[terms.face].ravel()])
        one, two = np.concatenate([rest.topology.edges, joined]).T
        return minimum_degree(np.maximum(one, two), np.minimum(one, two), len(rest.vertices))

    @cached_property
    def vertex_means(self) -> sp.csr_array:
        """(c, k) the mean over a coarse vertex's triangles, by area."""
        faces, P = self.coarse.faces, self.coarse.points
        area = triangle_areas(P, faces) + np.finfo(float).tiny
        index = faces.ravel(), np.repeat(np.arange(len(faces)), 3)
        shape = (len(P), len(faces))
        sums = sp.csr_array(sp.coo_array((np.repeat(area, 3), index), shape=shape))
        total = np.maximum(sums.sum(axis=1), np.finfo(float).tiny)
        return sp.csr_array(sp.diags_array(1.0 / total) @ sums)

    @cached_property
    def interpolation(self) -> sp.csr_array:
        """(n, c) barycentric weights."""
        n, count = len(self.corners), len(self.coarse.vertices)
        ends = np.arange(0, 3 * n + 1, 3)
        entries = self.barycentric.ravel(), self.corners.ravel(), ends
        return sp.csr_array(entries, shape=(n, count))

    @cached_property
    def weights(self) -> sp.csr_array:
        """(n, c) the weights w."""
        edges, n = self.fine.topology.edges, len(self.corners)
        ends = np.concatenate([edges, edges[:, ::-1]]).T
        around = sp.csr_array(sp.coo_array((np.ones(ends.shape[1]), tuple(ends)), shape=(n, n)))
        degree = np.maximum(around.sum(axis=1), 1.0)
        # A vertex with very many neighbours keeps its own weights: through it all the others would
        # get those of each other, and the matrix be full.
        crowded = degree > CROWDED
        share = np.where(crowded, 0.0, 1.0 / degree)
        average = 0.5 * (sp.diags_array(share) @ around + sp.diags_array(1.0 * crowded))
        weights = self.interpolation
        for _ in range(SWEEPS):
            weights = 0.5 * weights + average @ weights
        return sp.csr_array(weights)

    @cached_property
    def _arms(self) -> sp.csr_array:
        """(n, 3c) w_i (v - p_i), in the coarse surface's units."""
        weights, points = self.weights, self.coarse.normalise(self.fine.vertices)
        vertex = np.repeat(np.arange(len(points)), np.diff(weights.indptr))
        arms = points[vertex] - self.coarse.points[weights.indices]
        columns = 3 * weights.indices[:, None] + np.arange(3)
        entries = (weights.data[:, None] * arms).ravel(), columns.ravel(), 3 * weights.indptr
        return sp.csr_array(entries, shape=(len(points), 3 * len(self.coarse.points)))

    def vertex_frames(self, frames: FloatArray) -> FloatArray:
        """(3c, j) mean rows of frames at coarse vertices, from those of triangles (3k, j)."""
        count, width = frames.shape
        means = self.vertex_means @ frames.reshape(count // 3, 3 * width)
        return np.asarray(means).reshape(3 * len(self.coarse.vertices), width)

    def carry(self, rows: FloatArray) -> FloatArray:
        """E rows, (n, j), for a change of the coarse U or a basis, (c + 3k, j)."""
        count = len(self.coarse.vertices)
        frames = self.vertex_frames(rows[count:])
        return np.asarray(self.weights @ rows[:count] + self._arms @ frames)

    def gather(self, values: FloatArray) -> FloatArray:
        """E' values, (c + 3k, j), for values (n, j) at the fine vertices."""
        frames = self._arms.T @ values
        count, width = frames.shape
        faces = np.asarray(self.vertex_means.T @ frames.reshape(count // 3, 3 * width))
        return np.concatenate([self.weights.T @ values, faces.reshape(-1, width)])

    def mean(self, values: FloatArray) -> FloatArray:
        """(c,) the mean of values (n,) over the cell of each coarse vertex."""
        used = self.cell >= 0
        count = len(self.coarse.vertices)
        sums = np.bincount(self.cell[used], values[used], count)
        return np.asarray(sums / np.bincount(self.cell[used], minlength=count))


def _coarse_rest(fine: RestSurface, simple: Simplification, surface: NearbySurface) -> RestSurface:
    """The coarse surface, its pieces attached where those of the fine one are."""
    topology = Topology(simple.faces, len(simple.vertices))
    own = RestSurface(simple.vertices, topology, Attachments.none())
    terms = fine.attachments
    if len(terms) == 0:
        return own
    vertex = simple.cell[terms.vertex]
    face, weights = surface.closest(simple.vertices[vertex], simple.cell[fine.faces[terms.face, 0]])
    foot = np.einsum("ij,ijk->ik", weights, own.points[simple.faces[face]])
    own_face = np.zeros(len(simple.vertices), dtype=np.int64)
    own_face[simple.faces.ravel()] = np.repeat(np.arange(len(simple.faces)), 3)
    offset = own.points[vertex] - foot
    attachments = Attachments(
        vertex, own_face[vertex], face, weights, offset, terms.weight, terms.follower
    )
    return RestSurface(simple.vertices, topology, attachments)
