"""Another rest shape than the file's, and what poses are with respect to it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from app.model.handles import Pose
from solver.geometry.procrustes import rigid_motion
from solver.types import FloatArray

# Of the largest singular value: below, points do not tell how they were stretched that way, and a
# map has none that leads back.
FLAT = 1e-6


@dataclass(frozen=True, eq=False)
class RestShape:
    """positions: (n, 3), read-only.  number: names it for the solver, as a mesh has a number."""

    positions: FloatArray
    number: int


def seen_from(pose: Pose, rest: Pose) -> Pose:
    """What leads where `pose` does from the shape that `rest` leads to: T R^-1 for each handle.

    Where both have a handle in one place that is the identity to the last bit.
    """
    seen = Pose()
    for key in {**rest.transforms, **pose.transforms}:
        turn = pose.turn(key) - rest.turn(key)
        seen = seen.moved(key, _quotient(pose.of(key), rest.of(key)), turn)
    return seen


def composed(pose: Pose, first: Mapping[int, FloatArray]) -> Pose:
    """What does to a handle its map (4, 4) of `first`, and then what `pose` does."""
    start, both = Pose(first), Pose()
    for key in {**first, **pose.transforms}:
        turn = start.turn(key) + pose.turn(key)
        both = both.moved(key, pose.of(key) @ start.of(key), turn)
    return both


def _quotient(T: FloatArray, R: FloatArray) -> FloatArray:
    if np.array_equal(T, R):
        return np.eye(4)
    quotient: FloatArray = T @ np.linalg.inv(R)
    quotient[3] = 0.0, 0.0, 0.0, 1.0  # to the last bit, as affine maps are written
    return quotient


def flattens(T: FloatArray) -> bool:
    """Whether nothing leads back from where T (4, 4) takes things."""
    sizes = np.linalg.svd(T[:3, :3], compute_uv=False)
    return not sizes[-1] > FLAT * sizes[0]


def affine_fit(rest: FloatArray, moved: FloatArray) -> FloatArray:
    """The affine map (4, 4) that best takes points (k, 3) to others; rigid as far as it is open."""
    T = rigid_motion(rest, moved)
    middle = rest.mean(axis=0)
    left = moved - (rest @ T[:3, :3].T + T[:3, 3])
    stretch = np.linalg.lstsq(rest - middle, left, rcond=FLAT)[0].T
    T[:3, :3] += stretch
    T[:3, 3] -= stretch @ middle
    return T
