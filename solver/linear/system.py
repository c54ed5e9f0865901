"""The factorised system of one bind: K restricted to the rows that can move."""

from __future__ import annotations

import numpy as np
import scipy.sparse as sp

from solver.factor import Analysis, Factor, analyse
from solver.geometry.cotangent_weights import ElementWeights
from solver.linear.assembly import Pattern, symmetric
from solver.linear.constraints import FIXED, Constraints
from solver.linear.rest_surface import RestSurface
from solver.types import BoolArray, FloatArray, IntArray


class Structure:
    """Where the entries of K stand for one set of constraints, and the analysis of its free part.

    It knows nothing of the material, so that all binds with the same constraints share it.
    """

    def __init__(self, shape: RestSurface, constraints: Constraints) -> None:
        self.size = shape.row_count
        self.free = constraints.free
        strained = _strained(shape, constraints)
        self.active = np.flatnonzero(strained)
        self.pattern = Pattern(shape.topology, strained)
        number = np.full(self.size, -1)
        number[self.free] = np.arange(len(self.free))
        rows, columns = number[self.pattern.rows], number[self.pattern.columns]
        self.inner = np.flatnonzero((rows >= 0) & (columns >= 0))
        moved = constraints.row_group > FIXED
        self.outer = np.flatnonzero(moved[self.pattern.rows] | moved[self.pattern.columns])
        order = shape.elimination_order
        if order is not None:
            order = number[order]
            order = order[order >= 0]
        self.analysis: Analysis = analyse(
            rows[self.inner], columns[self.inner], len(self.free), order
        )


class System:
    """K of one material, with the factor of its free part.

    free: the rows to solve for.  active: the triangles that can be strained.
    stiffness: the largest entry of K, the unit in which an energy
    counts as zero.
    """

    def __init__(self, shape: RestSurface, structure: Structure, weights: ElementWeights) -> None:
        self._structure = structure
        self._values = structure.pattern.values(shape.energy, weights)
        self.free = structure.free
        self.active = structure.active
        self.factor: Factor = structure.analysis.factor(self._values[structure.inner])
        self.stiffness = float(np.abs(self._values).max(initial=0.0))
        #: The entries of K that have a handle's row or column.
        self.coupling = self._matrix(structure.outer)

    def respond(self, U: FloatArray) -> FloatArray:
        """U (n + 3m, k), zero but on handles, with its free rows where they minimise the energy."""
        U = U.copy()
        U[self.free] = -self.factor.solve((self.coupling @ U)[self.free])
        return U

    def matrix(self) -> sp.csr_array:
        """K (n + 3m, n + 3m), without what lies between rows that cannot move."""
        return self._matrix(slice(None))

    def _matrix(self, which: IntArray | slice) -> sp.csr_array:
        pattern, size = self._structure.pattern, self._structure.size
        rows, columns = pattern.rows[which], pattern.columns[which]
        return symmetric(rows, columns, self._values[which], (size, size))


def _strained(shape: RestSurface, constraints: Constraints) -> BoolArray:
    """(m,) the triangles that can be strained: not those moving as one with all around them."""
    group = constraints.row_group
    n = len(shape.vertices)
    free = np.zeros(len(group), dtype=bool)
    free[constraints.free] = True
    frames = n + 3 * np.arange(len(shape.faces))
    rows = np.column_stack([shape.faces, frames])
    strained: BoolArray = free[rows].any(axis=1) | (group[rows] != group[frames, None]).any(axis=1)
    ends = frames[shape.topology.links]
    bent = free[ends].any(axis=1) | (group[ends[:, 0]] != group[ends[:, 1]])
    strained[shape.topology.links[bent].ravel()] = True
    return strained
