"""The rotation or rigid motion that fits best: the orthogonal Procrustes problem. [Kabsch 1976]"""

from __future__ import annotations

import numpy as np

from solver.types import FloatArray

UNDECIDED = 1e-13  # of the size of M: a touch of identity decides what M does not


def procrustes(M: FloatArray) -> FloatArray:
    """R, (3, 3): argmax over rotations of tr(R M). [Kabsch 1976]"""
    S1, _, S2 = np.linalg.svd(M)
    flip = np.diag([1.0, 1.0, np.sign(np.linalg.det(S1) * np.linalg.det(S2))])
    R: FloatArray = S2.T @ flip @ S1.T
    return R


def rigid_motion(rest: FloatArray, moved: FloatArray) -> FloatArray:
    """argmin over rigid T, (4, 4), of sum ||T rest - moved||^2, for points (k, 3) each.

    The identity to the last bit where nothing has moved.
    """
    transform = np.eye(4)
    if np.array_equal(rest, moved):
        return transform
    transform[:3, :3] = R = rigid_fit(rest, moved)
    transform[:3, 3] = moved.mean(axis=0) - R @ rest.mean(axis=0)
    return transform


def rigid_fit(rest: FloatArray, target: FloatArray) -> FloatArray:
    """R, (3, 3): the rotation that best takes points `rest` (k, 3) to `target` (k, 3).

    Where the points leave it open (a single point, a line) the one that turns least is taken.
    """
    p, q = rest - rest.mean(axis=0), target - target.mean(axis=0)
    M = p.T @ q
    return decided(M)


def decided(M: FloatArray) -> FloatArray:
    """The same as `procrustes`; of rotations that M leaves open, the one that turns least."""
    return procrustes(M + UNDECIDED * (float(np.linalg.norm(M)) or 1.0) * np.eye(3))
