"""Where the handles of a bind go by themselves: the least energy tells."""

from __future__ import annotations

from collections.abc import Collection

import numpy as np

from app.model.handles import Pose
from app.worker.requests import Bound, PoseError
from solver.types import FloatArray


def oriented(
    bound: Bound, key: int, grabbed: FloatArray, target: FloatArray, transforms: FloatArray
) -> FloatArray:
    """The best rigid transform (4, 4) of a handle that takes rest point `grabbed` to `target`.

    transforms: (h, 4, 4) of all handles. Raises SolverError.
    """
    number = bound.request.keys.index(key)
    transform = bound.model.orient(number, grabbed, target, transforms)
    if not np.isfinite(transform).all():
        raise PoseError("the solver returned a rotation that is not finite; drag ended")
    return transform


def placed(bound: Bound, pose: Pose, keys: Collection[int]) -> Pose:
    """The pose with some handles shifted to where they cost the least energy, as turned.

    Those that the bind does not know stay. Raises SolverError.
    """
    known = bound.request.keys
    numbers = [number for number, key in enumerate(known) if key in keys]
    if not numbers:
        return pose
    transforms = bound.model.place(numbers, pose.stacked(known))
    if not np.isfinite(transforms).all():
        raise PoseError("the solver returned a place that is not finite; turning ended")
    for number in numbers:
        pose = pose.moved(known[number], transforms[number])
    return pose
