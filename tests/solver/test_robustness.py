"""Meshes and constraints with every ugliness: no NaN, nothing out of bounds, held vertices held."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from solver import ConstraintError, Deformer, fundamental_forms, interpolate_softness
from solver.geometry.bounding_box import diagonal
from solver.geometry.motions import motion, moved, rotation
from solver.types import FloatArray, IntArray
from tests.solver import shapes

V, F = shapes.grid(12, 12)
LEFT, RIGHT = np.flatnonzero(V[:, 0] == 0), np.flatnonzero(V[:, 0] == 11)
TIP = RIGHT[:3]
BUMPS = shapes.bumpy_plane(12)[0]

Scene = tuple[FloatArray, IntArray, Any, Any]


def squashed() -> FloatArray:
    W = V.copy()
    W[40] = W[41]
    return W


def bow_tie() -> tuple[FloatArray, IntArray]:
    """Two grids that share one vertex."""
    return np.vstack([V, V[1:] + V[143]]), np.vstack([F, np.where(F == 0, 143, F + 143)])


MESHES: dict[str, tuple[FloatArray, IntArray]] = {
    "a triangle without area": (squashed(), F),
    "duplicate faces": (BUMPS, np.vstack([F, F[:30]])),
    "faces with a repeated vertex": (BUMPS, np.vstack([F, [[3, 3, 4], [5, 5, 5], [7, 8, 7]]])),
    "an edge with three triangles": (
        np.vstack([BUMPS, [[5.5, 5, 3]]]),
        np.vstack([F, [[65, 66, 144], [66, 67, 144]]]),
    ),
    "a vertex that joins two fans": bow_tie(),
    "inconsistent winding": (BUMPS, np.where(np.arange(len(F))[:, None] % 2, F[:, ::-1], F)),
    "isolated vertices": (np.vstack([BUMPS, [[9, 9, 9], [1, 1, 1]]]), F),
    "two components": (np.vstack([BUMPS, BUMPS + [0, 0, 5]]), np.vstack([F, F + 144])),
    "needles": (V * [1, 1e-7, 1], F),
    "collinear vertices": (V * [1, 0, 0], F),
    "one point": (V * 0, F),
    "soup": (
        np.random.default_rng(1).normal(size=V.shape),
        np.random.default_rng(2).permutation(np.repeat(np.arange(144), 3)).reshape(-1, 3),
    ),
    "a hole": (BUMPS, np.delete(F, np.flatnonzero((F == 66).any(axis=1)), axis=0)),
    "one triangle": (V, np.array([[0, 11, 23]])),
}
CONSTRAINTS: dict[str, tuple[Any, Any]] = {
    "lines": (LEFT, [RIGHT]),
    "points": ([0], [[11]]),
    "planar regions": (np.flatnonzero(V[:, 0] < 2), [np.flatnonzero(V[:, 0] > 9)]),
    "nothing fixed": ([], [RIGHT]),
}


def check(surface: tuple[FloatArray, IntArray], fixed: Any, handles: Any, **options: Any) -> None:
    points, faces = surface
    scale = diagonal(points) or 1.0
    T = motion(rotation([0, 1, 0], 70), scale * np.array([-0.1, 0.1, 0.2]), points[handles[0][0]])
    deformer = Deformer(points, faces, fixed, handles, **options)
    soft = deformer.grab(np.exp(-((points - points[50]) ** 2).sum(axis=1) / (0.2 * scale) ** 2))
    target = points[handles[0][0]] + 0.2 * scale
    oriented = deformer.orient(0, points[handles[0][0]], target, [T])
    for rigid in (0, 1, 3):
        poses = {
            "pose": deformer.pose([T], rigid),
            "solve": deformer.solve(moved(T, points[handles[0]]), rigid),
            "orient": deformer.pose([oriented], rigid),
            "grab": soft.pose([T, np.eye(4)], rigid),
        }
        for name, X in poses.items():
            assert np.isfinite(X).all(), name
            assert np.abs(X - points).max() < 3 * scale, name
            np.testing.assert_array_equal(X[fixed], points[fixed])
        for name in ("pose", "solve", "grab"):
            expected = moved(T, points[handles[0]])
            np.testing.assert_allclose(poses[name][handles[0]], expected, atol=1e-12 * scale)
        rest = deformer.pose([np.eye(4)], rigid)
        np.testing.assert_allclose(rest, points, atol=1e-8 * scale)


@pytest.mark.parametrize("orientation", [True, False], ids=["oriented", "positions"])
@pytest.mark.parametrize("constraints", CONSTRAINTS)
@pytest.mark.parametrize("mesh", MESHES)
def test_any_mesh_deforms(mesh: str, constraints: str, orientation: bool) -> None:
    softness = np.random.default_rng(0).random(len(MESHES[mesh][0]))
    check(MESHES[mesh], *CONSTRAINTS[constraints], orientation=orientation, softness=softness)


@pytest.mark.parametrize("mesh", MESHES)
def test_any_mesh_has_forms_and_softness(mesh: str) -> None:
    points, faces = MESHES[mesh]
    forms = fundamental_forms(points, faces)
    assert np.isfinite(forms.lengths).all()
    assert not np.isinf(forms.dihedral_angles).any()
    s = interpolate_softness(points, faces, [0, 11], [0.2, 0.7])
    assert ((s == 0) | ((s >= 0.2) & (s <= 0.7))).all()


@pytest.mark.parametrize("height", [0, 1e-4, 0.01, 1])
def test_flat_handles_do_not_mirror_frames(height: float) -> None:
    points, faces = shapes.bumpy_plane(14)
    low, high = np.flatnonzero(points[:, 0] < 2), np.flatnonzero(points[:, 0] > 11)
    points[low, 2], points[high, 2] = 0, height
    T = motion(rotation([0, 1, 0], -60), [-2, 0, 3], [12, 6, 0])
    for orientation in (True, False):
        deformer = Deformer(points, faces, low, [high], orientation=orientation)
        assert (np.linalg.det(deformer.frames([T])) > 0).all()
        assert np.abs(deformer.pose([T]) - points).max() < 0.5 * diagonal(points)


def test_an_isolated_vertex_moves_with_its_handle_and_else_stays() -> None:
    points, faces = MESHES["isolated vertices"]
    X = Deformer(points, faces, LEFT, [[*RIGHT, 144]]).pose([motion(np.eye(3), [1, 2, 3])], 1)
    np.testing.assert_allclose(X[144], points[144] + [1, 2, 3], atol=1e-12)
    np.testing.assert_array_equal(X[145], points[145])


def test_a_component_without_a_constraint_stays() -> None:
    points, faces = MESHES["two components"]
    deformer = Deformer(points, faces, LEFT, [RIGHT])
    for rigid in (0, 1, 3):
        X = deformer.pose([motion(rotation([0, 1, 0], 50), [0, 0, 2])], rigid)
        np.testing.assert_array_equal(X[144:], points[144:])


def test_fans_that_meet_at_a_vertex_turn_together() -> None:
    points, faces = bow_tie()
    T = motion(rotation([1, 1, 0], 40), [0, 0, 1], V[143])
    X = Deformer(points, faces, handles=[np.arange(143)]).pose([T])
    np.testing.assert_allclose(X, moved(T, points), atol=1e-9)


@pytest.mark.parametrize("scale", [1e-9, 1e-3, 1e6, 1e12])
@pytest.mark.parametrize("away", [0, 1e3])
def test_any_unit_and_any_place(scale: float, away: float) -> None:
    points = scale * (BUMPS + away)
    T = motion(rotation([0, 1, 0], 70), scale * np.array([0, 0, 2.0]), points[11])
    expected = Deformer(BUMPS, F, LEFT, [RIGHT]).pose(
        [motion(rotation([0, 1, 0], 70), [0, 0, 2], BUMPS[11])], 1
    )
    X = Deformer(points, F, LEFT, [RIGHT]).pose([T], 1)
    np.testing.assert_allclose(X / scale - away, expected, atol=1e-8)


@pytest.mark.parametrize("coarse", [None, 60])
@pytest.mark.parametrize("rigid", [0, 1, 4])
def test_a_stray_vertex_changes_nothing(rigid: int, coarse: int | None) -> None:
    stray = np.vstack([BUMPS, [1000.0, -300.0, 5.0]])
    T = motion(rotation([0, 1, 0], 40), [0, 1, 2])
    expected, X = (
        Deformer(points, F, LEFT, [RIGHT], coarse=coarse).pose([T], rigid)
        for points in (BUMPS, stray)
    )
    np.testing.assert_allclose(X[:-1], expected, atol=1e-12 * diagonal(BUMPS))
    np.testing.assert_array_equal(X[-1], stray[-1])


@pytest.mark.parametrize("coarse", [None, 60])
def test_a_collapsed_piece_is_attached_to_what_it_lies_on(coarse: int | None) -> None:
    point = np.repeat(BUMPS[[50]] + [0, 0, 0.1], 3, axis=0)
    points, faces = np.vstack([BUMPS, point]), np.vstack([F, [[144, 145, 146]]])
    T = motion(rotation([0, 1, 0], 40), [0, 1, 2])
    X = Deformer(points, faces, handles=[np.arange(144)], coarse=coarse).pose([T], 1)
    np.testing.assert_allclose(X, moved(T, points), atol=1e-6)


@pytest.mark.parametrize("coarse", [None, 60])
def test_grab_weights_may_be_of_any_size(coarse: int | None) -> None:
    weights = np.exp(-((BUMPS - BUMPS[66]) ** 2).sum(axis=1))
    deformer = Deformer(BUMPS, F, LEFT, [RIGHT], coarse=coarse)
    T = [np.eye(4), motion(np.eye(3), [0, 0, 1])]
    expected = deformer.grab(weights).pose(T)
    for factor in (1e-200, 1e200):
        X = deformer.grab(factor * weights).pose(T)
        np.testing.assert_allclose(X, expected, atol=1e-9)
    held = np.full(len(BUMPS), 1e-308)
    held[LEFT] = 1.0  # these do not count, and what is left is nothing beside them
    with pytest.raises(ConstraintError, match="no vertex that is free to move"):
        deformer.grab(held).pose(T)
