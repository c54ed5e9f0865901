"""A drag without a solve: poses from the basis, for a process that never factorises."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from solver.arrays import as_floats
from solver.errors import ConstraintError
from solver.linear.best_place import best_shifts
from solver.linear.best_rotation import NEGLIGIBLE, best_rotation
from solver.linear.reach import check_map, check_points, shift_of
from solver.types import FloatArray, IntArray

# One (4, 4) for each handle: a list, or an array (h, 4, 4).
Transforms = Sequence[ArrayLike] | FloatArray
LAST_ROW = np.array([0.0, 0.0, 0.0, 1.0])
# Vertices that move often stand together in the file. A slice of them, with some that do not move,
# is about eight times faster to write to than an index of each.
SPAN = 8


@dataclass(frozen=True, eq=False)
class DragModel:
    """A bound surface as its handles see it: X(T) = X_rest + B (T - I).

    It holds no factor and no connectivity: small, picklable, and enough for a process that draws
    while another one solves. `Deformer.drag_model` makes it.

    vertices: (n, 3) rest positions.  centre, scale: of the normalised units (see RestSurface).
    moving: (k,) the vertices that any handle can move, or a slice with all of them.
    basis: (k, 4h) B at those vertices. A row of zeros leaves its vertex alone to the last bit.
        In float64: float32 was measured to save nothing, the result being float64 anyway.
    form: Q, (4h, 4h), E(T) = 1/2 tr (T - I)' Q (T - I).
    stiffness: the unit in which an energy counts as zero.
    """

    vertices: FloatArray
    centre: FloatArray
    scale: float
    moving: IntArray | slice
    basis: FloatArray
    form: FloatArray
    stiffness: float

    @staticmethod
    def of(
        vertices: FloatArray,
        centre: FloatArray,
        scale: float,
        basis: FloatArray,
        form: FloatArray,
        stiffness: float,
    ) -> DragModel:
        """From the basis (n, 4h) at all vertices; only the rows of those that move are kept."""
        some = np.flatnonzero(basis.any(axis=1))
        first, end = (int(some[0]), int(some[-1]) + 1) if len(some) else (0, 0)
        moving = slice(first, end) if end - first <= SPAN * len(some) else some
        return DragModel(vertices, centre, scale, moving, basis[moving].copy(), form, stiffness)

    @property
    def handle_count(self) -> int:
        """The number of transforms that `pose` expects."""
        return len(self.form) // 4

    def pose(self, transforms: Transforms) -> FloatArray:
        """X, (n, 3), for one transform (4, 4) a handle. Raises ConstraintError."""
        return self._displaced(self.vertices, self.steps(transforms))

    def carry(self, X: FloatArray, before: Transforms, after: Transforms) -> FloatArray:
        """X + B (T_after - T_before): a surface (n, 3) made for other transforms, brought along.

        Handles arrive exactly where `after` puts them if X has them where `before` does.
        Raises ConstraintError.
        """
        return self._displaced(X, self.steps(after) - self.steps(before))

    def orient(
        self,
        handle: int,
        grabbed: ArrayLike,
        target: ArrayLike,
        transforms: Transforms,
    ) -> FloatArray:
        """T, (4, 4), of least energy that takes rest point `grabbed` to `target`.

        See Deformer.orient. Raises ConstraintError.
        """
        if not 0 <= handle < self.handle_count:
            raise ConstraintError(f"handle must be 0 to {self.handle_count - 1}, got {handle}")
        steps = self.steps(transforms)
        p, q = (
            _as_point(point, what, self.centre, self.scale)
            for point, what in ((grabbed, "grabbed"), (target, "target"))
        )
        R = best_rotation(
            self.form,
            handle,
            (p - self.centre) / self.scale,
            (q - p) / self.scale,
            steps,
            np.asarray(transforms[handle], dtype=np.float64)[:3, :3],
            self.stiffness,
        )
        T = np.eye(4)
        T[:3, :3] = R
        T[:3, 3] = q - R @ p
        return T

    def place(self, handles: Sequence[int], transforms: Transforms) -> FloatArray:
        """(h, 4, 4): every transform, some handles shifted to where they cost the least energy.

        What a handle that is turned does if nothing says where it is to be; it keeps its rotation.
        Raises ConstraintError.
        """
        if not all(0 <= handle < self.handle_count for handle in handles):
            raise ConstraintError(f"handles must be 0 to {self.handle_count - 1}, got {handles}")
        steps = self.steps(transforms)
        placed = np.array(transforms, dtype=np.float64)
        shifts = best_shifts(self.form, handles, steps, self.stiffness)
        placed[list(handles), :3, 3] += self.scale * shifts
        return placed

    def is_loose(self, handle: int) -> bool:
        """Whether a handle moves alone at no cost: nothing else holds what it is part of."""
        own = slice(4 * handle, 4 * handle + 4)
        return bool(np.abs(self.form[own, own]).max() <= NEGLIGIBLE * self.stiffness)

    def steps(self, transforms: Transforms) -> FloatArray:
        """(4h, 3): T - I of every handle, stacked, in normalised units. Raises ConstraintError."""
        if len(transforms) != self.handle_count:
            raise ConstraintError(
                f"expected {self.handle_count} transforms, one for each handle, "
                f"got {len(transforms)}"
            )
        steps = np.zeros((4 * len(transforms), 3))
        for number, transform in enumerate(transforms):
            T = as_floats(transform, f"transform {number}", ConstraintError)
            if T.shape != (4, 4) or (np.abs(T[3] - LAST_ROW) > 1e-9).any():
                raise ConstraintError(
                    f"transform {number} must be (4, 4) with last row 0 0 0 1, got {T.tolist()}"
                )
            A = T[:3, :3]
            own = steps[4 * number : 4 * number + 4]
            own[:3] = A.T - np.eye(3)
            own[3] = shift_of(T, self.centre, self.scale)
            check_map(A, own[3], f"transform {number}")
        return steps

    def _displaced(self, X: FloatArray, steps: FloatArray) -> FloatArray:
        # The units go into the small factor, so that only one large array is made.
        push = self.basis @ (self.scale * steps)
        X = X.copy()
        X[self.moving] += push
        return X


def _as_point(point: ArrayLike, what: str, centre: FloatArray, scale: float) -> FloatArray:
    array = as_floats(point, what, ConstraintError)
    if array.shape != (3,):
        raise ConstraintError(f"{what} must be (3,), got {array.shape}")
    check_points(array, centre, scale, what)
    return array
