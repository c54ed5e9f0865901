"""What handles hold, and what they refuse."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from solver import ConstraintError, Deformer
from solver.linear.constraints import Constraints, build_constraints
from solver.linear.rest_surface import RestSurface
from solver.setup import FIXED, FREE, Setup
from tests.solver import shapes


def build(
    surface: shapes.Surface, fixed: Any, handles: Any, orientation: bool = True
) -> tuple[Constraints, np.ndarray]:
    """The constraints, and the group that holds each triangle's frame."""
    shape = RestSurface.of(*surface)
    constraints = build_constraints(shape, Setup(fixed, handles, orientation=orientation))
    rows = constraints.row_group[len(shape.vertices) :].reshape(-1, 3)
    assert (rows == rows[:, :1]).all()
    return constraints, rows[:, 0]


def test_a_handle_holds_the_frames_of_its_whole_triangles() -> None:
    V, F = shapes.bar(6, 2)
    left, right = np.flatnonzero(V[:, 0] <= 1), np.flatnonzero(V[:, 0] >= 5)
    constraints, face_group = build((V, F), left, [right])
    group = np.full(len(V), FREE)
    group[left], group[right] = FIXED, 1
    np.testing.assert_array_equal(constraints.row_group[: len(V)], group)
    np.testing.assert_array_equal(face_group == FIXED, np.isin(F, left).all(axis=1))
    np.testing.assert_array_equal(face_group == 1, np.isin(F, right).all(axis=1))
    np.testing.assert_array_equal(constraints.free, np.flatnonzero(constraints.row_group == FREE))


def test_positions_alone_are_held_without_orientation() -> None:
    V, F = shapes.bar(6, 2)
    left, right = np.flatnonzero(V[:, 0] <= 1), np.flatnonzero(V[:, 0] >= 5)
    _, face_group = build((V, F), left, [right], orientation=False)
    assert (face_group == FREE).all()


@pytest.mark.parametrize("held", ["plane", "line", "point"])
def test_frames_are_held_where_positions_lie_in_a_plane(held: str) -> None:
    V, F = shapes.bar(6, 2)
    chosen = {"plane": V[:, 0] == 6, "line": V @ [0, 1, 1] == 0, "point": V @ [1, 1, 1] == 0}[held]
    _, face_group = build((V, F), np.flatnonzero(chosen), [], orientation=False)
    assert (face_group == FIXED).any()


def test_a_flat_handle_holds_its_frames_whatever_else_is_held() -> None:
    V, F = shapes.bar(6, 2)
    left, end = np.flatnonzero(V[:, 0] <= 1), np.flatnonzero(V[:, 0] == 6)
    _, face_group = build((V, F), left, [end], orientation=False)
    np.testing.assert_array_equal(face_group == 1, np.isin(F, end).all(axis=1))
    assert not (face_group == FIXED).any()


def test_points_that_span_space_hold_no_frames_without_orientation() -> None:
    V, F = shapes.sphere()
    _, face_group = build((V, F), [], [[0], [1], [2], [3]], orientation=False)
    assert (face_group == FREE).all()


def test_a_handle_without_a_whole_triangle_holds_those_around() -> None:
    V, F = shapes.grid(6, 6)
    _, face_group = build((V, F), [0], [[14], [33, 34]])
    for group, vertices in ((FIXED, [0]), (1, [14]), (2, [33, 34])):
        np.testing.assert_array_equal(face_group == group, np.isin(F, vertices).any(axis=1))


def test_a_component_without_a_constraint_is_left_out() -> None:
    V, F = shapes.grid(4, 4)
    two = np.vstack([V, V + 9, [[50, 50, 50]]]), np.vstack([F, F + 16])
    constraints, _ = build(two, [0], [[15]])
    assert constraints.held_bodies.sum() == 1
    vertices = constraints.free[constraints.free < 33]
    np.testing.assert_array_equal(vertices, np.arange(1, 15))


def test_nothing_held_leaves_nothing_to_solve() -> None:
    constraints, _ = build(shapes.tetrahedron(), [], [])
    assert len(constraints.free) == 0


@pytest.mark.parametrize(
    ("fixed", "handles", "text"),
    [
        ([4], [], "fixed names vertex 4, expected 0 to 3"),
        ([-1], [], "fixed names vertex -1"),
        ([0.5], [], "fixed must be a list of vertex indices, got float64"),
        ([True, False, False, False], [], "fixed must be a list of vertex indices, got bool"),
        ([[0, 1]], [], "fixed must be a list of vertex indices, got int64 of shape (1, 2)"),
        ([[0, 1], [2]], [], "fixed must be an array"),
        ([0], [[1], [7]], "handle 1 names vertex 7"),
        ([0], [[]], "handle 0 has no vertices"),
        ([0], [[1, 1]], "handle 0 names a vertex twice"),
        ([0, 1], [[1]], "vertex 1 is both fixed and in handle 0"),
        ([0], [[1], [2, 1]], "vertex 1 is both in handle 0 and in handle 1"),
    ],
)
def test_refuses_roles_that_make_no_sense(fixed: Any, handles: Any, text: str) -> None:
    with shapes.refuses(ConstraintError, text):
        Deformer(*shapes.tetrahedron(), fixed, handles)


def test_naming_a_fixed_vertex_twice_is_no_error() -> None:
    constraints, _ = build(shapes.tetrahedron(), [0, 0], [[1]])
    assert (constraints.row_group[:4] == FIXED).tolist() == [True, False, False, False]
