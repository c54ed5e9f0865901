"""Soft handles: the region's moments are met, at the least energy."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from solver import ConstraintError, Deformer
from solver.geometry.bounding_box import diagonal
from solver.geometry.motions import motion, moved, rotation
from solver.softness.falloff import falloff
from solver.types import FloatArray
from tests.solver import shapes
from tests.solver.definition import Definition, resolved, stack

LEVELS = [0, 1, 3]
V, F = shapes.tube(20, 10)
FIXED = np.flatnonzero(V[:, 0] < 1)
TIP = np.flatnonzero(V[:, 0] > 7.5)
T = motion(rotation([1, 1, 2], 70), [-1, 2, 1], [6, 0, 0])
HAND = motion(rotation([0, 0, 1], 50), [-1, 1, 0], [8, 0, 0])


def dab(centre: Any, radius: float, points: FloatArray = V) -> FloatArray:
    """A brush: smooth, 1 at the centre, 0 from the radius on."""
    return falloff(np.linalg.norm(points - centre, axis=1) / radius)


def affine_fit(points: FloatArray, X: FloatArray, weights: FloatArray) -> FloatArray:
    """(3, 4): the best affine map from points to X by weighted least squares."""
    rows = np.sqrt(weights)[:, None]
    J = np.column_stack([points, np.ones(len(points))])
    return np.asarray(np.linalg.lstsq(rows * J, rows * X, rcond=None)[0].T)


@pytest.mark.parametrize("rigid", LEVELS)
def test_the_affine_fit_of_the_region_is_the_transform(rigid: int) -> None:
    weights = dab([6, 0, 0], 2)
    X = Deformer(V, F, FIXED).grab(weights).pose([T], rigid)
    np.testing.assert_allclose(affine_fit(V, X, weights), T[:3], atol=1e-9)
    np.testing.assert_array_equal(X[FIXED], V[FIXED])


@pytest.mark.parametrize("rigid", LEVELS)
def test_several_grabs_and_a_handle_are_all_met(rigid: int) -> None:
    one, two = dab([4, 1, 0], 1.5), dab([5, -1, 0], 2)  # they overlap
    deformer = Deformer(V, F, FIXED, [TIP]).grab(one).grab(two)
    assert deformer.handle_count == 3
    posed = [HAND, motion(rotation([1, 0, 0], 20), [0, 1, 0]), motion(np.eye(3), [0, -0.5, 1])]
    X = deformer.pose(posed, rigid)
    np.testing.assert_allclose(X[TIP], moved(HAND, V[TIP]), atol=1e-12)
    np.testing.assert_array_equal(X[FIXED], V[FIXED])
    for weights, t in ((one, posed[1]), (two, posed[2])):
        np.testing.assert_allclose(affine_fit(V, X, weights), t[:3], atol=1e-8)


@pytest.mark.parametrize("handles", [[], [TIP]])
def test_no_other_surface_with_these_moments_has_less_energy(handles: list[Any]) -> None:
    weights = dab([5, 0, 0], 2) * (V[:, 0] <= 7.5)
    deformer = Deformer(V, F, FIXED, handles).grab(weights)
    posed = [HAND] * len(handles) + [T]
    U = stack(deformer.pose(posed), deformer.frames(posed))
    definition = Definition(V, F, resolved(V, F))
    held = [FIXED, *handles]
    vertex_free = ~np.isin(np.arange(len(V)), np.concatenate(held))
    face_free = ~np.any([np.isin(F, h).all(axis=1) for h in held], axis=0)
    free = np.concatenate([vertex_free, np.repeat(face_free, 3)])
    C = np.zeros((len(U), 4))
    C[: len(V)] = weights[:, None] * np.column_stack([V, np.ones(len(V))])
    least = definition.energy(U)
    rng = np.random.default_rng(0)
    for _ in range(20):
        d = free[:, None] * rng.normal(size=U.shape)
        d -= C @ np.linalg.solve(C.T @ C, C.T @ d)
        d *= np.sqrt(least / definition.energy(d))
        assert abs(definition.slope(U, d)) < 1e-8 * least
        assert definition.energy(U + 0.01 * d) > least
    assert abs(definition.slope(U, C @ rng.normal(size=(4, 3)))) > 1e-3 * least


def test_grabbing_a_flat_region_tilts_it() -> None:
    points, faces = shapes.grid(14, 14)
    rim = np.flatnonzero((points[:, 0] == 0) | (points[:, 0] == 13))
    weights = dab([6.5, 6.5, 0], 3, points)
    deformer = Deformer(points, faces, rim).grab(weights)
    t = motion(rotation([0, 1, 0], 30), [0, 0, 3], [6.5, 6.5, 0])
    for rigid in LEVELS:
        X = deformer.pose([t], rigid)
        fit = affine_fit(points[:, :2], X, weights)
        np.testing.assert_allclose(fit, t[:3, [0, 1, 3]], atol=1e-9)
        assert diagonal(X) < 2 * diagonal(points)
    mean = weights[faces].mean(axis=1) @ deformer.frames([t]).reshape(-1, 9)
    mean = mean.reshape(3, 3) / weights[faces].mean(axis=1).sum()
    np.testing.assert_allclose(mean[:, 2], t[:3, 2], atol=1e-9)


@pytest.mark.parametrize("rigid", LEVELS)
def test_grabbing_one_vertex_moves_and_turns_it(rigid: int) -> None:
    points, faces = shapes.grid(14, 14)
    rim = np.flatnonzero((points[:, 0] == 0) | (points[:, 0] == 13))
    one = 6 * 14 + 6
    deformer = Deformer(points, faces, rim).grab(np.eye(len(points))[one])
    t = motion(rotation([1, 1, 0], 40), [0, 0, 2], points[one])
    X = deformer.pose([t], rigid)
    np.testing.assert_allclose(X[one], moved(t, points[one]), atol=1e-9)
    assert diagonal(X) < 2 * diagonal(points)
    around = (faces == one).any(axis=1)
    np.testing.assert_allclose(deformer.frames([t])[around].mean(axis=0), t[:3, :3], atol=1e-9)


@pytest.mark.parametrize("rigid", LEVELS)
def test_a_piece_that_nothing_holds_is_carried(rigid: int) -> None:
    two = np.vstack([V, V + [0, 5, 0]])
    deformer = Deformer(two, np.vstack([F, F + len(V)]), FIXED)
    weights = np.concatenate([np.zeros(len(V)), dab([6, 0, 0], 2)])
    X = deformer.grab(weights).pose([T], rigid)
    np.testing.assert_allclose(X[: len(V)], V, atol=1e-11)
    np.testing.assert_allclose(X[len(V) :], moved(T, two[len(V) :]), atol=1e-9)


def test_a_grab_across_pieces_holds_one_and_carries_the_other() -> None:
    two = np.vstack([V, V + [0, 5, 0]])
    weights = dab([6, 2.5, 0], 4, two)
    deformer = Deformer(two, np.vstack([F, F + len(V)]), FIXED).grab(weights)
    X = deformer.pose([T])
    np.testing.assert_allclose(affine_fit(two, X, weights), T[:3], atol=1e-9)
    np.testing.assert_allclose(X[len(V) :], moved(T, two[len(V) :]), atol=1e-9)


def test_rest_is_a_fixed_point_and_the_first_deformer_stays_as_it_was() -> None:
    first = Deformer(V, F, FIXED, [TIP])
    before = [first.pose([HAND], rigid) for rigid in LEVELS]
    grabbed = first.grab(dab([4, 0, 0], 2))
    for rigid in LEVELS:
        np.testing.assert_allclose(grabbed.pose([np.eye(4)] * 2, rigid), V, atol=1e-11)
    grabbed.pose([HAND, T])
    assert first.handle_count == 1
    for rigid, X in zip(LEVELS, before, strict=True):
        np.testing.assert_array_equal(first.pose([HAND], rigid), X)


@pytest.mark.parametrize("rigid", LEVELS)
def test_moving_every_constraint_moves_the_result(rigid: int) -> None:
    weights = dab([4, 0, 0], 2)
    deformer = Deformer(V, F, [], [FIXED, TIP]).grab(weights)
    M = motion(rotation([3, 1, 2], 130), [4, 5, 6])
    posed = [np.eye(4), HAND, motion(np.eye(3), [0, 1, 0])]
    X = deformer.pose([M @ t for t in posed], rigid)
    np.testing.assert_allclose(X, moved(M, deformer.pose(posed, rigid)), atol=1e-8)


def test_the_scale_of_weights_does_not_matter() -> None:
    weights = dab([4, 0, 0], 2)
    one, other = (Deformer(V, F, FIXED).grab(k * weights).pose([T]) for k in (1, 1e6))
    np.testing.assert_allclose(one, other, atol=1e-9)


def test_rebinding_keeps_grabs() -> None:
    weights, softness = dab([4, 0, 0], 2), V[:, 0] / 8
    grabbed = Deformer(V, F, FIXED, [TIP]).grab(weights)
    X = grabbed.rebind(softness=softness).pose([HAND, T], 1)
    fresh = Deformer(V, F, FIXED, [TIP], softness).grab(weights)
    np.testing.assert_allclose(X, fresh.pose([HAND, T], 1), atol=1e-9)


def test_solve_holds_grabs_at_rest() -> None:
    weights = dab([4, 0, 0], 2)
    deformer = Deformer(V, F, FIXED, [TIP]).grab(weights)
    for rigid in LEVELS:
        X = deformer.solve(moved(HAND, V[TIP]), rigid)
        np.testing.assert_allclose(X, deformer.pose([HAND, np.eye(4)], rigid), atol=1e-8)


def test_refuses_weights_that_select_nothing() -> None:
    deformer = Deformer(V, F, FIXED)
    n = len(V)
    with shapes.refuses(ConstraintError, "select no vertex that is free"):
        deformer.grab(np.zeros(n))
    with shapes.refuses(ConstraintError, "select no vertex that is free"):
        deformer.grab(np.isin(np.arange(n), FIXED))
    with shapes.refuses(ConstraintError, f"grab weights must be ({n},), got (3,)"):
        deformer.grab(np.ones(3))
    with shapes.refuses(ConstraintError, "grab weights must not be negative, got -1.0"):
        deformer.grab(-np.ones(n))
    with shapes.refuses(ConstraintError, "grab weights must be finite"):
        deformer.grab(np.full(n, np.nan))


def test_refuses_two_grabs_of_a_piece_that_nothing_holds() -> None:
    with shapes.refuses(ConstraintError, "takes one grab, got two"):
        Deformer(V, F).grab(dab([6, 0, 0], 2)).grab(dab([2, 0, 0], 2))
