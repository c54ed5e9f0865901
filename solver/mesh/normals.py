"""Normals of a mesh file, turned with the triangles that use them."""

from __future__ import annotations

import numpy as np

from solver.geometry.frames import triangle_frames
from solver.types import BoolArray, FloatArray, IntArray


def turn_normals(
    normals: FloatArray, users: IntArray, V: FloatArray, X: FloatArray, F: IntArray
) -> tuple[FloatArray, BoolArray]:
    """Normals (k, 3) after the surface (V, F) has become (X, F), and which of them turned, (k,).

    `users` (m, 3) is the normal at each triangle corner, -1 for none. Every corner turns its normal
    by the rotation of its triangle, from its orthonormal frame at rest to the deformed one; the
    result is the mean over corners, weighted by rest area, at the length of the original. Triangles
    without area, at rest or deformed, have no vote. Nothing turned where every vote is within 1e-9.
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
    rest, deformed = triangle_frames(V[F]), triangle_frames(X[F])
    both = ~(rest.degenerate | deformed.degenerate)
    size = np.linalg.norm(normals, axis=1)
    # NaN compares false: an unreadable normal takes no part.
    has_direction = np.append(size > 0, False)
    t, corner = np.nonzero(both[:, None] & has_direction[users])
    index = users[t, corner]
    before = normals[index] / size[index, None]
    local = np.einsum("icx,ic->ix", rest.axes[t], before)
    votes = np.einsum("icx,ix->ic", deformed.axes[t], local)
    moved = np.linalg.norm(votes - before, axis=1) > 1e-9
    return votes, rest.areas[t], index, moved.astype(np.float64)
