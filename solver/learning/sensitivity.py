"""How an equilibrium of the levels gives way: the second derivative of its energy.

At an equilibrium the energy E(X, R) of SmoothRotationEnergy is least: no small turn w of its
triangles lowers it, positions following. A load on it, a slope of something else by turns and
positions, is answered by H w = load with H the second derivative, by conjugate gradients on top of
the factorised estimate of H that the levels have.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from solver.geometry.cross_products import cross
from solver.geometry.rotations import torques
from solver.rigid.lbfgs import inner
from solver.rigid.levels import RigidLevels, RigidPose
from solver.types import FloatArray

# The answer is exact to this share, measured by the energy; it takes about ten iterations.
ACCURACY, ITERATIONS = 1e-2, 40


@dataclass(frozen=True)
class Change:
    """A small change of a pose: positions (n, 3), and the rows (a, 3, 3) of R' of triangles."""

    positions: FloatArray
    rotations: FloatArray


class Sensitivity:
    """The second derivative of the energy at one pose, an equilibrium or nearly."""

    def __init__(self, levels: RigidLevels, pose: RigidPose) -> None:
        self._levels = levels
        self._rows = pose.rotations[levels.turning]
        self._pull = self._pulls(pose.positions, pose.rotations)[levels.turning]

    def answer(self, load: Change) -> Change:
        """How the pose gives way to a load: by its free positions, and by the rows of R'."""
        levels = self._levels
        direct = levels.poisson.answer(load.positions)
        push = load.rotations - self._pulls(direct, np.zeros_like(load.rotations))
        change = self._turned(torques(self._rows, push[levels.turning]))
        return Change(change.positions + direct, change.rotations)

    def _turned(self, load: FloatArray) -> Change:
        """The answer to a torque (t, 3) on each triangle that can turn: H w = load."""
        inverse = self._levels.energy.hessian.solve
        residual, z = load, inverse(load)
        direction, size = z, inner(load, z)
        w, least = np.zeros_like(load), ACCURACY**2 * size
        for _ in range(ITERATIONS):
            if size <= least:
                break
            product = self._product(direction)
            curvature = inner(direction, product)
            if curvature <= 0:  # no minimum that way: what is known so far has to do
                break
            w = w + size / curvature * direction
            residual = residual - size / curvature * product
            z = inverse(residual)
            before, size = size, inner(residual, z)
            direction = z + size / before * direction
        return self._following(w)

    def _product(self, w: FloatArray) -> FloatArray:
        """H w, (t, 3)."""
        change = self._following(w)
        rows = change.rotations[self._levels.turning]
        push = self._pulls(change.positions, change.rotations)[self._levels.turning]
        return torques(self._rows, push) + torques(rows, self._pull)

    def _following(self, w: FloatArray) -> Change:
        """What small turns w (t, 3) do to the rows of R', and to positions that follow."""
        levels = self._levels
        rows = np.zeros((levels.energy.count, 3, 3))
        axis = np.ascontiguousarray(w.T)[:, None, :]
        rows[levels.turning] = cross(axis, self._rows.transpose(2, 1, 0)).transpose(2, 1, 0)
        still = np.zeros((levels.energy.vertex_count, 3))
        moments = levels.poisson.moments(still)
        return Change(levels.poisson.positions(still, rows, moments), rows)

    def _pulls(self, X: FloatArray, R: FloatArray) -> FloatArray:
        """(a, 3, 3) the slope of E by the rows of R'."""
        return self._levels.energy.slope(X, R)[len(X) :].reshape(-1, 3, 3)
