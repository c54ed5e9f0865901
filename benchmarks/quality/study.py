"""How shapes change with l_r and with the number of rounds, beside plain local/global rounds."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import scipy.sparse as sp

from benchmarks.cases.case import Case
from solver import Setup
from solver.geometry.rotations import nearest_rotations
from solver.linear.assembly import deformation_matrix
from solver.linear.binding import bind
from solver.linear.rest_surface import RestSurface
from solver.rigid.levels import RigidLevels
from solver.softness.material import Material
from solver.types import FloatArray

LENGTHS = (0.02, 0.03, 0.05, 0.075, 0.1, 0.15)
SETTLED = 60
"""Rounds after which nothing changes any more."""
GAINS = (1.0, 0.3, 0.1, 0.01)
PLAIN_LENGTH = 3e-4
PLAIN_ROUNDS = (1, 2, 4, 6, 10, 20)


class Study:
    """One case, refined with any l_r."""

    def __init__(self, case: Case, bending_gain: float = 0.1) -> None:
        material = Material(bending_gain, 1.0)
        rest = RestSurface.of(case.V, case.F)
        self._binding = bind(rest, Setup(case.fixed, case.handles, case.softness, material))
        deformer = case.deformer(material=material)
        X = rest.normalise(deformer.pose(case.transforms))
        rows = deformer.frames(case.transforms).transpose(0, 2, 1).reshape(-1, 3)
        self.U = np.vstack([X, rows])

    def refined(self, rotation_length: float, rounds: int) -> FloatArray:
        """X, (n, 3), at level `rounds` with this l_r in place of the solver's."""
        binding = self._binding
        levels = RigidLevels(
            binding.rest,
            binding.constraints,
            binding.system,
            (),
            binding.bending_length,
            rotation_length,
        )
        return self._world(levels.refine(self.U, rounds).positions)

    def plain(self, rounds: int) -> Iterator[FloatArray]:
        """X after each of some local/global rounds with neighbours' rotations, unaccelerated.

        R_t = nearest rotation to sum_e w_eT d x' + l_r^2 sum_j w_e^-1 R_j, then positions.
        """
        binding = self._binding
        rest, n = binding.rest, len(binding.rest.points)
        free = binding.constraints.free
        turning = (free[free >= n][::3] - n) // 3
        levels = RigidLevels(rest, binding.constraints, binding.system, (), 1.0)
        ones = np.ones(len(rest.topology.edges))
        K = deformation_matrix(rest.points, rest.topology, PLAIN_LENGTH, (ones, ones))
        links = sp.coo_array(K[n::3][:, n::3])
        links.data[links.coords[0] == links.coords[1]] = 0.0
        R = nearest_rotations(self.U[n:].reshape(-1, 3, 3))
        none = np.empty((0, 3))
        active = binding.system.active
        for _ in range(rounds):
            X = levels.poisson.positions(self.U[:n], R[active], none)
            yield self._world(X)
            fit = -(K[n:, :n] @ X).reshape(-1, 3, 3)
            fit -= (links @ R.reshape(-1, 9)).reshape(-1, 3, 3)
            R[turning] = nearest_rotations(fit[turning])

    def _world(self, X: FloatArray) -> FloatArray:
        rest = self._binding.rest
        return rest.vertices + rest.scale * (X - rest.points)


def strain_and_dihedral(case: Case, X: FloatArray) -> tuple[float, float]:
    found = case.quality(X)
    return found.strain, found.dihedral
