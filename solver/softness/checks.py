"""What can go wrong with a softness field, and how to make it smoother."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import scipy.sparse as sp
from numpy.typing import ArrayLike

from solver.arrays import as_floats, as_surface
from solver.errors import MaterialError
from solver.factor import factorize
from solver.geometry.laplacian import cotangent_laplacian
from solver.geometry.welding import welded_surface
from solver.softness.material import Material, resolve_material
from solver.types import FloatArray, IntArray

# Measured on a forearm (10k-vertex figure, elbow folded by 100 degrees, rigid 1), over materials
# that let the surface stretch and bands that end within some edges. The kink at the rim (the bends
# of neighbouring vertices compared) is, against a band that ends within 8 edges, 1.1 to 1.8 times
# as large where softness jumps by 0.33 along one edge, 1.2 to 2.3 times at 0.44, 1.6 to 3 times at
# 0.64 and 3 to 6 times at a step.
STEEPEST = 0.45
# The same fold with a gradual band: no triangle loses nine tenths of its area where the softest
# edge keeps a stretching gain of 0.1, the first does at 0.05, ten do at 0.03. The bending gain
# alone (0.01 to 100) collapses none.
WEAKEST = 0.07
# Two implicit steps of this size spread a step over about six edges, whatever their length.
STEPS, STEP = 2, 1.3
# Smoothing reaches everywhere a little: a rigid vertex that would become softer than this stays.
LEAST = 1e-3


@dataclass(frozen=True)
class SoftnessCheck:
    """jump: the largest difference of softness along an edge.  stretching: the least gain.

    steep_at, weak_at: the vertices of the edges where either goes too far.
    """

    jump: float
    stretching: float
    steep_at: IntArray
    weak_at: IntArray

    @property
    def steep(self) -> bool:
        """A region ends within fewer edges than the mesh needs to show it: a crease."""
        return self.jump > STEEPEST

    @property
    def weak(self) -> bool:
        """Triangles give way to a fold by losing their area."""
        return self.stretching < WEAKEST


def check_softness(
    edges: IntArray, softness: FloatArray, material: str | Material
) -> SoftnessCheck:
    """Check softness (n,) over the edges (e, 2) of a mesh. Raises MaterialError (material)."""
    gain = resolve_material(material).stretching
    ends = softness[edges]
    jumps, gains = np.abs(ends[:, 0] - ends[:, 1]), gain ** ends.mean(axis=1)
    steep, weak = (np.unique(edges[bad]) for bad in (jumps > STEEPEST, gains < WEAKEST))
    jump, least = float(jumps.max(initial=0.0)), float(gains.min(initial=1.0))
    return SoftnessCheck(jump, least, steep, weak)


def smooth_softness(V: ArrayLike, F: ArrayLike, softness: ArrayLike) -> FloatArray:
    """A smoother field, (n,): STEPS implicit steps (I + c L) s' = s with the cotangent Laplacian.

    Each lowers the Dirichlet energy and stays between the smallest and the largest value of s.
    All vertices count the same, so that it reaches as many edges in a fine part as in a coarse
    one. Seams are welded. Vertices of softness 0 that would get almost none keep 0.
    Raises MeshError, or MaterialError unless softness is (n,) in [0, 1].
    """
    V, F = as_surface(V, F)
    before = as_floats(softness, "softness", MaterialError)
    if before.shape != (len(V),):
        raise MaterialError(f"softness must be ({len(V)},), got {before.shape}")
    if not ((before >= 0) & (before <= 1)).all():
        raise MaterialError(
            f"softness must lie in [0, 1], got {before.min():g} to {before.max():g}"
        )
    P, faces, welded = welded_surface(V, F)
    count = np.bincount(welded)
    system = factorize(sp.csr_array(sp.eye_array(len(P)) + STEP * cotangent_laplacian(P, faces)))
    after = (np.bincount(welded, before) / count)[:, None]
    for _ in range(STEPS):
        after = system.solve(after)
    # Rounding may pass the bounds by a unit in the last place.
    smooth = np.clip(after[welded, 0], before.min(initial=1.0), before.max(initial=0.0))
    return np.where((before == 0) & (smooth < LEAST), 0.0, smooth)
