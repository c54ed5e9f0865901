"""The rest surface in normalised units: connectivity, energy and elimination order."""

from __future__ import annotations

from functools import cached_property

import numpy as np

from solver.factor import minimum_degree
from solver.geometry.topology import Topology
from solver.geometry.welding import number_pieces
from solver.linear.energy import RestEnergy
from solver.surface.attachments import Attachments
from solver.surface.contacts import find_attachments
from solver.types import FloatArray, IntArray


class RestSurface:
    """Positions in units of the diagonal of what faces use, about its centre, and connectivity.

    In these units positions and frames have one magnitude, and nothing depends on the scale or
    the place of the file.

    vertices, faces: as given.  points: (n, 3) the same vertices in normalised units.
    """

    def __init__(
        self, vertices: FloatArray, topology: Topology, attachments: Attachments | None = None
    ) -> None:
        """attachments: what can join the pieces, in normalised units; None to have it found."""
        self.vertices = vertices
        self.topology = topology
        self.faces = topology.faces
        self._attachments = attachments
        # A stray vertex that no face uses may lie anywhere, and must not change a result.
        used = self.vertices[self.faces.ravel()] if len(self.faces) else self.vertices
        low, high = used.min(axis=0), used.max(axis=0)
        self.centre: FloatArray = 0.5 * (low + high)
        self.scale = float(np.linalg.norm(high - low)) or 1.0  # all vertices in one point
        self.points: FloatArray = (self.vertices - self.centre) / self.scale

    @staticmethod
    def of(vertices: FloatArray, faces: IntArray) -> RestSurface:
        """From triangles alone."""
        return RestSurface(vertices, Topology(faces, len(vertices)))

    @property
    def row_count(self) -> int:
        """n + 3m: a row for each vertex, three for each triangle."""
        return len(self.vertices) + 3 * len(self.faces)

    def rows(self, per_vertex: np.ndarray, per_face: np.ndarray) -> np.ndarray:
        """One value for each row of U from one a vertex and one a triangle."""
        return np.concatenate([per_vertex, np.repeat(per_face, 3)])

    @cached_property
    def energy(self) -> RestEnergy:
        """What the energy takes from the rest positions."""
        return RestEnergy(self.points, self.topology)

    @cached_property
    def elimination_order(self) -> IntArray | None:
        """(n + 3m,) an order of U's rows that keeps factors sparse; None where none is found.

        Found once for a mesh, on the graph of its vertices and triangles: the three rows of a
        triangle belong together. What stays of it when some rows are held is a good order too.
        """
        n, m = len(self.vertices), len(self.faces)
        topology, attached = self.topology, self.attachments
        corners = np.column_stack([n + np.repeat(np.arange(m), 3), self.faces.ravel()])
        near = np.column_stack([self.faces[attached.face], n + attached.face])
        joints = np.column_stack([np.repeat(attached.vertex, 4), near.ravel()])
        frames = n + np.column_stack([attached.own_face, attached.face])
        graph = np.concatenate([topology.edges, corners, n + topology.links, joints, frames])
        one, two = graph.T  # reducing rows of two is several times slower
        order = minimum_degree(np.maximum(one, two), np.minimum(one, two), n + m)
        if order is None:
            return None
        size = np.where(order < n, 1, 3)
        first = np.where(order < n, order, 3 * order - 2 * n)
        within = np.arange(size.sum()) - np.repeat(np.cumsum(size) - size, size)
        return np.repeat(first, size) + within

    @cached_property
    def affine_rows(self) -> FloatArray:
        """J, (n + 3m, 4), with U = J T for a surface that moves by the affine map T (4, 3)."""
        J = np.zeros((self.row_count, 4))
        n = len(self.points)
        J[:n, :3] = self.points
        J[:n, 3] = 1.0
        J[n:, :3] = np.tile(np.eye(3), (len(self.faces), 1))
        return J

    @cached_property
    def pieces(self) -> IntArray:
        """(n,) the number of each vertex's connected piece, see `number_pieces`."""
        return number_pieces(self.topology.vertex_component, self.faces)

    @cached_property
    def attachments(self) -> Attachments:
        """What can join the pieces, in normalised units."""
        if self._attachments is not None:
            return self._attachments
        return find_attachments(self.points, self.topology, self.pieces)

    def normalise(self, X: FloatArray) -> FloatArray:
        """World positions in normalised units."""
        return (X - self.centre) / self.scale
