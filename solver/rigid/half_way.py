"""Half-way screw motions of handles: a large turn makes linear frames ambiguous, half does not."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike
from scipy.spatial.transform import Rotation

from solver.geometry.rotations import nearest_rotations
from solver.types import FloatArray

# In radians: up to here the linear frames are well conditioned.
LARGE_TURN = np.radians(120.0)
# From here on the way round is in doubt: the energy decides, so that it has no step at 180.
EITHER_WAY = np.radians(170.0)
# How far from orthonormal a rigid motion may be.
RIGID = 1e-6


def half_way(
    transforms: Sequence[ArrayLike], anchored: bool
) -> tuple[list[FloatArray], FloatArray]:
    """Motions H, (h, 4, 4) each, and M, (4, 4), with M H H = T for each of the transforms T.

    H turns by half the angle about the same axis: half of a screw motion. M is the identity if
    something is fixed (anchored), else the first T: so one motion of everything changes M alone.
    No H unless all T are rigid and some T turns by more than LARGE_TURN against M. A second one
    where turns come close to 180 degrees: these the other way round.
    """
    T = np.array(transforms, dtype=np.float64).reshape(-1, 4, 4)
    if len(T) == 0 or not _rigid(T[:, :3, :3]):
        return [], np.eye(4)
    M = np.eye(4) if anchored else T[0]
    screws = np.linalg.solve(M, T)
    turns = Rotation.from_matrix(screws[:, :3, :3]).as_rotvec()
    angles = np.linalg.norm(turns, axis=1, keepdims=True)
    halves = []
    if angles.max() > LARGE_TURN:
        halves.append(_half(screws, turns))
    if angles.max() > EITHER_WAY:
        back = 1.0 - 2.0 * np.pi / np.maximum(angles, EITHER_WAY)
        halves.append(_half(screws, np.where(angles > EITHER_WAY, back, 1.0) * turns))
    return halves, M


def _half(screws: FloatArray, turns: FloatArray) -> FloatArray:
    H = np.tile(np.eye(4), (len(screws), 1, 1))
    H[:, :3, :3] = R = Rotation.from_rotvec(0.5 * turns).as_matrix()
    H[:, :3, 3:] = np.linalg.solve(R + np.eye(3), screws[:, :3, 3:])
    return H


def squared(G: FloatArray, M: FloatArray) -> FloatArray:
    """Rows (m, 3, 3) of each (M R R)', with R the rotations nearest to the frames G (m, 3, 3)."""
    rows = nearest_rotations(G).transpose(0, 2, 1)
    squares: FloatArray = rows @ rows @ M[:3, :3].T
    return squares


def _rigid(A: FloatArray) -> bool:
    skewed = np.abs(A @ A.transpose(0, 2, 1) - np.eye(3)).max()
    return bool(skewed <= RIGID and (np.linalg.det(A) > 0).all())
