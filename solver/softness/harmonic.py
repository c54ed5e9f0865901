"""Smooth softness from a few values: the harmonic field between them."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from solver.arrays import as_floats, as_indices, as_surface, check_unit_interval
from solver.errors import MaterialError
from solver.factor import factorize
from solver.geometry.laplacian import cotangent_laplacian
from solver.geometry.topology import Topology
from solver.geometry.welding import welded_surface
from solver.types import FloatArray


def interpolate_softness(
    V: ArrayLike, F: ArrayLike, indices: ArrayLike, values: ArrayLike
) -> FloatArray:
    """Harmonic softness, (n,): argmin of the Dirichlet energy 1/2 s' L s with s[indices] = values.

    L is the cotangent Laplacian with weights clamped to positive values, so that the maximum
    principle holds: the result lies between the smallest and the largest value given. A
    component with no value is rigid (0). Seams are welded. values: (k,) in [0, 1].
    Raises MeshError, ConstraintError (indices) or MaterialError (values).

    >>> import solver
    >>> V = [[0, 0, 0], [1, 0, 0], [2, 0, 0], [0, 1, 0], [1, 1, 0], [2, 1, 0]]
    >>> quads = solver.Mesh.from_arrays(V, [[0, 1, 4, 3], [1, 2, 5, 4]])
    >>> s = solver.interpolate_softness(V, quads.faces, [0, 3, 2, 5], [0, 0, 1, 1])
    >>> s.round(3)  # half-way between the rigid and the soft end
    array([0. , 0.5, 1. , 0. , 0.5, 1. ])
    """
    V, F = as_surface(V, F)
    painted = as_indices(indices, len(V), "indices")
    values = as_floats(values, "values", MaterialError)
    if values.shape != painted.shape:
        raise MaterialError(
            f"values must be {painted.shape}, one for each index, got {values.shape}"
        )
    if len(np.unique(painted)) != len(painted):
        raise MaterialError("indices name a vertex twice, expected one value for each")
    check_unit_interval(values, "values", MaterialError)
    P, faces, welded = welded_surface(V, F)
    given = welded[painted]
    copies = np.bincount(given, minlength=len(P))
    known = np.flatnonzero(copies)
    softness = np.zeros(len(P))
    softness[known] = (np.bincount(given, values, len(P)) / np.maximum(copies, 1))[known]
    component = Topology(faces, len(P)).vertex_component
    free = np.isin(component, component[known])
    free[known] = False
    L = cotangent_laplacian(P, faces)[np.flatnonzero(free)]
    if free.any():
        softness[free] = factorize(L[:, np.flatnonzero(free)]).solve(-(L @ softness)[:, None])[:, 0]
    # Rounding may pass the bounds by a unit in the last place; painting code relies on them.
    everywhere = np.clip(softness, values.min(initial=0.0), values.max(initial=0.0))[welded]
    everywhere[painted] = values
    return everywhere
