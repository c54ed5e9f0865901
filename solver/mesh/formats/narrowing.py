"""Numbers in the type of a file, which may be narrower, and back."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import DTypeLike, NDArray

from solver.errors import MeshError
from solver.geometry.bounding_box import diagonal
from solver.types import FloatArray, IntArray

# Edges longer than this share of the diagonal must not vanish: shorter ones nobody sees.
SEEN = 1e-6


def widened(values: NDArray[Any]) -> FloatArray:
    """Numbers of a file as float64; one that is none of any kind stays so, without a warning."""
    with np.errstate(invalid="ignore"):
        return values.astype(np.float64)


def narrowed(values: FloatArray, kind: DTypeLike) -> NDArray[Any]:
    """Values in a float type. Raises MeshError where a finite one would become infinite."""
    with np.errstate(over="ignore", invalid="ignore"):
        data = values.astype(kind)
    if (np.isinf(data) & np.isfinite(values)).any():
        largest = np.nanmax(np.abs(values))
        raise MeshError(f"coordinates up to {largest:.3g} do not fit {np.dtype(kind).name}")
    return data


def check_distinct(X: FloatArray, stored: NDArray[Any], faces: IntArray, path: str) -> None:
    """Raises MeshError where vertices of one triangle become one, far from the origin.

    X: (n, 3) positions.  stored: (n, 3) the same as the file has them.  faces: (m, 3).
    """
    ends = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    same = ends[(stored[ends[:, 0]] == stored[ends[:, 1]]).all(axis=1)]
    length = np.linalg.norm(X[same[:, 0]] - X[same[:, 1]], axis=1)
    merged = np.unique(same[length > SEEN * diagonal(X[faces.ravel()])])
    if len(merged):
        raise MeshError(
            f"{path}: {len(merged)} vertices would become one with a neighbour in "
            f"{stored.dtype.name}, so far from the origin; expected a format of more digits "
            "(.obj, .off, .ply)"
        )
