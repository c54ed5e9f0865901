"""Poses to learn from: checked, and brought to the size and place of the rest shape."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from solver.arrays import as_floats
from solver.errors import MeshError
from solver.geometry.bounding_box import diagonal
from solver.geometry.motions import moved
from solver.geometry.procrustes import rigid_motion
from solver.types import FloatArray, IntArray

# A pose that differs from rest by less than this share of the diagonal, rms, tells nothing.
LEAST_MOTION = 1e-4


def as_poses(poses: Sequence[ArrayLike], V: FloatArray) -> list[FloatArray]:
    """Poses of the mesh V (n, 3), (n, 3) each. Raises MeshError, naming the pose."""
    given = [as_floats(X, f"pose {number}", MeshError) for number, X in enumerate(poses)]
    if not given:
        raise MeshError("no poses to learn from, expected one or more")
    for number, X in enumerate(given):
        if X.shape != V.shape:
            raise MeshError(
                f"pose {number} must be {V.shape}, positions of the same vertices, got {X.shape}"
            )
        if diagonal(X) == 0:
            raise MeshError(f"pose {number} has no size, expected a shape of the mesh")
    return given


def resized(X: FloatArray, V: FloatArray, edges: IntArray) -> FloatArray:
    """The pose X (n, 3) at the size of V: the median edge (e, 2) keeps its length.

    Bending moves vertices together and apart, but leaves most edges as long as they were.
    """
    before, after = (np.linalg.norm(P[edges[:, 1]] - P[edges[:, 0]], axis=1) for P in (V, X))
    kept = (before > 0) & (after > 0)
    if not kept.any():
        return X
    return np.asarray(X * np.median(before[kept] / after[kept]))


def placed(X: FloatArray, V: FloatArray, still: IntArray) -> FloatArray:
    """The pose X (n, 3) moved rigidly so that its vertices `still` (k,) fit those of V best."""
    return moved(rigid_motion(X[still], V[still]), X)


def check_motion(poses: Sequence[FloatArray], V: FloatArray) -> None:
    """MeshError naming the first pose, (n, 3) each and placed, in which nothing moves."""
    for number, X in enumerate(poses):
        away = np.sqrt(((X - V) ** 2).sum(axis=1).mean())
        if away <= LEAST_MOTION * diagonal(V):
            raise MeshError(f"pose {number} shows no motion, expected a shape other than at rest")
