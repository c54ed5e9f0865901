"""The border of what is held: where the carried surface meets vertices that are exact."""

from __future__ import annotations

from functools import cached_property

import numpy as np
import scipy.sparse as sp

from solver.coarse.carrier import Carrier
from solver.factor import Factor, factorize
from solver.geometry.laplacian import cotangent_laplacian
from solver.setup import FREE
from solver.types import BoolArray, FloatArray, IntArray


class Border:
    """Sets held vertices exactly, and lets the difference fade out harmonically beside them.

    A coarse triangle across the border of a handle carries held vertices nearly, not exactly.
    What they lack is spread over the free vertices within about a coarse edge, so that the
    surface has no step there.
    """

    def __init__(self, carrier: Carrier, group: IntArray, coarse_group: IntArray) -> None:
        """group, coarse_group: what holds the vertices of either surface, see Setup.groups."""
        self._carrier = carrier
        self.held = np.flatnonzero(group != FREE)
        self._band = np.flatnonzero((group == FREE) & _near_border(carrier, group, coarse_group))

    def meet(self, X: FloatArray, wanted: FloatArray) -> FloatArray:
        """X (n, j) with `wanted`, (h, j), at held vertices; the free ones beside them follow."""
        lacking = np.zeros_like(X)
        lacking[self.held] = wanted - X[self.held]
        X = X.copy()
        if len(self._band):
            factor, rows, around = self._laplacian
            X[self._band] -= factor.solve(np.asarray(rows @ lacking[around]))
        X[self.held] = wanted
        return X

    @cached_property
    def _laplacian(self) -> tuple[Factor, sp.csr_array, IntArray]:
        """Factor over the band, its rows of the Laplacian, and the vertices of their columns."""
        rest = self._carrier.fine
        inside = np.zeros(len(rest.vertices), dtype=bool)
        inside[self._band] = True
        faces = rest.faces[inside[rest.faces].any(axis=1)]
        around, local = np.unique(faces, return_inverse=True)
        L = cotangent_laplacian(rest.points[around], local.reshape(-1, 3))
        band = np.flatnonzero(inside[around])
        rows = L[band]
        return factorize(rows[:, band]), rows, around


def _near_border(carrier: Carrier, group: IntArray, coarse_group: IntArray) -> BoolArray:
    """(n,) the vertices carried by a coarse vertex that helps to carry what is held inexactly."""
    rest, weights = carrier.coarse, carrier.weights
    exact = np.where(_whole(coarse_group, rest.faces), coarse_group, FREE)
    vertex = np.repeat(np.arange(len(group)), np.diff(weights.indptr))
    differs = exact[weights.indices] != group[vertex]
    near = np.zeros(len(rest.vertices), dtype=bool)
    inexact = np.zeros(len(group), dtype=bool)
    inexact[vertex[differs & (group[vertex] != FREE)]] = True
    near[weights.indices[inexact[vertex]]] = True
    edges = rest.topology.edges
    near[edges[near[edges].any(axis=1)]] = True
    return np.asarray(np.bincount(vertex[near[weights.indices]], minlength=len(group)) > 0)


def _whole(coarse_group: IntArray, faces: IntArray) -> BoolArray:
    """(c,) the coarse vertices all of whose triangles are held by one group: frames are exact."""
    same = (coarse_group[faces] == coarse_group[faces[:, :1]]).all(axis=1)
    whole = coarse_group != FREE
    whole[faces[~same]] = False
    return np.asarray(whole)
