"""Kept poses: by name, and what lies between two of them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

import numpy as np

from app.model.handles import Pose
from solver.geometry.motions import ORIGIN
from solver.geometry.screws import blended
from solver.geometry.turns import WHOLE
from solver.types import FloatArray

# The rest shape is a place to go to, too; it is nobody's to rename or delete.
REST, FIRST_POSE = 0, 1
FAR = 0.5 * WHOLE * (1.0 + 1e-9)  # a turn that is longer says more than the transform does
REST_NAME = "rest"


@dataclass(frozen=True)
class KeptPose:
    """A pose with a name. `key`, FIRST_POSE or more, stays as long as the mesh."""

    key: int
    name: str
    pose: Pose


def blended_pose(start: Pose, end: Pose, share: float, centres: Mapping[int, FloatArray]) -> Pose:
    """The pose that much of the way from one to another; at 0 and 1 these themselves.

    A handle that either has turned by more than half a turn goes by its turns, another one the
    shorter way round.
    centres: for the key of a handle its middle at rest, (3,): that moves on a screw.
    """
    if share in (0.0, 1.0):
        return start if share == 0.0 else end
    pose = Pose()
    for key in {**start.transforms, **end.transforms}:
        a, b = start.turn(key), end.turn(key)
        far = max(np.linalg.norm(a), np.linalg.norm(b)) > FAR
        centre, way = centres.get(key, ORIGIN), b - a if far else None
        T = blended(start.of(key), end.of(key), share, centre, way)
        pose = pose.moved(key, T, (1.0 - share) * a + share * b)
    return pose


def without_handle(poses: Iterable[KeptPose], key: int) -> tuple[KeptPose, ...]:
    """Kept poses that say nothing of a handle any more."""
    return tuple(KeptPose(kept.key, kept.name, kept.pose.without(key)) for kept in poses)
