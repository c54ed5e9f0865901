"""The levels of `rigid`: from linear frames to rotations, and rounds that lower their energy."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import islice

import numpy as np
from scipy.spatial.transform import Rotation

from solver.geometry.rotations import nearest_rotations, turned
from solver.linear.constraints import Constraints
from solver.linear.grab import Grab
from solver.linear.rest_surface import RestSurface
from solver.linear.system import System
from solver.rigid.lbfgs import LBFGS, inner
from solver.rigid.poisson import PoissonProblem
from solver.rigid.smooth_rotations import ROTATION_LENGTH, SmoothRotationEnergy
from solver.types import FloatArray, IntArray

# No triangle turns by more than this in one round, in radians: small turns model the energy.
LARGEST_TURN = 1.0
# A step is taken when it lowers the energy by this share of what its slope promises.
SUFFICIENT = 1e-4
SHORTENING, SHORTEST = 0.4, 1e-3
# Rounds end when the next one promises less than this share of the energy, or less than what
# rounding leaves of it.
STILL, ROUNDING = 1e-9, 1e-15


@dataclass(frozen=True)
class RigidPose:
    """Positions (n, 3) and the rotations that they suit: (a, 3, 3) rows of R' of active triangles.

    The other triangles move as one with all around them: their frames are affine already.
    """

    positions: FloatArray
    rotations: FloatArray


@dataclass(frozen=True)
class State(RigidPose):
    """A pose with its energy, and the gradient of that by small turns."""

    energy: float
    gradient: FloatArray


class RigidLevels:
    """Rotations from linear frames, positions from rotations, and rounds of both.

    poisson: positions from rotations.  turning: those of the system's active triangles, by number,
    that are free to turn.
    """

    def __init__(
        self,
        rest: RestSurface,
        constraints: Constraints,
        system: System,
        grabs: Sequence[Grab],
        bending_length: float,
        rotation_length: float = ROTATION_LENGTH,
    ) -> None:
        """bending_length: l, as it is in the system.  rotation_length: l_r; both in diagonals."""
        n = len(rest.vertices)
        self._n = n
        self._system = system
        # Rotations are wanted where they matter: on triangles that something can strain.
        active = system.active
        self._frames = (n + 3 * active[:, None] + np.arange(3)).ravel()
        kept = np.concatenate([np.arange(n), self._frames])
        self._K = system.matrix()[kept][:, kept]
        self.poisson = PoissonProblem(self._K, constraints.free[constraints.free < n], grabs)
        # Held, carried and resting frames are right already: a round leaves them alone.
        turning = constraints.free[constraints.free >= n]
        self.turning: IntArray = np.searchsorted(active, (turning[::3] - n) // 3)
        self._ratio = (rotation_length / bending_length) ** 2

    @cached_property
    def energy(self) -> SmoothRotationEnergy:
        return SmoothRotationEnergy(self._system, self._K, self.turning, self._ratio)

    def refine(
        self,
        U: FloatArray,
        level: int,
        others: Sequence[FloatArray] = (),
        before: FloatArray | None = None,
    ) -> RigidPose:
        """From rows U (n + 3m, 3) of the linear result.

        The first round takes the nearest rotation of every frame and solves for positions; for
        the others see `descend`. They start from each of `others`, rows of R' of active triangles,
        too, and the end of lowest energy counts. From `before`, the rows of a pose that is near,
        they start alone: the surface goes on from there, by one round at least.
        """
        X = U[: self._n]
        moments = self.poisson.moments(X)
        R = nearest_rotations(U[self._frames].reshape(-1, 3, 3))
        if before is not None and len(self.turning):
            return self._from(self._brought(before, R), X, R, moments, max(level, 2))
        X = self.poisson.positions(X, R, moments)
        if level == 1 or len(self.turning) == 0:
            return RigidPose(X, R)
        ends = [self._last(X, R, moments, level)]
        ends += [self._from(rows, X, R, moments, level) for rows in others]
        return min(ends, key=lambda state: state.energy)

    def _from(
        self, rows: FloatArray, X: FloatArray, R: FloatArray, moments: FloatArray, level: int
    ) -> State:
        """The last state from `rows` where triangles are free to turn, from R elsewhere."""
        R = R.copy()
        R[self.turning] = rows[self.turning]
        return self._last(self.poisson.positions(X, R, moments), R, moments, level)

    def _brought(self, rows: FloatArray, R: FloatArray) -> FloatArray:
        """Rows of R' turned on by what the held ones have turned since, to those of R."""
        held = self.energy.held
        since = R[held].transpose(0, 2, 1) @ rows[held]
        turns = Rotation.from_matrix(since).as_rotvec().reshape(-1, 3)
        rows = rows.copy()
        rows[self.turning] = turned(rows[self.turning], self.energy.spread(turns))
        return rows

    def _last(self, X: FloatArray, R: FloatArray, moments: FloatArray, level: int) -> State:
        *_, last = islice(self.descend(X, R, moments), level)
        return last

    def descend(self, X: FloatArray, R: FloatArray, moments: FloatArray) -> Iterator[State]:
        """States of lower and lower energy (SmoothRotationEnergy), the first of them as given.

        Each round turns all triangles by one step downhill, and positions follow. They end where
        nothing is left to gain.
        """
        lbfgs = LBFGS(self.energy.hessian.solve)
        state: State | None = self._state(X, R)
        while state is not None:
            yield state
            state = self._round(state, lbfgs, moments)

    def _round(self, state: State, lbfgs: LBFGS, moments: FloatArray) -> State | None:
        """The state after one step downhill, None where there is none worth taking."""
        direction = lbfgs.direction(state.gradient)
        promise = -inner(direction, state.gradient)
        if promise <= STILL * state.energy + ROUNDING * len(direction):
            return None
        biggest = float((direction**2).sum(axis=1).max()) ** 0.5
        length = min(1.0, LARGEST_TURN / biggest)
        while length > SHORTEST:
            R = state.rotations.copy()
            R[self.turning] = turned(R[self.turning], length * direction)
            following = self._state(self.poisson.positions(state.positions, R, moments), R)
            if following.energy <= state.energy - SUFFICIENT * length * promise:
                lbfgs.learn(length * direction, following.gradient - state.gradient)
                return following
            length *= SHORTENING
        return None

    def _state(self, X: FloatArray, R: FloatArray) -> State:
        return State(X, R, *self.energy.measure(X, R))
