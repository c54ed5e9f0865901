"""A shown mesh with seams on a solved surface without them. See Embedding."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from solver.arrays import as_floats
from solver.errors import ConstraintError, MaterialError, SolverError
from solver.geometry.topology import Topology
from solver.setup import FIXED, FREE, Setup
from solver.types import FloatArray, IntArray


class Seams:
    """Each shown vertex moves as the solved vertex it was welded into."""

    def __init__(self, vertices: FloatArray, topology: Topology, welded: IntArray) -> None:
        """vertices, topology: of the shown mesh.  welded: (n',) see `weld`."""
        self.shown = vertices
        self._welded = welded
        self._copies = np.bincount(welded)
        first = np.unique(welded, return_index=True)[1]
        self.vertices: FloatArray = vertices[first]
        self.topology = Topology(welded[topology.faces], len(first))

    def setup(self, setup: Setup) -> Setup:
        """A welded vertex has the role of its copies: where they differ that of the first handle,
        else fixed. Its softness is the mean of theirs."""
        group = setup.groups(len(self.shown))
        welded = np.full(len(self.vertices), FREE)
        for number in (FIXED, *range(len(setup.handles), FIXED, -1)):
            welded[self._welded[group == number]] = number
        handles = [np.flatnonzero(welded == 1 + h) for h in range(len(setup.handles))]
        changes: dict[str, object] = {"handles": handles, "fixed": np.flatnonzero(welded == FIXED)}
        if setup.softness is not None:
            changes["softness"] = self._mean(setup.softness, "softness", MaterialError)
        if setup.edge_gains is not None:
            edges, *gains = setup.edge_gains
            changes["edge_gains"] = (self._welded[edges], *gains)
        return setup.changed(**changes)

    def weights(self, weights: ArrayLike) -> FloatArray:
        """The mean of the copies' weights."""
        given = as_floats(weights, "grab weights", ConstraintError)
        return self._mean(given, "grab weights", ConstraintError)

    def targets(self, vertices: IntArray, targets: FloatArray, solved: IntArray) -> FloatArray:
        """The mean of what is asked of the copies."""
        at = np.searchsorted(solved, self._welded[vertices])
        known = np.isin(self._welded[vertices], solved)
        moves = (targets - self.shown[vertices])[known]
        total = np.zeros((len(solved), 3))
        np.add.at(total, at[known], moves)
        counts = np.bincount(at[known], minlength=len(solved))
        return self.vertices[solved] + total / np.maximum(counts, 1)[:, None]

    def apply(self, rows: FloatArray) -> FloatArray:
        return rows[self._welded]

    def apply_rigid(self, displacement: FloatArray, rotations: FloatArray) -> FloatArray:
        return displacement[self._welded]

    def _mean(self, values: FloatArray, what: str, error: type[SolverError]) -> FloatArray:
        if values.shape != self._welded.shape:
            raise error(f"{what} must be {self._welded.shape}, got {values.shape}")
        return np.asarray(np.bincount(self._welded, values) / self._copies)
