"""Checks at the boundary: what a caller passes becomes clean arrays, or one clear error."""

from __future__ import annotations

from typing import TypeVar

import numpy as np
from numpy.typing import ArrayLike

from solver.errors import ConstraintError, MeshError, SolverError
from solver.limits import LARGEST_COORDINATE, SMALLEST_SIZE
from solver.types import FloatArray, IntArray

Array = TypeVar("Array", FloatArray, IntArray)


def as_surface(V: ArrayLike, F: ArrayLike) -> tuple[FloatArray, IntArray]:
    """`as_vertices` and `as_faces`, and MeshError for a surface too small for the arithmetic.

    One that is collapsed into a point passes: nothing is to be told apart there.
    """
    vertices = as_vertices(V)
    faces = as_faces(F, len(vertices))
    size = extent(vertices, faces)
    if 0 < size < SMALLEST_SIZE:
        raise MeshError(f"the surface must be {SMALLEST_SIZE:.0e} large or more, got {size:.3g}")
    return vertices, faces


def extent(V: FloatArray, F: IntArray) -> float:
    """The longest side of the box around the vertices F, any shape, of V (n, 3)."""
    return float(np.ptp(V[F.ravel()], axis=0).max())


def as_vertices(V: ArrayLike) -> FloatArray:
    """Positions as (n, 3) float64 of a usable size; MeshError otherwise."""
    V = as_floats(V, "vertices", MeshError)
    if V.ndim != 2 or V.shape[1] != 3 or len(V) == 0:
        raise MeshError(f"vertices must be (n, 3) with n > 0, got {V.shape}")
    check_coordinates(V, "vertices")
    return V


def check_coordinates(V: FloatArray, what: str) -> None:
    """MeshError naming `what` unless the arithmetic holds all coordinates of V (n, 3)."""
    if not np.abs(V).max(initial=0.0) <= LARGEST_COORDINATE:
        at = int(np.flatnonzero(~(np.abs(V) <= LARGEST_COORDINATE).all(axis=1))[0])
        raise MeshError(
            f"{what} must have coordinates up to {LARGEST_COORDINATE:.0e}, "
            f"got {V[at].tolist()} at vertex {at}"
        )


def as_faces(F: ArrayLike, vertex_count: int) -> IntArray:
    """Triangles as (m, 3) int64 indices below `vertex_count`; MeshError otherwise."""
    F = _as_array(F, "faces", MeshError)
    if F.ndim != 2 or F.shape[1] != 3 or len(F) == 0:
        raise MeshError(f"faces must be (m, 3) triangles with m > 0, got {F.shape}")
    if not np.issubdtype(F.dtype, np.integer):
        raise MeshError(f"faces must be integers, got {F.dtype}")
    if F.min() < 0 or F.max() >= vertex_count:
        wrong = int(F.min() if F.min() < 0 else F.max())
        raise MeshError(f"faces name vertex {wrong}, expected 0 to {vertex_count - 1}")
    return F.astype(np.int64)


def as_integers(indices: ArrayLike, what: str) -> IntArray:
    """A copy as (k,) int64, an empty list of any type included; ConstraintError naming `what`."""
    array = _as_array(indices, what, ConstraintError)
    if array.size == 0:
        return np.empty(0, dtype=np.int64)
    if array.ndim != 1 or not np.issubdtype(array.dtype, np.integer):
        raise ConstraintError(
            f"{what} must be a list of vertex indices, got {array.dtype} of shape {array.shape}"
        )
    return array.astype(np.int64)


def as_indices(indices: ArrayLike, vertex_count: int, what: str) -> IntArray:
    """Vertex indices as (k,) int64 below `vertex_count`; ConstraintError naming `what`."""
    array = as_integers(indices, what)
    outside = (array < 0) | (array >= vertex_count)
    if outside.any():
        raise ConstraintError(
            f"{what} names vertex {int(array[outside][0])}, expected 0 to {vertex_count - 1}"
        )
    return array


def as_floats(values: ArrayLike, what: str, error: type[SolverError]) -> FloatArray:
    """Any shape as finite float64; `error` naming `what` otherwise."""
    try:
        array = np.array(values, dtype=np.float64)
    except (TypeError, ValueError, OverflowError) as failure:
        raise error(f"{what} must be numbers: {failure}") from failure
    if not np.isfinite(array).all():
        where = np.argwhere(~np.isfinite(array))[0].tolist()
        raise error(f"{what} must be finite, got {array[tuple(where)]} at index {where}")
    return array


def check_unit_interval(values: FloatArray, what: str, error: type[SolverError]) -> None:
    """`error` naming `what` unless all values lie in [0, 1]."""
    outside = (values < 0) | (values > 1)
    if outside.any():
        at = int(np.flatnonzero(outside)[0])
        raise error(f"{what} must lie in [0, 1], got {values[at]} at index {at}")


def locked(array: Array) -> Array:
    """The array itself, read-only. It must be the caller's own."""
    array.setflags(write=False)
    return array


def _as_array(values: ArrayLike, what: str, error: type[SolverError]) -> np.ndarray:
    try:
        return np.asarray(values)
    except ValueError as failure:  # rows of different lengths
        raise error(f"{what} must be an array: {failure}") from failure
