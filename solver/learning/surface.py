"""The surface that softness is learned on: welded, and simplified where it is fine."""

from __future__ import annotations

from functools import cached_property

import numpy as np

from solver.coarse.carrier import Carrier
from solver.coarse.closest import NearbySurface
from solver.coarse.restriction import coarse_groups, restrict
from solver.linear.rest_surface import RestSurface
from solver.setup import Setup
from solver.surface.embedding import Embedding
from solver.types import BoolArray, FloatArray, IntArray

# Softness is smooth, and equilibria hardly depend on the mesh: so many vertices are enough. Each
# further piece takes some of its own, up to a limit: on the dressed figure of 38 pieces a soft
# elbow is found again with a correlation of .27 on 1000 vertices, .78 on 2000, .90 on 4000.
VERTICES, PER_PIECE, MOST_VERTICES = 1000, 100, 4000


class LearningSurface:
    """A surface (c, 3) of at most about MOST_VERTICES on which a shown mesh (n, 3) hangs."""

    def __init__(self, embedding: Embedding) -> None:
        self._embedding = embedding
        self._fine = RestSurface(embedding.vertices, embedding.topology)
        further = PER_PIECE * int(self._fine.pieces.max())
        count = min(VERTICES + further, MOST_VERTICES)
        many = len(embedding.vertices) > count
        self._carrier = Carrier(self._fine, count) if many else None
        self.rest: RestSurface = self._carrier.coarse if self._carrier else self._fine

    def pose(self, X: FloatArray) -> FloatArray:
        """(c, 3) a pose (n, 3) of the shown mesh, in the units of `rest.points`."""
        every = np.arange(len(X))
        X = self._embedding.targets(every, X, np.arange(len(self._embedding.vertices)))
        if self._carrier is not None:
            faces, weights = self._places
            X = np.einsum("ij,ijk->ik", weights, X[self._fine.faces[faces]])
        return self.rest.normalise(X)

    def setup(self, setup: Setup) -> Setup:
        """What holds the surface where `setup` holds the shown mesh. Raises ConstraintError."""
        setup = self._embedding.setup(setup)
        if self._carrier is None:
            return setup
        groups = setup.groups(len(self._fine.vertices))
        return restrict(self._carrier, setup, coarse_groups(self._carrier, groups))

    def softness(self, softness: FloatArray) -> FloatArray:
        """(n,) of the shown mesh, from that of the surface (c,)."""
        return np.clip(self._shown(softness), 0.0, 1.0)

    def shown_where(self, chosen: BoolArray) -> BoolArray:
        """(n,) the vertices of the shown mesh amid chosen ones (c,) of the surface."""
        return self._shown(chosen.astype(np.float64)) > 0.5

    def _shown(self, values: FloatArray) -> FloatArray:
        """Values (n,) at vertices of the shown mesh, from (c,)."""
        if self._carrier is not None:
            values = np.asarray(self._carrier.interpolation @ values)
        return np.asarray(self._embedding.apply(values[:, None])[:, 0])

    @cached_property
    def _places(self) -> tuple[IntArray, FloatArray]:
        """The fine triangle (c,) that each coarse vertex lies on, and barycentric weights there."""
        assert self._carrier is not None
        P, V, cell = self.rest.vertices, self._fine.vertices, self._carrier.cell
        used = np.flatnonzero(cell >= 0)
        distance = ((V[used] - P[cell[used]]) ** 2).sum(axis=1)
        order = used[np.lexsort((distance, cell[used]))]
        member = order[np.searchsorted(cell[order], np.arange(len(P)))]
        return NearbySurface(V, self._fine.faces).closest_of_few(P, member)
