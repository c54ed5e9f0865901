"""Cross products of many vectors at once, and the areas of triangles, which they give."""

from __future__ import annotations

import numpy as np

from solver.types import FloatArray, IntArray


def cross(u: FloatArray, v: FloatArray) -> FloatArray:
    """u x v for arrays (3, ...) along their first axis: up to four times as fast as np.cross."""
    return np.stack(
        [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
    )


def area_vectors(X: FloatArray, F: IntArray) -> FloatArray:
    """(m, 3): unit normal times area of each triangle of the surface (X, F)."""
    a, b, c = (X[corner] for corner in F.T)
    return 0.5 * cross((b - a).T, (c - a).T).T


def triangle_areas(X: FloatArray, F: IntArray) -> FloatArray:
    """(m,) the area of each triangle of the surface (X, F)."""
    return np.asarray(np.linalg.norm(area_vectors(X, F), axis=1))


def vertex_areas(areas: FloatArray, F: IntArray, vertex_count: int) -> FloatArray:
    """(n,) a third of the areas (m,) of the triangles F around each vertex."""
    thirds = np.repeat(areas / 3, 3)
    return np.bincount(F.ravel(), thirds, vertex_count).astype(np.float64)
