"""Soft handles: grab anywhere, on the factorisation that is already there."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from solver.arrays import as_floats
from solver.errors import ConstraintError
from solver.linear.constraints import Constraints
from solver.linear.rest_surface import RestSurface
from solver.linear.system import System
from solver.types import FloatArray, IntArray

# A region thinner than this share of its extent has no say on the direction it is thin in.
THIN = 1e-3
# Smaller shares of the largest weight are none: their moments would be rounding.
LEAST = 1e-12


class Moments:
    """Linear conditions C'X = wanted on the unknowns of a factorised system A.

    The multipliers follow from S = C'Y with Y = A^-1 C: what is minimal stays minimal under them.
    """

    def __init__(self, C: FloatArray, Y: FloatArray) -> None:
        self.C = C
        self.Y = Y
        self.inverse = np.linalg.pinv(C.T @ Y, hermitian=True)

    def of(self, X: FloatArray) -> FloatArray:
        """C'X, the moments of X (unknowns, k)."""
        return self.C.T @ X

    def meet(self, X: FloatArray, wanted: FloatArray) -> FloatArray:
        """X with the least energy added that gives it the moments `wanted`."""
        return X + self.Y @ (self.inverse @ (wanted - self.of(X)))


@dataclass(frozen=True)
class Grab:
    """One grab: the weighted best affine fit of a region is asked to equal T.

    weights: (n,) as given.
    moments: C, (free rows, 4), with C'U = C'J T asked of the free rows.
    influence: Y = A^-1 C, (free rows, 4).
    carried: rows of components that nothing else holds; they follow T rigidly.
    """

    weights: FloatArray
    moments: FloatArray
    influence: FloatArray
    carried: IntArray


def make_grab(
    rest: RestSurface,
    constraints: Constraints,
    system: System,
    weights: ArrayLike,
    lever: float,
    hanging: FloatArray | None = None,
) -> Grab:
    """A soft handle on the vertices where `weights` (n,) is positive: four back-substitutions.

    Weights on held vertices have no effect: those move with their handle. In directions in which
    the region is flat, thin or a single point its positions determine no affine map; there the
    mean of its frames is asked instead, with `lever` (normalised length) as their arm.
    hanging: E' diag(omega) J, (n + 3m, 4), where the region is one of a mesh that hangs on this
    surface by E: its moments are met in place of those of this surface's own vertices.
    Raises ConstraintError unless weights are (n,), non-negative, and positive on a free vertex.
    """
    n = len(rest.vertices)
    w = as_grab_weights(weights, n)
    body = constraints.row_body[:n]
    loose = np.unique(body[(w > 0) & ~constraints.held_bodies[body]])
    carried = np.flatnonzero(np.isin(constraints.row_body, loose))
    moments = _moments(rest, w, lever, hanging)[system.free]
    if not moments.any() and len(carried) == 0:
        raise ConstraintError("grab weights select no vertex that is free to move")
    return Grab(w, moments, system.factor.solve(moments), carried)


def as_grab_weights(weights: ArrayLike, vertex_count: int) -> FloatArray:
    """Weights as (n,) of at least 0; ConstraintError otherwise."""
    w = as_floats(weights, "grab weights", ConstraintError)
    if w.shape != (vertex_count,):
        raise ConstraintError(f"grab weights must be ({vertex_count},), got {w.shape}")
    if (w < 0).any():
        raise ConstraintError(f"grab weights must not be negative, got {w.min()}")
    return w


def relative(weights: FloatArray) -> FloatArray:
    """Weights (n,) as shares of the largest; zero where all are, and below LEAST."""
    shares = weights / max(weights.max(), np.finfo(float).tiny)
    return np.where(shares < LEAST, 0.0, shares)


def _moments(
    rest: RestSurface, weights: FloatArray, lever: float, hanging: FloatArray | None
) -> FloatArray:
    """C = diag(omega) J, with the frames' rows only where positions determine nothing."""
    n = len(weights)
    J = rest.affine_rows
    omega = relative(weights)
    C = np.zeros_like(J) if hanging is None else hanging.copy()
    if hanging is None:
        C[:n] = omega[:, None] * J[:n]
    normals = _undetermined_directions(rest.points, omega)
    frame_weight = np.repeat(lever**2 * omega[rest.faces].mean(axis=1), 3)
    C[n:, :3] += frame_weight[:, None] * (J[n:, :3] @ normals @ normals.T)
    return C


def _undetermined_directions(points: FloatArray, omega: FloatArray) -> FloatArray:
    """(3, r) the directions in which the weighted points do not extend."""
    centred = points - np.average(points, axis=0, weights=omega) if omega.any() else points
    spread, axes = np.linalg.eigh((centred * omega[:, None]).T @ centred)
    extent = max(spread[-1], np.finfo(float).tiny)
    return np.asarray(axes[:, spread <= THIN**2 * extent])
