"""From linear frames to rotations and back to positions: the levels of `rigid`."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import islice

import numpy as np

from solver.factor import factorize
from solver.geometry.rotations import nearest_rotations, turned
from solver.linear.constraints import Constraints
from solver.linear.grab import Grab, Moments
from solver.linear.rest_surface import RestSurface
from solver.linear.system import System
from solver.rigid.lbfgs import LBFGS, inner
from solver.rigid.smooth_rotations import ROTATION_LENGTH, SmoothRotationEnergy
from solver.types import FloatArray

# No triangle turns by more than this in one round, in radians: small turns model the energy.
LARGEST_TURN = 1.0
# A step is taken when it lowers the energy by this share of what its slope promises.
SUFFICIENT = 1e-4
SHORTENING, SHORTEST = 0.4, 1e-3
# Rounds end when the next one promises less than this share of the energy, or less than what
# rounding leaves of it.
STILL, ROUNDING = 1e-9, 1e-15


@dataclass(frozen=True)
class State:
    """Positions X (n, 3) that suit rotations R (rows of R', as in U), their energy and gradient."""

    X: FloatArray
    R: FloatArray
    energy: float
    gradient: FloatArray


class Rigidity:
    """Positions from rotations, and rounds of both.

        argmin_X 1/2 sum w_eT sigma_e ||x_b - x_a - R_T (p_b - p_a)||^2

    with held vertices at their targets and the moments of soft handles met. Its matrix is the
    vertex block of K, its right-hand side the vertex-frame block: no second assembly.
    """

    def __init__(
        self,
        shape: RestSurface,
        constraints: Constraints,
        system: System,
        grabs: Sequence[Grab],
        bending_length: float,
        rotation_length: float = ROTATION_LENGTH,
    ) -> None:
        """bending_length: l, as it is in the system.  rotation_length: l_r; both in diagonals."""
        n = len(shape.vertices)
        self._n = n
        self._free = constraints.free[constraints.free < n]
        # Rotations are wanted where they matter: on triangles that something can strain.
        active = system.active
        self._frames = (n + 3 * active[:, None] + np.arange(3)).ravel()
        kept = np.concatenate([np.arange(n), self._frames])
        self._K = system.matrix()[kept][:, kept]
        self._rows = self._K[self._free]
        self._factor = factorize(self._rows[:, self._free])
        # Held, carried and resting frames are right already: a round leaves them alone.
        turning = constraints.free[constraints.free >= n]
        self._turning = np.searchsorted(active, (turning[::3] - n) // 3)
        self._ratio = (rotation_length / bending_length) ** 2
        C = np.hstack(
            [np.empty((len(self._free), 0)), *(g.moments[: len(self._free)] for g in grabs)]
        )
        self._moments = Moments(C, self._factor.solve(C))

    @cached_property
    def _shell(self) -> SmoothRotationEnergy:
        return SmoothRotationEnergy(self._K, self._n, self._turning, self._ratio)

    def refine(self, U: FloatArray, rounds: int, others: Sequence[FloatArray] = ()) -> FloatArray:
        """Rows U (n + 3m, 3) of the linear result become positions (n, 3).

        The first round takes the nearest rotation of every frame and solves for positions; for
        the others see `descend`. They start from each of `others`, rows of R' of active triangles,
        too, and the end of lowest energy counts.
        """
        moments = self._moments.of(U[self._free])
        R = nearest_rotations(U[self._frames].reshape(-1, 3, 3))
        X = self.positions(U[: self._n], R, moments)
        if rounds == 1 or len(self._turning) == 0:
            return X
        ends = [self._last(X, R, moments, rounds)]
        for rows in others:
            R = R.copy()
            R[self._turning] = rows[self._turning]
            ends.append(self._last(self.positions(X, R, moments), R, moments, rounds))
        return min(ends, key=lambda state: state.energy).X

    def _last(self, X: FloatArray, R: FloatArray, moments: FloatArray, rounds: int) -> State:
        *_, last = islice(self.descend(X, R, moments), rounds)
        return last

    def descend(self, X: FloatArray, R: FloatArray, moments: FloatArray) -> Iterator[State]:
        """States of lower and lower energy (see SmoothRotationEnergy), the first of them as given.

        Each round turns all triangles by one step downhill, and positions follow. They end where
        nothing is left to gain.
        """
        curvature = LBFGS(self._shell.hessian.solve)
        state: State | None = self._state(X, R)
        while state is not None:
            yield state
            state = self._round(state, curvature, moments)

    def _round(self, state: State, curvature: LBFGS, moments: FloatArray) -> State | None:
        """The state after one step downhill, None where there is none worth taking."""
        direction = curvature.direction(state.gradient)
        promise = -inner(direction, state.gradient)
        if promise <= STILL * state.energy + ROUNDING * len(direction):
            return None
        biggest = float((direction**2).sum(axis=1).max()) ** 0.5
        length = min(1.0, LARGEST_TURN / biggest)
        while length > SHORTEST:
            R = state.R.copy()
            R[self._turning] = turned(R[self._turning], length * direction)
            following = self._state(self.positions(state.X, R, moments), R)
            if following.energy <= state.energy - SUFFICIENT * length * promise:
                curvature.learn(length * direction, following.gradient - state.gradient)
                return following
            length *= SHORTENING
        return None

    def _state(self, X: FloatArray, R: FloatArray) -> State:
        return State(X, R, *self._shell.measure(X, R))

    def positions(self, X: FloatArray, R: FloatArray, moments: FloatArray) -> FloatArray:
        """X (n, 3) with its free vertices where they suit R, the rows of R' of active triangles."""
        X = X.copy()
        X[self._free] = 0.0
        rows = np.vstack([X, R.reshape(-1, 3)])
        X[self._free] = self._moments.meet(-self._factor.solve(self._rows @ rows), moments)
        return X
