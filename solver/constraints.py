"""Which rows of the system are held, and by which handle."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from solver.arrays import as_indices
from solver.errors import ConstraintError
from solver.shape import RestShape
from solver.types import BoolArray, IntArray

FREE = -1
FIXED = 0  # handle number h is group 1 + h
# Held points count as lying in one plane when their thickness is below this share of their extent.
PLANAR = 1e-6


@dataclass(frozen=True)
class Constraints:
    """Hard constraints of one bind.

    handles: the vertices of each movable handle.
    row_group: (n + 3m,) FREE, FIXED or 1 + h for each row of U.
    free: the rows to solve for. A component that nothing holds is not among them.
    held_components: (components,) whether anything holds that component.
    """

    handles: tuple[IntArray, ...]
    row_group: IntArray
    free: IntArray
    held_components: BoolArray


def build_constraints(
    shape: RestShape, fixed: ArrayLike, handles: Sequence[ArrayLike], orientation: bool
) -> Constraints:
    """Vertices of `fixed` and `handles` are held; so are their triangles' frames if `orientation`.

    Raises ConstraintError for an index out of range, an empty handle, or a vertex with two roles.
    """
    n = len(shape.vertices)
    named = tuple(as_indices(h, n, f"handle {i}") for i, h in enumerate(handles))
    group = np.full(n, FREE, dtype=np.int64)
    group[as_indices(fixed, n, "fixed")] = FIXED
    for number, vertices in enumerate(named):
        _claim(group, vertices, number)
    component = shape.topology.vertex_component
    held = np.zeros(component.max() + 1, dtype=bool)
    held[component[group != FREE]] = True
    oriented = held if orientation else held & _underdetermined(shape, group)
    face_group = _face_groups(shape, group, oriented)
    row_group = shape.rows(group, face_group)
    free = np.flatnonzero((row_group == FREE) & held[shape.row_component])
    return Constraints(named, row_group, free, held)


def _claim(group: IntArray, vertices: IntArray, number: int) -> None:
    if len(vertices) == 0:
        raise ConstraintError(f"handle {number} has no vertices")
    if len(np.unique(vertices)) != len(vertices):
        raise ConstraintError(f"handle {number} names a vertex twice")
    taken = vertices[group[vertices] != FREE]
    if len(taken):
        other = group[taken[0]]
        name = "fixed" if other == FIXED else f"in handle {other - 1}"
        raise ConstraintError(f"vertex {taken[0]} is both {name} and in handle {number}")
    group[vertices] = 1 + number


def _face_groups(shape: RestShape, group: IntArray, oriented: BoolArray) -> IntArray:
    """(m,) the group that holds each triangle's frame.

    A group holds the triangles whose corners all belong to it. Where it has none in some
    component (a single vertex, a line) it holds the triangles around: a seed vertex with its frame.
    """
    faces = shape.faces
    component = shape.topology.vertex_component
    corners = group[faces]
    whole = (corners == corners[:, :1]).all(axis=1) & oriented[component[faces[:, 0]]]
    face_group = np.where(whole, corners[:, 0], FREE)
    groups = group.max() + 1

    def piece(group: IntArray, vertex: IntArray) -> IntArray:
        return component[vertex] * groups + group

    has_frame = np.unique(piece(face_group, faces[:, 0])[face_group != FREE])
    for corner in range(3):
        vertex = faces[:, corner]
        owner = group[vertex]
        lacking = ~np.isin(piece(owner, vertex), has_frame) & oriented[component[vertex]]
        face_group = np.where((face_group == FREE) & (owner != FREE) & lacking, owner, face_group)
    return face_group


def _underdetermined(shape: RestShape, group: IntArray) -> BoolArray:
    """(components,) whether the held positions of a component lie in a plane, a line or a point.

    Such positions leave the rest free to turn or mirror about them, so frames must be held too.
    """
    component = shape.topology.vertex_component
    held = np.flatnonzero(group != FREE)
    label, points = component[held], shape.points[held]
    count = np.bincount(label, minlength=component.max() + 1).clip(min=1)
    mean = np.column_stack([np.bincount(label, points[:, k], len(count)) for k in range(3)])
    offset = points - (mean / count[:, None])[label]
    scatter = np.zeros((len(count), 3, 3))
    np.add.at(scatter, label, offset[:, :, None] * offset[:, None, :])
    spread = np.linalg.eigvalsh(scatter)
    return np.asarray(spread[:, 0] <= PLANAR**2 * spread[:, 2])
