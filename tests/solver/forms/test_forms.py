"""Laws of lengths, dihedral angles, frames and transitions."""

from __future__ import annotations

import numpy as np
import pytest

from solver import MeshError, fundamental_forms
from solver.forms.fundamental_forms import (
    corner_points,
    transitions,
)
from solver.geometry.frames import triangle_frames
from solver.geometry.topology import Topology
from tests.solver import shapes
from tests.solver.shapes import Surface

SURFACES = {
    "tetrahedron": shapes.tetrahedron(),
    "sphere": shapes.sphere(),
    "bumpy plane": shapes.bumpy_plane(),
    "tube": shapes.tube(),
    "bar": shapes.bar(),
}


@pytest.fixture(params=[*SURFACES.values()], ids=[*SURFACES])
def surface(request: pytest.FixtureRequest) -> Surface:
    V, F = request.param
    return V.copy(), F.copy()


def test_rigid_motions_leave_the_forms_alone(surface: Surface) -> None:
    V, F = surface
    rng = np.random.default_rng(0)
    before = fundamental_forms(V, F)
    after = fundamental_forms(V @ shapes.random_rotation(rng).T + rng.normal(size=3), F)
    np.testing.assert_allclose(after.lengths, before.lengths, rtol=1e-12)
    np.testing.assert_allclose(after.dihedral_angles, before.dihedral_angles, atol=1e-9)


def test_scaling_scales_lengths_and_not_angles(surface: Surface) -> None:
    V, F = surface
    before, after = fundamental_forms(V, F), fundamental_forms(1000 * V, F)
    np.testing.assert_allclose(after.lengths, 1000 * before.lengths, rtol=1e-12)
    np.testing.assert_allclose(after.dihedral_angles, before.dihedral_angles, atol=1e-9)


def test_reflection_and_turning_inside_out_change_the_sign_of_angles(surface: Surface) -> None:
    V, F = surface
    angles = fundamental_forms(V, F).dihedral_angles
    for mirrored in (fundamental_forms(V * [1, 1, -1], F), fundamental_forms(V, F[:, ::-1])):
        np.testing.assert_allclose(mirrored.dihedral_angles, -angles, atol=1e-9)


def test_edges_are_sorted_pairs_in_lexicographic_order(surface: Surface) -> None:
    _, F = surface
    expected = sorted(
        {tuple(sorted((f[i], f[j]))) for f in F.tolist() for i, j in ((0, 1), (1, 2), (2, 0))}
    )
    assert fundamental_forms(*surface).edges.tolist() == [list(edge) for edge in expected]


def test_convex_edges_are_positive() -> None:
    V, F = shapes.tetrahedron()
    forms = fundamental_forms(V, F)
    np.testing.assert_allclose(forms.dihedral_angles, np.pi - np.arccos(1 / 3))
    np.testing.assert_allclose(forms.lengths, np.sqrt(8))


def test_flat_is_zero_and_the_boundary_has_no_angle() -> None:
    V, F = shapes.grid(5, 4)
    forms = fundamental_forms(V, F)
    on_rim = (V[:, 0] == 0) | (V[:, 0] == 4) | (V[:, 1] == 0) | (V[:, 1] == 3)
    middle = V[forms.edges].mean(axis=1)
    boundary = on_rim[forms.edges].all(axis=1) & (
        np.isin(middle[:, 0], [0, 4]) | np.isin(middle[:, 1], [0, 3])
    )
    np.testing.assert_array_equal(np.isnan(forms.dihedral_angles), boundary)
    np.testing.assert_allclose(forms.dihedral_angles[~boundary], 0, atol=1e-15)


def test_an_edge_with_three_triangles_has_no_angle() -> None:
    V = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1]], dtype=float)
    assert np.isnan(fundamental_forms(V, [[0, 1, 2], [1, 0, 3], [0, 1, 4]]).dihedral_angles).all()


def test_transitions_take_each_frame_to_its_neighbour(surface: Surface) -> None:
    V, F = surface
    topology = Topology(F, len(V))
    pairs = topology.manifold_pairs
    R = transitions(topology, fundamental_forms(V, F), pairs)
    f = triangle_frames(V[F]).axes
    np.testing.assert_allclose(f[pairs.first] @ R, f[pairs.second], atol=1e-9)


def test_frames_and_corner_points_give_the_edges_back(surface: Surface) -> None:
    V, F = surface
    topology = Topology(F, len(V))
    points = corner_points(fundamental_forms(V, F).lengths[topology.half_edge_edge])
    world = np.einsum("tij,tkj->tki", triangle_frames(V[F]).axes[:, :, :2], points)
    np.testing.assert_allclose(world, V[F] - V[F[:, :1]], atol=1e-12)


@pytest.mark.parametrize(
    "corners",
    [[[0, 0, 0], [1, 0, 0], [2, 0, 0]], [[0, 0, 0], [0, 0, 0], [1, 2, 3]], [[1, 1, 1]] * 3],
    ids=["line", "repeated point", "one point"],
)
def test_triangles_without_area_get_orthonormal_frames(corners: list[list[float]]) -> None:
    (f,) = triangle_frames(np.array([corners], dtype=float)).axes
    np.testing.assert_allclose(f.T @ f, np.eye(3), atol=1e-12)
    assert np.linalg.det(f) > 0
    assert np.isfinite(fundamental_forms(corners, [[0, 1, 2]]).lengths).all()


@pytest.mark.parametrize(
    ("V", "F", "text"),
    [
        (np.zeros((3, 2)), [[0, 1, 2]], "vertices must be (n, 3)"),
        (np.zeros((0, 3)), [[0, 1, 2]], "vertices must be (n, 3)"),
        ([["a", 0, 0]], [[0, 1, 2]], "vertices must be numbers"),
        ([[np.nan, 0, 0]] * 3, [[0, 1, 2]], "vertices must be finite, got nan at index [0, 0]"),
        ([[0, 0, 0], [0, np.inf, 0]], [[0, 1, 2]], "got inf at index [1, 1]"),
        (np.eye(3), np.zeros((0, 3), dtype=int), "faces must be (m, 3)"),
        (np.eye(3), [[0, 1, 2, 0]], "faces must be (m, 3)"),
        (np.eye(3), [[0.0, 1.0, 2.0]], "faces must be integers"),
        (np.eye(3), [[0, 1, 3]], "faces name vertex 3, expected 0 to 2"),
        (np.eye(3), [[0, 1, -1]], "faces name vertex -1"),
        (np.eye(3), [[0, 1, 2], [0, 1]], "faces must be"),
    ],
)
def test_refuses_what_is_no_mesh(V: object, F: object, text: str) -> None:
    with shapes.refuses(MeshError, text):
        fundamental_forms(V, F)  # type: ignore[arg-type]
