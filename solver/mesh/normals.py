"""Normals that turn with the surface they belong to."""

from __future__ import annotations

import numpy as np

from solver.types import BoolArray, FloatArray, IntArray


def turn_normals(
    normals: FloatArray, users: IntArray, V: FloatArray, X: FloatArray, F: IntArray
) -> tuple[FloatArray, BoolArray]:
    """Normals (k, 3) after the surface (V, F) has become (X, F), and which of them turned, (k,).

    `users` (m, 3) is the normal at each triangle corner, -1 for none. Every corner turns its normal
    by the rotation of its triangle, frame to frame (first edge and normal); the result is the mean
    over corners, weighted by rest area, at the length of the original. Triangles without area, at
    rest or deformed, have no frame and no vote. Nothing turned where every vote is within 1e-9.
    """
    votes, weights, index, moved = _votes(normals, users, V, X, F)
    k = len(normals)
    mean = np.stack([np.bincount(index, weights * votes[:, c], k) for c in range(3)], axis=1)
    length = np.linalg.norm(mean, axis=1)
    total = np.bincount(index, weights, k)
    # Opposite votes cancel: they have no mean direction, so the normal stays.
    turned = (np.bincount(index, moved, k) > 0) & (length > 1e-9 * total)
    size = np.linalg.norm(normals[turned], axis=1, keepdims=True)
    result = normals.copy()
    result[turned] = mean[turned] / length[turned, None] * size
    return result, turned


def _votes(
    normals: FloatArray, users: IntArray, V: FloatArray, X: FloatArray, F: IntArray
) -> tuple[FloatArray, FloatArray, IntArray, FloatArray]:
    """For every voting corner: turned unit normal, weight, index of the normal, 1 if it moved."""
    rest, area, whole = frames(V[F])
    deformed, _, whole_deformed = frames(X[F])
    size = np.linalg.norm(normals, axis=1)
    # NaN compares false: an unreadable normal takes no part.
    has_direction = np.append(size > 0, False)
    t, corner = np.nonzero((whole & whole_deformed)[:, None] & has_direction[users])
    index = users[t, corner]
    before = normals[index] / size[index, None]
    local = np.einsum("icx,ic->ix", rest[t], before)
    votes = np.einsum("icx,ix->ic", deformed[t], local)
    moved = np.linalg.norm(votes - before, axis=1) > 1e-9
    return votes, area[t], index, moved.astype(np.float64)


def frames(P: FloatArray) -> tuple[FloatArray, FloatArray, BoolArray]:
    """Local frames of triangles with corners P (m, 3, 3).

    Returns frames (m, 3, 3) with columns e1, e3 x e1, e3; areas (m,), relative to the largest
    triangle's size; and which triangles have an area, to rounding. The others' frames mean nothing.
    """
    edge, other = P[:, 1] - P[:, 0], P[:, 2] - P[:, 0]
    # Squares of very large or small edges leave the range of float64, so each triangle is scaled.
    size = np.maximum(np.abs(edge), np.abs(other)).max(axis=1)
    scale = np.where(size > 0, size, 1)[:, None]
    edge, other = edge / scale, other / scale
    cross = np.cross(edge, other)
    double = np.linalg.norm(cross, axis=1)
    whole = double > 1e-12
    e1 = edge / np.where(whole, np.linalg.norm(edge, axis=1), 1)[:, None]
    e3 = cross / np.where(whole, double, 1)[:, None]
    area = double * (size / max(size.max(), np.finfo(float).tiny)) ** 2
    return np.stack([e1, np.cross(e3, e1), e3], axis=2), area, whole
