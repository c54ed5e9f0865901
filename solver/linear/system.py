"""The factorised system of one bind: K restricted to the rows that can move."""

from __future__ import annotations

from functools import cached_property

import numpy as np
import scipy.sparse as sp

from solver.arrays import Array
from solver.factor import Analysis, Factor, analyse, check_factor
from solver.geometry.cotangent_weights import ElementWeights
from solver.linear.assembly import Pattern, symmetric
from solver.linear.constraints import Constraints
from solver.linear.joints import Joints
from solver.linear.rest_surface import RestSurface
from solver.setup import FIXED
from solver.types import BoolArray, FloatArray, IntArray

# A motion (4,) along one line that stretches and moves all: what `System.check` tries.
PROBE = np.array([0.5, -0.4, 0.3, 0.2])


class Structure:
    """Where the entries of K stand for one set of constraints, and the analysis of its free part.

    It knows nothing of the material, so that all binds with the same constraints share it.
    """

    def __init__(self, rest: RestSurface, constraints: Constraints) -> None:
        self.size = rest.row_count
        self.free = constraints.free
        self.joints = Joints(rest, constraints)
        strained = _strained(rest, constraints)
        strained[self.joints.faces] = True
        self.active = np.flatnonzero(strained)
        self.pattern = Pattern(rest.topology, strained)
        self.rows: IntArray = _joined(self.pattern.rows, self.joints.rows)
        self.columns: IntArray = _joined(self.pattern.columns, self.joints.columns)
        number = np.full(self.size, -1)
        number[self.free] = np.arange(len(self.free))
        rows, columns = number[self.rows], number[self.columns]
        self.inner = np.flatnonzero((rows >= 0) & (columns >= 0))
        #: Those between what is solved for and what is held.
        self.border = np.flatnonzero((rows >= 0) != (columns >= 0))
        moved = constraints.row_group > FIXED
        self.outer = np.flatnonzero(moved[self.rows] | moved[self.columns])
        order = rest.elimination_order
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

    def __init__(
        self,
        rest: RestSurface,
        structure: Structure,
        weights: ElementWeights,
        bending_length: float,
    ) -> None:
        self._rest, self._structure, self._weights = rest, structure, weights
        self._bending_length = bending_length
        own = structure.pattern.values(rest.energy, weights)
        self._values = _joined(own, structure.joints.values(bending_length))
        self.free = structure.free
        self.active = structure.active
        self.stiffness = float(np.abs(self._values).max(initial=0.0))
        #: The entries of K that have a handle's row or column.
        self.coupling = self._matrix(structure.outer)

    @cached_property
    def factor(self) -> Factor:
        """Of K restricted to the free rows."""
        return self._structure.analysis.factor(self._values[self._structure.inner])

    def respond(self, U: FloatArray) -> FloatArray:
        """U (n + 3m, k), zero but on handles, with its free rows where they minimise the energy."""
        U = U.copy()
        U[self.free] = -self.factor.solve((self.coupling @ U)[self.free])
        return U

    def check(self) -> None:
        """Raises FactorizationError where rounding spoils what the factor solves.

        Where all that is held moves by an affine map J T, everything does: K J = 0. What becomes of
        a motion of the whole surface tells.
        """
        known, border = self._rest.affine_rows @ PROBE, self._structure.border
        rows, columns = self._structure.rows[border], self._structure.columns[border]
        rows, columns = np.concatenate([rows, columns]), np.concatenate([columns, rows])
        pull: FloatArray = np.zeros(len(known))
        np.add.at(pull, rows, np.tile(self._values[border], 2) * known[columns])
        check_factor(self.factor, known[self.free], -pull[self.free])

    def matrix(self) -> sp.csr_array:
        """K (n + 3m, n + 3m), without what lies between rows that cannot move."""
        return self._matrix(slice(None))

    @property
    def bending(self) -> tuple[IntArray, FloatArray]:
        """(q, 2) numbers among the active triangles of those that a bending term joins, and l^2
        w_e^-1 beta_e of each, (q,)."""
        pattern, joints = self._structure.pattern, self._structure.joints
        ends = np.concatenate([self._rest.topology.links[pattern.links], joints.links])
        weights = self._weights.bending[pattern.links], joints.bending(self._bending_length)
        return np.searchsorted(self.active, ends), np.concatenate(weights)

    @property
    def stretching(self) -> FloatArray:
        """(a,) the sum over an active triangle's half-edges of w_eT sigma_e ||p_b - p_a||^2, and
        the same of its attachments."""
        d = self._rest.energy.vectors[self.active]
        own = np.einsum("ij,ijk,ijk->i", self._weights.stretching[self.active], d, d)
        return own + self._structure.joints.stretching(len(self._rest.faces))[self.active]

    def _matrix(self, which: IntArray | slice) -> sp.csr_array:
        size = self._structure.size
        rows, columns = self._structure.rows[which], self._structure.columns[which]
        return symmetric(rows, columns, self._values[which], (size, size))


def _joined(one: Array, two: Array) -> Array:
    """One array after the other; most surfaces have one piece, and nothing to copy."""
    return np.concatenate([one, two]) if len(two) else one


def _strained(rest: RestSurface, constraints: Constraints) -> BoolArray:
    """(m,) the triangles that can be strained: not those moving as one with all around them."""
    group = constraints.row_group
    n = len(rest.vertices)
    free = np.zeros(len(group), dtype=bool)
    free[constraints.free] = True
    frames = n + 3 * np.arange(len(rest.faces))
    rows = np.column_stack([rest.faces, frames])
    strained: BoolArray = free[rows].any(axis=1) | (group[rows] != group[frames, None]).any(axis=1)
    ends = frames[rest.topology.links]
    bent = free[ends].any(axis=1) | (group[ends[:, 0]] != group[ends[:, 1]])
    strained[rest.topology.links[bent].ravel()] = True
    return strained
