"""Rotations from coarse triangles to fine vertices: means, smoothed and interpolated."""

from __future__ import annotations

from functools import cached_property

import numpy as np
import scipy.sparse as sp
from scipy.spatial.transform import Rotation

from solver.coarse.carrier import Carrier
from solver.factor import Factor, factorize
from solver.geometry.cross_products import triangle_areas, vertex_areas
from solver.geometry.laplacian import cotangent_laplacian
from solver.geometry.rotations import nearest_rotations
from solver.types import FloatArray, IntArray

# Rotations are smoothed over this share of a coarse edge: more rounds off where handles begin.
SMOOTHED = 0.5


class VertexRotations:
    """Carries rotations of coarse triangles to fine vertices.

    Coarse vertices take the mean of their triangles, smoothed by one implicit step of diffusion
    over half an edge; between them quaternions are interpolated.
    """

    def __init__(self, carrier: Carrier) -> None:
        self._carrier = carrier

    @cached_property
    def _smoothing(self) -> tuple[FloatArray, Factor]:
        """Areas M (c,) around vertices and a factor of M + t L, t half a squared edge."""
        rest = self._carrier.coarse
        areas = triangle_areas(rest.points, rest.faces)
        area = vertex_areas(areas, rest.faces, len(rest.points))
        edges = rest.topology.edges
        squared = ((rest.points[edges[:, 1]] - rest.points[edges[:, 0]]) ** 2).sum(axis=1)
        area = area + 1e-9 * area.mean()
        L = cotangent_laplacian(rest.points, rest.faces)
        smooth = sp.diags_array(area) + 0.5 * SMOOTHED**2 * float(np.median(squared)) * L
        return area, factorize(sp.csr_array(smooth))

    def means(self, rows: FloatArray) -> FloatArray:
        """Rows (c, 3, 3) at coarse vertices, smoothed, from rows (k, 3, 3) of triangles' R'."""
        mean = self._carrier.vertex_frames(rows.reshape(-1, 3)).reshape(-1, 9)
        area, factor = self._smoothing
        return factor.solve(area[:, None] * mean).reshape(-1, 3, 3)

    def at(self, means: FloatArray, vertices: IntArray) -> FloatArray:
        """Rows (j, 3, 3) of R' at some fine vertices, from `means` at the coarse ones."""
        quaternions = Rotation.from_matrix(nearest_rotations(means)).as_quat()
        corners = self._carrier.corners[vertices]
        weights = self._carrier.barycentric[vertices]
        first, *others = (quaternions[corner] for corner in corners.T)
        q = weights[:, :1] * first
        for other, weight in zip(others, weights.T[1:], strict=True):
            sign = np.sign(np.einsum("ij,ij->i", first, other))  # q and -q are one rotation
            q += (weight * sign)[:, None] * other
        return _matrices(q)


def _matrices(q: FloatArray) -> FloatArray:
    """(j, 3, 3) rotations of quaternions (j, 4) of any length, the real part last."""
    x, y, z, w = q.T
    R = np.empty((len(q), 3, 3))
    s = 2.0 / np.maximum((q * q).sum(axis=1), np.finfo(float).tiny)
    for i, (a, b, c) in enumerate(((x, y, z), (y, z, x), (z, x, y))):
        j, k = (i + 1) % 3, (i + 2) % 3
        R[:, i, i] = 1.0 - s * (b * b + c * c)
        R[:, j, i] = s * (a * b + c * w)
        R[:, k, i] = s * (a * c - b * w)
    return R
