"""The rigid levels: the first against a plain version of itself, the further ones by their laws."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from solver import Deformer
from solver.geometry.bounding_box import diagonal
from solver.geometry.motions import motion, moved, rotation
from solver.geometry.rotations import nearest_rotations
from solver.linear.assembly import deformation_matrix
from solver.linear.binding import bind
from solver.linear.rest_surface import RestSurface
from solver.rigid.levels import RigidLevels, State
from solver.rigid.smooth_rotations import ROTATION_LENGTH
from solver.setup import Setup
from solver.types import FloatArray, IntArray
from tests.solver import shapes
from tests.solver.definition import clamp, cotangent

V, F = shapes.bumpy_plane(7)
FIXED = np.flatnonzero(V[:, 0] < 2)
LEVELS = (2, 4, 9)


def nearest(A: FloatArray) -> FloatArray:
    U, _, Vt = np.linalg.svd(A)
    return np.asarray(U @ np.diag([1, 1, np.sign(np.linalg.det(U @ Vt))]) @ Vt)


def half_edges() -> list[tuple[int, int, int, float]]:
    """(triangle, a, b, cotangent) of every half-edge."""
    corners = [(t, f[i - 2], f[i - 1], f[i]) for t, f in enumerate(F.tolist()) for i in range(3)]
    return [(t, a, b, cotangent(V[a] - V[c], V[b] - V[c])) for t, a, b, c in corners]


def poisson(R: FloatArray, X: FloatArray, free: IntArray) -> FloatArray:
    """X with its free vertices where they minimise sum w ||x_b - x_a - R (p_b - p_a)||^2."""
    L, right = np.zeros((len(V), len(V))), np.zeros((len(V), 3))
    for t, a, b, cot in half_edges():
        w, pull = clamp(cot), R[t] @ (V[b] - V[a])
        L[a, a], L[b, b] = L[a, a] + w, L[b, b] + w
        L[a, b], L[b, a] = L[a, b] - w, L[b, a] - w
        right[b], right[a] = right[b] + w * pull, right[a] - w * pull
    held = np.delete(np.arange(len(V)), free)
    X = X.copy()
    X[free] = np.linalg.solve(L[free][:, free], (right - L[:, held] @ X[held])[free])
    return X


def turn(handle: list[int], degrees: float = 80) -> FloatArray:
    return motion(rotation([1, 2, 0], degrees), [-1, 0, 1], V[handle].mean(axis=0))


@pytest.mark.parametrize("handle", [[24], [31, 32, 38, 39]], ids=["a vertex", "a region"])
def test_the_first_level_is_nearest_rotations_and_their_positions(handle: list[int]) -> None:
    T = turn(handle)
    deformer = Deformer(V, F, FIXED, [handle])
    free = np.delete(np.arange(len(V)), [*FIXED, *handle])
    R = np.stack([nearest(G) for G in deformer.frames([T])])
    expected = poisson(R, deformer.pose([T]), free)
    np.testing.assert_allclose(deformer.pose([T], rigid=1), expected, atol=1e-9)


def descent(handle: list[int], rounds: int, degrees: float = 80) -> list[State]:
    """The states of some rounds, in diagonals; triangles that nothing strains are at rest."""
    rest = RestSurface.of(V, F)
    deformer = Deformer(V, F, FIXED, [handle])
    binding = bind(rest, Setup(fixed=FIXED, handles=[handle]))
    system = binding.system
    levels = RigidLevels(rest, binding.constraints, system, (), binding.bending_length)
    T = turn(handle, degrees)
    R = nearest_rotations(deformer.frames([T]).transpose(0, 2, 1))
    X = rest.normalise(deformer.pose([T], rigid=1))
    states = []
    for state, _ in zip(levels.descend(X, R[system.active], none()), range(rounds), strict=False):
        R = np.tile(np.eye(3), (len(F), 1, 1))
        R[system.active] = state.rotations
        states.append(replace(state, rotations=R))
    return states


def none() -> FloatArray:
    """The moments where there are no grabs."""
    return np.empty((0, 3))


def shell_energy(X: FloatArray, R: FloatArray) -> float:
    """X in diagonals, R as rows of its transpose."""
    rest = RestSurface.of(V, F)
    ones = np.ones(len(rest.topology.edges))
    K = deformation_matrix(rest.points, rest.topology, ROTATION_LENGTH, (ones, ones))
    U = np.vstack([X, R.reshape(-1, 3)])
    return float(0.5 * np.sum(U * (K @ U)))


@pytest.mark.parametrize("handle", [[24], [31, 32, 38, 39]], ids=["a vertex", "a region"])
@pytest.mark.parametrize("degrees", [30, 80, 175])
def test_every_round_lowers_the_energy(handle: list[int], degrees: float) -> None:
    states = descent(handle, 12, degrees)
    energies = np.array([shell_energy(state.positions, state.rotations) for state in states])
    assert len(energies) > 4
    assert (np.diff(energies) < 0).all()
    np.testing.assert_allclose([state.energy for state in states], energies, rtol=1e-9)
    R = states[-1].rotations
    np.testing.assert_allclose(
        R @ R.transpose(0, 2, 1), np.tile(np.eye(3), (len(R), 1, 1)), atol=1e-12
    )


def test_after_many_rounds_no_turn_of_any_triangle_lowers_the_energy() -> None:
    handle = [31, 32, 38, 39]
    state = descent(handle, 200)[-1]
    free = np.delete(np.arange(len(V)), [*FIXED, *handle])
    rng = np.random.default_rng(3)
    scale = diagonal(V)
    turning = np.flatnonzero(~np.isin(F, FIXED).all(axis=1) & ~np.isin(F, handle).all(axis=1))
    for _ in range(20):
        R = state.rotations.copy()
        for t in turning:
            R[t] = R[t] @ rotation(rng.normal(size=3), 0.3).T
        X = poisson(R.transpose(0, 2, 1), state.positions * scale, free) / scale
        assert shell_energy(X, R) > state.energy


def test_rounds_end_by_themselves() -> None:
    deformer = Deformer(V, F, FIXED, [[24]])
    T = turn([24])
    assert np.array_equal(deformer.pose([T], 300), deformer.pose([T], 1000))


@pytest.mark.parametrize("rigid", LEVELS)
def test_the_rest_pose_is_a_fixed_point(rigid: int) -> None:
    deformer = Deformer(V, F, FIXED, [[24], [31, 32, 38, 39]])
    np.testing.assert_allclose(deformer.pose([np.eye(4)] * 2, rigid), V, atol=1e-9)


Make = Callable[[FloatArray], Deformer]


def two_handles(X: FloatArray) -> Deformer:
    return Deformer(X, F, (), [FIXED, [31, 32, 38, 39]])


def positions_only(X: FloatArray) -> Deformer:
    return Deformer(X, F, (), [FIXED, [31, 32, 38, 39]], orientation=False)


def soft_elbow(X: FloatArray) -> Deformer:
    softness = np.clip(1 - np.abs(V[:, 0] - 3), 0, 1)
    return Deformer(X, F, (), [FIXED, [31, 32, 38, 39]], softness=softness)


def a_grab(X: FloatArray) -> Deformer:
    return Deformer(X, F, (), [FIXED]).grab(falloff())


def falloff() -> FloatArray:
    return np.asarray(np.clip(1.5 - np.linalg.norm(V - V[38], axis=1), 0, None))


MAKES = [two_handles, positions_only, soft_elbow, a_grab]


@pytest.mark.parametrize("make", MAKES)
@pytest.mark.parametrize("rigid", LEVELS)
def test_one_rigid_motion_of_all_constraints_moves_the_result_by_it(make: Make, rigid: int) -> None:
    deformer, T = make(V), turn([38], 60)
    M = motion(rotation([3, -1, 2], 130), [5, -2, 1])
    once, again = deformer.pose([np.eye(4), T], rigid), deformer.pose([M, M @ T], rigid)
    np.testing.assert_allclose(again, moved(M, once), atol=1e-8 * diagonal(V))


@pytest.mark.parametrize("make", MAKES)
def test_scaling_the_file_scales_the_result(make: Make) -> None:
    T = turn([38], 60)
    large = T.copy()
    large[:3, 3] *= 1000
    result = make(1000 * V).pose([np.eye(4), large], 4)
    np.testing.assert_allclose(
        result, 1000 * make(V).pose([np.eye(4), T], 4), atol=1e-5 * diagonal(V)
    )


@pytest.mark.parametrize("make", [two_handles, positions_only, soft_elbow])
@pytest.mark.parametrize("rigid", LEVELS)
def test_held_vertices_are_where_the_handles_put_them(make: Make, rigid: int) -> None:
    T = turn([38], 100)
    X = make(V).pose([np.eye(4), T], rigid)
    np.testing.assert_array_equal(X[FIXED], V[FIXED])
    handle = [31, 32, 38, 39]
    np.testing.assert_allclose(X[handle], moved(T, V[handle]), atol=1e-12 * diagonal(V))


@pytest.mark.parametrize("rigid", LEVELS)
def test_the_moments_of_grabs_stay_met(rigid: int) -> None:
    w = falloff()
    T, S = turn([38], 50), motion(rotation([0, 0, 1], 40), [0, -0.5, 1], V[27])
    other = np.clip(1.2 - np.linalg.norm(V - V[27], axis=1), 0, None)
    deformer = Deformer(V, F, FIXED).grab(w).grab(other)
    X = deformer.pose([T, S], rigid)
    rest = np.column_stack([V, np.ones(len(V))])
    for weights, motion_of in ((w, T), (other, S)):
        weights = np.where(np.isin(np.arange(len(V)), FIXED), 0.0, weights)
        moments = (rest * weights[:, None]).T
        np.testing.assert_allclose(
            moments @ X, moments @ moved(motion_of, V), atol=1e-8 * diagonal(V)
        )


@pytest.mark.parametrize("rigid", LEVELS)
def test_where_everything_is_held_there_is_nothing_to_turn(rigid: int) -> None:
    deformer = Deformer(V, F, FIXED, [np.delete(np.arange(len(V)), FIXED)])
    T = motion(rotation([0, 0, 1], 40))
    expected = np.where(np.isin(np.arange(len(V)), FIXED)[:, None], V, moved(T, V))
    np.testing.assert_allclose(deformer.pose([T], rigid), expected, atol=1e-9)


def test_a_bend_in_small_steps_moves_the_surface_in_small_steps() -> None:
    P, faces = shapes.tube(30, 12)
    fixed, tip = np.flatnonzero(P[:, 0] < 0.5), np.flatnonzero(P[:, 0] > 7.5)
    deformer = Deformer(P, faces, fixed, [tip])
    steps = [motion(rotation([0, 0, 1], a), centre=[4, 0, 0]) for a in range(0, 152, 2)]
    poses = np.stack([deformer.pose([T], 4) for T in steps])
    surface = np.linalg.norm(np.diff(poses, axis=0), axis=2).max(axis=1)
    handle = np.linalg.norm(np.diff(poses[:, tip], axis=0), axis=2).max(axis=1)
    assert (surface < 3 * handle).all()


@pytest.mark.parametrize("make", MAKES)
def test_large_turns_go_along_with_one_rigid_motion_of_everything(make: Make) -> None:
    deformer, T = make(V), turn([38], 170)
    S, M = turn([10], 35), motion(rotation([3, -1, 2], 130), [5, -2, 1])
    once, again = deformer.pose([S, S @ T], 4), deformer.pose([M @ S, M @ S @ T], 4)
    np.testing.assert_allclose(again, moved(M, once), atol=1e-6 * diagonal(V))
