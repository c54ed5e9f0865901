"""Large turns: rounds start from half-way poses too, and the end of lowest energy counts."""

from __future__ import annotations

from itertools import islice

import numpy as np
import pytest

from solver import Deformer
from solver.geometry.motions import motion, rotation
from solver.linear.binding import Binding, bind
from solver.linear.rest_surface import RestSurface
from solver.rigid.half_way import half_way
from solver.rigid.levels import RigidLevels
from solver.setup import Setup
from solver.types import FloatArray, IntArray
from tests.solver import shapes
from tests.solver.rigid.test_levels import LEVELS, nearest, none


def bent_tube(degrees: float) -> tuple[FloatArray, IntArray, IntArray, IntArray, FloatArray]:
    """A thick tube, its fixed and its moved end, and a turn of that."""
    P, faces = shapes.tube(30, 12)
    fixed, tip = np.flatnonzero(P[:, 0] < 0.5), np.flatnonzero(P[:, 0] > 7.5)
    return P, faces, fixed, tip, motion(rotation([0, 0, 1], degrees), centre=[4, 0, 0])


@pytest.mark.parametrize("degrees", [125, 150, 169, 179])
@pytest.mark.parametrize("rigid", LEVELS)
def test_of_all_starts_the_lowest_end_counts(degrees: float, rigid: int) -> None:
    P, faces, fixed, tip, T = bent_tube(degrees)
    halves = [bent_tube(0.5 * angle)[-1] for angle in (degrees, degrees - 360)]
    rest, binding, levels = parts(P, faces, fixed, tip)
    deformer = Deformer(P, faces, fixed, [tip])
    X = rest.normalise(deformer.pose([T], rigid))
    starts = [deformer.frames([T])]
    for half in halves if degrees > 170 else halves[:1]:
        R = np.stack([nearest(G) for G in deformer.frames([half])])
        starts.append(R @ R)
    ends = []
    for frames in starts:
        R = np.stack([nearest(G).T for G in frames])[binding.system.active]
        start = levels.poisson.positions(X, R, none())
        ends.append(list(islice(levels.descend(start, R, none()), rigid))[-1])
    lowest = min(ends, key=lambda state: state.energy)
    np.testing.assert_allclose(X, lowest.positions, atol=1e-6)


def parts(
    P: FloatArray, faces: IntArray, fixed: IntArray, tip: IntArray
) -> tuple[RestSurface, Binding, RigidLevels]:
    rest = RestSurface.of(P, faces)
    binding = bind(rest, Setup(fixed=fixed, handles=[tip]))
    length = binding.bending_length
    return rest, binding, RigidLevels(rest, binding.constraints, binding.system, (), length)


def stretched(T: FloatArray) -> FloatArray:
    return np.asarray(T @ np.diag([1.1, 1, 1, 1]))


def mirrored(T: FloatArray) -> FloatArray:
    return np.asarray(T @ np.diag([1, 1, -1, 1]))


@pytest.mark.parametrize(
    "T",
    [bent_tube(119)[-1], stretched(bent_tube(175)[-1]), mirrored(bent_tube(175)[-1])],
    ids=["a turn of less than 120", "stretched", "mirrored"],
)
def test_all_but_large_turns_have_one_start(T: FloatArray) -> None:
    P, faces, fixed, tip, _ = bent_tube(0)
    rest, _, levels = parts(P, faces, fixed, tip)
    deformer = Deformer(P, faces, fixed, [tip])
    rows = deformer.frames([T]).transpose(0, 2, 1).reshape(-1, 3)
    U = np.vstack([rest.normalise(deformer.pose([T])), rows])
    X = rest.normalise(deformer.pose([T], 4))
    np.testing.assert_allclose(X, levels.refine(U, 4).positions, atol=1e-8)


@pytest.mark.parametrize("anchored", [True, False])
def test_half_way_twice_is_all_the_way(anchored: bool) -> None:
    T = [motion(rotation([1, -2, 3], 40), [1, 2, 0]), motion(rotation([2, 1, 0], 178), [0, -3, 1])]
    halves, M = half_way(T, anchored)
    assert len(halves) == 2
    for H in halves:
        np.testing.assert_allclose(M @ H @ H, T, atol=1e-12)
    np.testing.assert_allclose(M, np.eye(4) if anchored else T[0])


def test_a_tube_can_be_bent_right_back_in_small_steps() -> None:
    P, faces, fixed, tip, _ = bent_tube(0)
    deformer = Deformer(P, faces, fixed, [tip])
    steps = [motion(rotation([0, 0, 1], a)) for a in np.arange(150.0, 180.0)]
    poses = np.stack([deformer.pose([T], 4) for T in steps])
    surface = np.linalg.norm(np.diff(poses, axis=0), axis=2).max(axis=1)
    handle = np.linalg.norm(np.diff(poses[:, tip], axis=0), axis=2).max(axis=1)
    assert (surface < 1.5 * handle).all()


@pytest.mark.parametrize("degrees", [100, 150, 175])
def test_targets_of_a_large_turn_give_its_pose(degrees: float) -> None:
    P, faces, fixed, tip, T = bent_tube(degrees)
    deformer = Deformer(P, faces, fixed, [tip])
    targets = P[tip] @ T[:3, :3].T + T[:3, 3]
    np.testing.assert_allclose(deformer.solve(targets, 4), deformer.pose([T], 4), atol=1e-6)
