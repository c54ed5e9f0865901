"""Orthonormal frames of triangles: how each one stands in space.

An orthonormal frame belongs to a triangle alone. What the energy calls its frame, G, is the linear
map from rest to deformed that the solver finds: not orthonormal, and the identity at rest.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from solver.types import BoolArray, FloatArray


@dataclass(frozen=True, eq=False)
class TriangleFrames:
    """Orthonormal frames of m triangles.

    axes: (m, 3, 3) with columns first edge, normal x first edge, normal.
    areas: (m,) up to a factor that all share, so that squares stay in the range of float64.
    degenerate: (m,) which triangles have no area, to rounding. Their axes are orthonormal too, but
    their normal is any direction across the first edge (across the first axis, if that is a point).
    """

    axes: FloatArray
    areas: FloatArray
    degenerate: BoolArray


def triangle_frames(P: FloatArray) -> TriangleFrames:
    """The frames of triangles with corners P (m, 3, 3), of any size and anywhere."""
    edge, other = P[:, 1] - P[:, 0], P[:, 2] - P[:, 0]
    # Squares of very large or small edges leave the range of float64, so each triangle is scaled.
    size = np.maximum(np.abs(edge), np.abs(other)).max(axis=1)
    scale = np.where(size > 0, size, 1)[:, None]
    edge, other = edge / scale, other / scale
    first, normal = unit(edge), np.cross(edge, other)
    double = np.linalg.norm(normal, axis=1)
    areas = double * (size / max(size.max(), np.finfo(float).tiny)) ** 2
    degenerate = double <= 1e-12
    normal /= np.where(degenerate, 1.0, double)[:, None]
    lines = first[degenerate]
    normal[degenerate] = unit(np.cross(lines, np.eye(3)[np.abs(lines).argmin(axis=1)]))
    axes = np.stack([first, np.cross(normal, first), normal], axis=2)
    return TriangleFrames(axes, areas, degenerate)


def unit(vectors: FloatArray) -> FloatArray:
    """(k, 3) vectors at length 1; a zero vector becomes the first axis, so that all are finite."""
    norm = np.linalg.norm(vectors, axis=1)
    zero = norm == 0
    result: FloatArray = vectors / np.where(zero, 1.0, norm)[:, None]
    result[zero] = [1.0, 0.0, 0.0]
    return result
