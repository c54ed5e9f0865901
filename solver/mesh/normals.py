"""Normals of a mesh file: turned with the triangles that use them, or made anew."""

from __future__ import annotations

import numpy as np
from scipy import sparse

from solver.geometry.cross_products import area_vectors
from solver.geometry.frames import triangle_frames
from solver.geometry.topology import Topology
from solver.geometry.welding import weld
from solver.types import BoolArray, FloatArray, IntArray

# A direction that changes by less than this is the same.
_SAME = 1e-9
# The cosine of 30 degrees: where the sides of a cut differ by more from their mean, it is an edge.
_SMOOTH = 0.866


def turn_normals(
    normals: FloatArray, users: IntArray, V: FloatArray, X: FloatArray, F: IntArray
) -> tuple[FloatArray, BoolArray]:
    """Normals (k, 3) after the surface (V, F) has become (X, F), and which of them turned, (k,).

    `users` (m, 3) is the normal at each triangle corner, -1 for none. Every corner turns its normal
    by the rotation of its triangle, from its orthonormal frame at rest to the deformed one; the
    result is the mean over corners, weighted by rest area, at the length of the original. Triangles
    without area, at rest or deformed, have no vote. Below 1e-9 a normal has not turned.
    """
    with np.errstate(over="ignore", invalid="ignore"):  # files hold any numbers
        size = np.linalg.norm(normals, axis=1, keepdims=True)
    # NaN compares false: an unreadable normal has no direction, and stays.
    known = (size > 0) & np.isfinite(size)
    before = np.divide(normals, size, out=np.zeros_like(normals), where=known)
    rotation, area = _mean_rotations(len(normals), users, V, X, F)
    mean = np.einsum("kij,kj->ki", rotation, before)
    length = np.linalg.norm(mean, axis=1, keepdims=True)
    # Opposite votes cancel: they have no mean direction, so the normal stays.
    decided = length > _SAME * area[:, None]
    after = np.divide(mean, length, out=before.copy(), where=decided)
    turned = np.linalg.norm(after - before, axis=1) > _SAME
    result = normals.copy()
    result[turned] = after[turned] * size[turned]
    return result, turned


def _mean_rotations(
    count: int, users: IntArray, V: FloatArray, X: FloatArray, F: IntArray
) -> tuple[FloatArray, FloatArray]:
    """(k, 3, 3) the rotations of the triangles at each normal, summed by area, and the areas."""
    rest, deformed = triangle_frames(V[F]), triangle_frames(X[F])
    rotations = deformed.axes @ rest.axes.transpose(0, 2, 1)
    areas = np.where(rest.degenerate | deformed.degenerate, 0.0, rest.areas)
    # Column by column the corners of a triangle.
    weights = np.where(users < 0, 0.0, areas[:, None]).ravel()
    starts = np.arange(0, users.size + 1, 3)
    votes = sparse.csc_array((weights, np.maximum(users, 0).ravel(), starts), (count, len(F)))
    total = np.asarray(votes @ np.ones(len(F)))
    return np.asarray(votes @ rotations.reshape(-1, 9)).reshape(-1, 3, 3), total


def smooth_normals(X: FloatArray, F: IntArray) -> FloatArray:
    """(n, 3) unit normals: the mean over triangles by area, the z axis where there is none.

    A seam that the surface passes smoothly has one normal for both sides.
    """
    P = X[F]
    scaled = X / max(float(np.abs(P).max()), np.finfo(float).tiny)
    areas = area_vectors(scaled, F).repeat(3, axis=0)
    own = _unit(_summed(areas, F.ravel(), len(X)))
    welded = weld(X, Topology(F, len(X)))
    both = _unit(_summed(areas, welded[F].ravel(), len(X)))[welded]
    smooth = (own * both).sum(axis=1, keepdims=True) >= _SMOOTH
    return np.where(smooth, both, own)


def _summed(vectors: FloatArray, at: IntArray, count: int) -> FloatArray:
    """(count, 3) sums of the vectors (k, 3) at each number (k,)."""
    return np.stack([np.bincount(at, part, count) for part in vectors.T], axis=1)


def _unit(vectors: FloatArray) -> FloatArray:
    length = np.linalg.norm(vectors, axis=1, keepdims=True)
    # In float32 a shorter sum is all rounding.
    return np.where(length > 1e-30, vectors / np.where(length > 0, length, 1), [0.0, 0.0, 1.0])
