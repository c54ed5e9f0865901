"""Motions between two places: screws, which turn about a line and move along it at even speed."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike
from scipy.spatial.transform import Rotation

from solver.geometry.motions import ORIGIN, motion, moved
from solver.geometry.procrustes import decided
from solver.geometry.turns import WHOLE, nearest_turn
from solver.types import FloatArray

LONGEST = 0.75 * WHOLE  # radians that a screw turns: near a whole turn its line goes far away


def screw(D: FloatArray, share: float) -> FloatArray:
    """D to the power of `share`, (4, 4): that much of the screw motion from the identity to D.

    D: a rigid motion (4, 4). exp(share log D) in SE(3), by the shorter way round: powers of one D
    have one axis, and screw(D, s) screw(D, t) = screw(D, s + t). At 180 degrees the two ways are as
    short and one is taken. [Chasles 1830; Murray, Li & Sastry 1994]
    """
    return wound(D, share, Rotation.from_matrix(D[:3, :3]).as_rotvec(), ORIGIN)


def wound(D: FloatArray, share: float, turn: FloatArray, centre: ArrayLike) -> FloatArray:
    """As `screw`, but by the way round that a turn (3,) of D says, which may be a longer one.

    Up to LONGEST along the screw that turns so far. Beyond, where its line may be anywhere, the
    point `centre` (3,) goes the shorter way and the rest of the turn is about it.
    """
    angle = float(np.linalg.norm(turn))
    if angle <= LONGEST:
        along = np.linalg.solve(_travel(turn), D[:3, 3])
        turned = Rotation.from_rotvec(share * turn).as_matrix()
        return motion(turned, _travel(share * turn) @ (share * along))
    short = screw(D, share)
    rest = turn - Rotation.from_matrix(D[:3, :3]).as_rotvec()
    spin = Rotation.from_rotvec(share * rest).as_matrix()
    T: FloatArray = motion(spin, centre=moved(short, np.asarray(centre))) @ short
    return T


def blended(
    A: FloatArray,
    B: FloatArray,
    share: float,
    centre: ArrayLike = ORIGIN,
    turn: FloatArray | None = None,
) -> FloatArray:
    """The affine map (4, 4) that much of the way from A to B; A itself at 0 and B itself at 1.

    A = M S with a rigid M and a symmetric stretch S about the point `centre` (3,), by the polar
    decomposition, and B likewise: M goes along the screw from one to the other, S in a straight
    line. So `centre` moves on a screw, and neither a change of frame nor of what comes after A and
    B makes a difference. For rigid A and B the centre plays no part.
    turn: (3,) about the turn from A to B; without it the shorter way round. See `wound`.
    """
    if share == 0.0 or np.array_equal(A, B):
        return A
    if share == 1.0:
        return B
    middle = np.asarray(centre, dtype=np.float64)
    (M, S), (N, Q) = (_polar(T, middle) for T in (A, B))
    relative = N @ np.linalg.inv(M)
    way = nearest_turn(relative[:3, :3], np.zeros(3) if turn is None else turn)
    moving = wound(relative, share, way, moved(M, middle))
    T: FloatArray = moving @ M @ ((1.0 - share) * S + share * Q)
    T[3] = 0.0, 0.0, 0.0, 1.0  # to the last bit, as affine maps are written
    return T


def _polar(T: FloatArray, centre: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Rigid M and stretch S about `centre`, (4, 4) each, with T = M S."""
    A = T[:3, :3]
    R = decided(A.T)
    there = A @ centre + T[:3, 3]
    return motion(R, there - centre, centre), motion(R.T @ A, centre=centre)


def _travel(turn: FloatArray) -> FloatArray:
    """V, (3, 3): the mean of the rotations from none to `turn` (3,), a rotation vector.

    Who turns by `turn` and moves by u in his own frame meanwhile, both evenly, comes to V u.
    """
    x, y, z = turn
    cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    angle = float(np.linalg.norm(turn))
    unit = cross / (angle or 1.0)
    half = 0.5 * np.sinc(0.5 * angle / np.pi) ** 2
    V: FloatArray = np.eye(3) + half * cross + (1.0 - np.sinc(angle / np.pi)) * unit @ unit
    return V
