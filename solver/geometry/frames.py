"""Orthonormal frames of triangles: how each one stands in space.

An orthonormal frame belongs to a triangle alone. What the energy calls its frame, G, is the linear
map from rest to deformed that the solver finds: not orthonormal, and the identity at rest.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from solver.geometry.cross_products import cross
from solver.types import BoolArray, FloatArray

# Below this share of its scaled edges' square a triangle has no area.
_FLAT = 1e-12
# Triangles that are worked on at a time: their arrays stay in a processor's cache.
_PORTION = 1 << 13


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
    axes, size, double = np.empty((len(P), 3, 3)), np.empty(len(P)), np.empty(len(P))
    for start in range(0, len(P), _PORTION):
        part = slice(start, start + _PORTION)
        axes[part], size[part], double[part] = _scaled_frames(P[part])
    areas = double * (size / max(size.max(), np.finfo(float).tiny)) ** 2
    return TriangleFrames(axes, areas, double <= _FLAT)


def _scaled_frames(P: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Axes, a size of each triangle, and twice the area that it has where this size is one."""
    # Coordinates in rows of their own: arithmetic on columns of three takes twice as long.
    a, b, c = np.ascontiguousarray(P.transpose(1, 2, 0))
    edge, other = b - a, c - a
    # Squares of very large or small edges leave the range of float64, so each triangle is scaled.
    size = np.maximum(np.abs(edge), np.abs(other)).max(axis=0)
    scale = np.where(size > 0, size, 1)
    edge, other = edge / scale, other / scale
    first, normal = unit(edge.T).T, cross(edge, other)
    double = np.sqrt((normal * normal).sum(axis=0))
    flat = double <= _FLAT
    normal /= np.where(flat, 1.0, double)
    lines = first[:, flat].T
    normal[:, flat] = unit(np.cross(lines, np.eye(3)[np.abs(lines).argmin(axis=1)])).T
    axes = np.stack([first, cross(normal, first), normal])
    return axes.transpose(2, 1, 0), size, double


def unit(vectors: FloatArray) -> FloatArray:
    """(k, 3) vectors at length 1; a zero vector becomes the first axis, so that all are finite."""
    norm = np.linalg.norm(vectors, axis=1)
    zero = norm == 0
    result: FloatArray = vectors / np.where(zero, 1.0, norm)[:, None]
    result[zero] = [1.0, 0.0, 0.0]
    return result
