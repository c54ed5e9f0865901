"""Rotations about an axis and rigid motions, as 3 x 3 and 4 x 4 matrices."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from solver.types import FloatArray

ORIGIN = (0.0, 0.0, 0.0)
UPRIGHT = 1e-9  # cosine of y below which rounding would choose the other two Euler angles


def rotation(axis: ArrayLike, degrees: float) -> FloatArray:
    """R, (3, 3): right-handed about `axis` (3,), of any length but 0. [Rodrigues 1840]"""
    x, y, z = u = np.asarray(axis, dtype=np.float64) / np.linalg.norm(axis)
    cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    return c * np.eye(3) + s * cross + (1.0 - c) * np.outer(u, u)


def motion(R: FloatArray, shift: ArrayLike = ORIGIN, centre: ArrayLike = ORIGIN) -> FloatArray:
    """T, (4, 4): turned by R about the point `centre`, then moved by `shift`."""
    T = np.eye(4)
    T[:3, :3] = R
    T[:3, 3] = np.asarray(centre) - R @ np.asarray(centre) + np.asarray(shift)
    return T


def from_euler_angles(degrees: ArrayLike) -> FloatArray:
    """R, (3, 3): turned about the world's x, then y, then z, by degrees (3,)."""
    x, y, z = (
        rotation(axis, angle)
        for axis, angle in zip(np.eye(3), np.asarray(degrees, dtype=np.float64), strict=True)
    )
    return np.asarray(z @ y @ x)


def euler_angles(R: FloatArray) -> FloatArray:
    """(3,) degrees about x, y and z: what from_euler_angles makes R (3, 3) of.

    y lies in [-90, 90]. At its ends x and z turn about the same axis; z is 0 there.
    """
    level = float(np.hypot(R[0, 0], R[1, 0]))
    y = np.arctan2(-R[2, 0], level)
    if level > UPRIGHT:
        x, z = np.arctan2(R[2, 1], R[2, 2]), np.arctan2(R[1, 0], R[0, 0])
    else:
        x, z = np.arctan2(-R[1, 2], R[1, 1]), 0.0
    return np.degrees([x, y, z])


def rotation_about(axis: ArrayLike, degrees: float, centre: ArrayLike = ORIGIN) -> FloatArray:
    """T, (4, 4): the rotation about the line along `axis` through `centre`."""
    return motion(rotation(axis, degrees), centre=centre)


def moved(T: FloatArray, points: FloatArray) -> FloatArray:
    """Points (k, 3) where the affine map T (4, 4) takes them."""
    return np.asarray(points @ T[:3, :3].T + T[:3, 3])


def moved_back(T: FloatArray, points: FloatArray) -> FloatArray:
    """Points (..., 3) that the affine map T (4, 4) takes there; the least where T flattens."""
    return np.asarray((points - T[:3, 3]) @ np.linalg.pinv(T[:3, :3]).T)
