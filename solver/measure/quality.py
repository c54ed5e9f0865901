"""What makes a deformed surface good: strain, bending, volume and broken triangles against rest."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from solver.geometry.cross_products import area_vectors
from solver.geometry.topology import Topology
from solver.measure.distortion import Distortion
from solver.measure.volume import volume
from solver.types import BoolArray, FloatArray, IntArray

# A triangle of less than this share of its rest area counts as collapsed.
COLLAPSED = 1e-3
# A surface counts as closed with fewer boundary edges than this share: pinholes hold no volume.
OPEN = 0.01


@dataclass(frozen=True)
class Quality:
    """strain: rms of l'/l - 1 over edges with a free vertex.  dihedral: rms of the change of
    dihedral angles there, radians.  volume: ratio to rest, NaN for an open surface.
    broken: triangles with a free vertex that are collapsed or turned against a neighbour.
    """

    strain: float
    dihedral: float
    volume: float
    broken: int


def quality(V: FloatArray, F: IntArray, free: BoolArray, X: FloatArray) -> Quality:
    """Of the pose X (n, 3) of (V, F); free: (n,) the vertices that are not constrained."""
    distortion = Distortion(V, F)
    closed = len(distortion.edges) - len(distortion.hinges) < OPEN * len(distortion.edges)
    return Quality(
        distortion.strain(X, free).rms,
        distortion.dihedral(X, free).rms,
        volume(X, F) / volume(V, F) if closed else np.nan,
        broken_triangles(V, F, free, X),
    )


def broken_triangles(V: FloatArray, F: IntArray, free: BoolArray, X: FloatArray) -> int:
    """Triangles that lost their area, or whose normal turned by more than 90 degrees against
    that of a neighbour more than it was turned at rest.
    """
    rest, now = area_vectors(V, F), area_vectors(X, F)
    broken = np.linalg.norm(now, axis=1) < COLLAPSED * np.linalg.norm(rest, axis=1)
    pairs = Topology(F, len(V)).pairs
    neighbours = np.column_stack([pairs.first, pairs.second])
    before, after = (
        np.einsum("ij,ij->i", normals[pairs.first], normals[pairs.second])
        for normals in (rest, now)
    )
    broken[neighbours[(before > 0) & (after < 0)].ravel()] = True
    return int((broken & free[F].any(axis=1)).sum())
