"""How far a surface may be taken: maps of handles and targets beyond sense are refused."""

from __future__ import annotations

import numpy as np

from solver.errors import ConstraintError
from solver.limits import FARTHEST, LARGEST_STRETCH
from solver.types import FloatArray


def shift_of(T: FloatArray, centre: FloatArray, scale: float) -> FloatArray:
    """(3,) how far the affine map T (4, 4) takes a centre (3,), in units of `scale`."""
    with np.errstate(over="ignore", invalid="ignore"):  # what overflows is refused by `check_map`
        return np.asarray((T[:3, :3] @ centre + T[:3, 3] - centre) / scale)


def check_map(linear: FloatArray, shift: FloatArray, what: str) -> None:
    """Raises ConstraintError naming `what` for a map that no pose of a surface needs.

    linear: (3, 3) of any kind: turning, stretching, shearing, mirroring, flattening.
    shift: (3,) how far the middle of the surface goes, in diagonals.
    """
    check_stretch(linear, what)
    far = np.abs(shift).max()
    if not far <= FARTHEST:
        raise ConstraintError(
            f"{what} must move the surface by at most {FARTHEST:g} of its diagonals, got {far:.3g}"
        )


def check_stretch(linear: FloatArray, what: str) -> None:
    """Raises ConstraintError naming `what` for a linear part (3, 3) with too large entries."""
    largest = np.abs(linear).max()
    if not largest <= LARGEST_STRETCH:
        raise ConstraintError(
            f"{what} must have a linear part of entries up to {LARGEST_STRETCH:g}, "
            f"got {largest:.3g}"
        )


def check_points(points: FloatArray, centre: FloatArray, scale: float, what: str) -> None:
    """Raises ConstraintError naming `what` for points (..., 3) too far from a surface.

    centre: (3,) its middle.  scale: its diagonal.
    """
    with np.errstate(over="ignore"):
        far = (np.abs(points - centre) / scale).max(initial=0.0)
    if not far <= FARTHEST:
        raise ConstraintError(
            f"{what} must lie within {FARTHEST:g} diagonals of the surface, got {far:.3g}"
        )
