"""Turns: rotation vectors, (3,) in radians, that say how often something went round as well.

A rotation is a point of SO(3); how it was reached is not. A turn t says both: exp([t]) is the
rotation, and t / |t| and |t| the axis and the angle that led there, which may be many whole turns.
"""

from __future__ import annotations

import numpy as np
from scipy.spatial.transform import Rotation

from solver.types import FloatArray

WHOLE = 2 * np.pi
MOST = 100 * WHOLE  # no turn is longer: more whole turns are not counted
STEP = WHOLE / 24  # on a way that is followed; after a long one the nearest turn may be another
NO_AXIS = 1e-6  # radians below which a rotation does not tell its axis


def nearest_turn(R: FloatArray, near: FloatArray) -> FloatArray:
    """argmin ||t - near|| over t with exp([t]) = R, a rotation (3, 3); t is no longer than MOST.

    From frame to frame of a motion, near the turn before, it is the turn so far.
    """
    return _nearest(Rotation.from_matrix(R).as_rotvec(), near)


def turned_by(turn: FloatArray, way: FloatArray) -> FloatArray:
    """The turn after one that was at `turn` has turned evenly by `way`, a turn as well (3,).

    turned_by(t, s t) = (1 + s) t, as long as that is no longer than MOST.
    """
    length = float(np.linalg.norm(way))
    if length > MOST:
        way = way * ((length - WHOLE * np.ceil((length - MOST) / WHOLE)) / length)
    count = max(int(np.ceil(np.linalg.norm(way) / STEP)), 1)
    steps = Rotation.from_rotvec(np.arange(1, count + 1)[:, None] / count * way)
    for rotvec in (steps * Rotation.from_rotvec(turn)).as_rotvec():
        turn = _nearest(rotvec, turn)
    return turn


def _nearest(rotvec: FloatArray, near: FloatArray) -> FloatArray:
    """rotvec: (3,) of at most half a turn."""
    angle = float(np.linalg.norm(rotvec))
    axis = rotvec / angle if angle > NO_AXIS else near / (float(np.linalg.norm(near)) or 1.0)
    most = MOST / WHOLE - 1.0
    whole = np.clip(np.rint((near - rotvec) @ axis / WHOLE), -most, most)
    found: FloatArray = rotvec + whole * WHOLE * axis
    return found
