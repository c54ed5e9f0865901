"""Laws of a Deformer with coarse frames: what holds exactly, and how near the rest comes."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from solver import ConstraintError, Deformer, MeshError
from solver.geometry.bounding_box import diagonal
from solver.geometry.motions import motion, moved, rotation
from solver.measure.distortion import Distortion
from solver.types import FloatArray
from tests.solver import shapes

LEVELS = [0, 1, 3]
V, F = shapes.tube(80, 24)
X0 = V[:, 0]
FIXED, HANDLE = np.flatnonzero(X0 < 1), np.flatnonzero(X0 > 7)
MIDDLE = np.flatnonzero((np.abs(X0 - 4) < 0.4) & (V[:, 2] > 0))
BEND = motion(rotation([0, 1, 0], 70), [-1.0, 0.0, -2.5], [7.5, 0, 0])
LIFT = motion(rotation([1, 0, 0], 10), [0.0, 0.1, 0.6], [4, 0, 1])
SOFTNESS = np.exp(-((X0 - 3) ** 2))
WEIGHTS = np.exp(-((V - [4.0, 0, 1]) ** 2).sum(axis=1) / 0.3) * (np.abs(X0 - 4) < 1.5)
COUNT = 500


def deformer(**changes: Any) -> Deformer:
    options: dict[str, Any] = {"fixed": FIXED, "handles": [HANDLE, MIDDLE], "coarse": COUNT}
    return Deformer(V, F, **{**options, **changes})


def rms(X: FloatArray, Y: FloatArray) -> float:
    return float(np.sqrt(((X - Y) ** 2).sum(axis=1).mean())) / diagonal(V)


@pytest.mark.parametrize("level", LEVELS)
@pytest.mark.parametrize("orientation", [True, False])
def test_held_vertices_are_exact_and_fixed_ones_to_the_last_bit(
    level: int, orientation: bool
) -> None:
    X = deformer(orientation=orientation).pose([BEND, LIFT], level)
    assert np.array_equal(X[FIXED], V[FIXED])
    for vertices, T in ((HANDLE, BEND), (MIDDLE, LIFT)):
        assert np.abs(X[vertices] - moved(T, V[vertices])).max() < 1e-13 * diagonal(V)


@pytest.mark.parametrize("level", LEVELS)
def test_one_rigid_motion_of_everything_that_holds_moves_the_whole(level: int) -> None:
    T = motion(rotation([1, 2, 3], 50), [1.0, 2, 3])
    held = Deformer(V, F, (), [FIXED, HANDLE, MIDDLE], SOFTNESS, coarse=COUNT)
    assert np.abs(held.pose([T] * 3, level) - moved(T, V)).max() < 1e-10


def test_one_affine_motion_of_everything_that_holds_moves_the_whole() -> None:
    T = np.eye(4)
    T[:3] = [[1.2, 0.3, 0, 1], [0.1, 0.8, 0.2, 2], [0, -0.3, 1.1, 3]]
    held = Deformer(V, F, (), [FIXED, HANDLE], coarse=COUNT)
    assert np.abs(held.pose([T, T]) - moved(T, V)).max() < 1e-10
    assert np.abs(held.frames([T, T]) - T[:3, :3]).max() < 1e-10


@pytest.mark.parametrize("level", LEVELS)
def test_at_rest_nothing_moves(level: int) -> None:
    X = deformer(softness=SOFTNESS).pose([np.eye(4)] * 2, level)
    assert np.abs(X - V).max() < 1e-13 * diagonal(V)


@pytest.mark.parametrize("level", LEVELS)
def test_targets_of_a_rigid_motion_are_that_motion(level: int) -> None:
    targets = np.concatenate([moved(BEND, V[HANDLE]), moved(LIFT, V[MIDDLE])])
    bound = deformer()
    assert np.abs(bound.solve(targets, level) - bound.pose([BEND, LIFT], level)).max() < 1e-9
    assert np.abs(bound.solve(targets, level)[np.r_[HANDLE, MIDDLE]] - targets).max() < 1e-13


@pytest.mark.parametrize("level", LEVELS)
def test_any_targets_are_reached(level: int) -> None:
    targets = V[np.r_[HANDLE, MIDDLE]] + np.random.default_rng(0).normal(size=(1, 3)) * 0.1
    targets = targets + 0.02 * np.sin(5 * targets[:, ::-1])
    assert np.abs(deformer().solve(targets, level)[np.r_[HANDLE, MIDDLE]] - targets).max() < 1e-13


@pytest.mark.parametrize("level", LEVELS)
def test_a_grabbed_region_takes_its_transform_in_the_mean(level: int) -> None:
    grabbed = deformer(handles=[HANDLE]).grab(WEIGHTS)
    X = grabbed.pose([BEND, LIFT], level)
    J = np.column_stack([V, np.ones(len(V))])
    lacking = (WEIGHTS[:, None] * J).T @ (X - moved(LIFT, V))
    assert np.abs(lacking).max() < 1e-8 * WEIGHTS.sum()


def test_a_rebind_is_a_bind_and_keeps_grabs() -> None:
    transforms = [BEND, LIFT, motion(rotation([0, 1, 0], 5), [0.0, 0, 0.2], [4, 0, 1])]
    early, late = deformer().grab(WEIGHTS), deformer(softness=SOFTNESS)
    for level in LEVELS:
        one = early.rebind(softness=SOFTNESS).pose(transforms, level)
        assert np.abs(one - late.grab(WEIGHTS).pose(transforms, level)).max() < 1e-12
    other = deformer(handles=[MIDDLE]).rebind(handles=[HANDLE, MIDDLE])
    assert np.abs(other.pose([BEND, LIFT], 3) - deformer().pose([BEND, LIFT], 3)).max() < 1e-12


@pytest.mark.parametrize("level", LEVELS)
def test_as_many_coarse_vertices_as_there_are_is_the_exact_solution(level: int) -> None:
    exact = deformer(coarse=None)
    X = exact.pose([BEND, LIFT], level)
    assert np.array_equal(deformer(coarse=len(V)).pose([BEND, LIFT], level), X)
    assert np.array_equal(deformer().rebind(coarse=None).pose([BEND, LIFT], level), X)
    back = exact.grab(WEIGHTS).rebind(coarse=COUNT).pose([BEND, LIFT, np.eye(4)], level)
    here = deformer().grab(WEIGHTS).pose([BEND, LIFT, np.eye(4)], level)
    assert np.abs(back - here).max() < 1e-12


def test_it_comes_near_the_exact_solution_in_place_lengths_and_bends() -> None:
    exact, coarse = deformer(coarse=None, handles=[HANDLE]), deformer(handles=[HANDLE])
    distortion = Distortion(V, F)
    free = np.ones(len(V), dtype=bool)
    free[np.r_[FIXED, HANDLE]] = False
    bends = free[distortion.hinges].any(axis=1)
    for level in (1, 4):
        X, Y = exact.pose([BEND], level), coarse.pose([BEND], level)
        assert rms(X, Y) < 0.005
        assert distortion.strain(Y, free).rms < 1.05 * distortion.strain(X, free).rms
        one, two = distortion.dihedral(X, free), distortion.dihedral(Y, free)
        assert two.rms < 1.15 * one.rms
        assert two.elements[bends].max() < 1.25 * one.elements[bends].max()


def test_a_handle_turns_by_itself_as_it_does_exactly() -> None:
    at, to = np.array([7.5, 0, 0]), np.array([7.0, 0, 3.0])
    one, two = (d.orient(0, at, to, [np.eye(4)] * 2) for d in (deformer(), deformer(coarse=None)))
    assert np.abs((one @ [*at, 1.0])[:3] - to).max() < 1e-12
    cosine = (np.trace(one[:3, :3] @ two[:3, :3].T) - 1) / 2
    assert np.degrees(np.arccos(np.clip(cosine, -1, 1))) < 3


def test_frames_are_near_the_exact_ones() -> None:
    one, two = (d.frames([BEND, LIFT]) for d in (deformer(), deformer(coarse=None)))
    assert one.shape == two.shape
    assert np.sqrt(((one - two) ** 2).mean()) < 0.03


def test_gains_of_edges_are_carried() -> None:
    edges = np.array([(a, b) for a, b in F[:, :2] if abs(X0[a] - 3) < 1])
    gains = edges, np.full(len(edges), 0.1), np.ones(len(edges))
    one, two = (
        deformer(handles=[HANDLE], coarse=count, edge_gains=gains).pose([BEND], 3)
        for count in (COUNT, None)
    )
    assert rms(one, two) < 0.01


def test_no_handle_is_lost_however_small() -> None:
    tiny = [HANDLE[:1], HANDLE[1:2], HANDLE[2:3]]
    bound = deformer(handles=tiny, coarse=100)
    transforms = [motion(np.eye(3), [0.0, 0.1 * k, 0.2]) for k in range(3)]
    for level in LEVELS:
        X = bound.pose(transforms, level)
        for vertices, T in zip(tiny, transforms, strict=True):
            assert np.abs(X[vertices] - moved(T, V[vertices])).max() < 1e-13 * diagonal(V)


def test_what_nothing_holds_stays_and_what_is_near_follows() -> None:
    ball = shapes.sphere(3)[0] * 0.3, shapes.sphere(3)[1]
    surfaces = [(V, F), (ball[0] + [7.5, 0, 1.35], ball[1]), (ball[0] + [20.0, 0, 0], ball[1])]
    starts = np.cumsum([0, *(len(P) for P, _ in surfaces)])
    P, T = shapes.together(*surfaces)
    bound = Deformer(P, T, FIXED, [HANDLE], coarse=600)
    near, far = slice(starts[1], starts[2]), slice(starts[2], starts[3])
    for level in LEVELS:
        X = bound.pose([BEND], level)
        assert np.array_equal(X[far], P[far])
        assert np.abs(X[near] - moved(BEND, P[near])).max() < 0.02 * diagonal(P)


def test_a_seam_stays_closed() -> None:
    half = F[X0[F].max(axis=1) <= 4.2]
    rest = F[X0[F].max(axis=1) > 4.2]
    cut = np.concatenate([half, rest + len(V)])
    used = np.unique(cut)
    P, T = np.vstack([V, V])[used], np.searchsorted(used, cut)
    x = P[:, 0]
    bound = Deformer(P, T, np.flatnonzero(x < 1), [np.flatnonzero(x > 7)], coarse=COUNT)
    X = bound.pose([BEND], 3)
    _, inverse = np.unique(P, axis=0, return_inverse=True)
    copies = np.argsort(inverse, kind="stable")
    twice = np.flatnonzero(np.diff(inverse[copies]) == 0)
    assert len(twice) > 0
    assert np.array_equal(X[copies[twice]], X[copies[twice + 1]])


@pytest.mark.parametrize("coarse", [0, -5, 2.5, True, "many"])
def test_a_count_must_be_positive_and_whole(coarse: Any) -> None:
    with shapes.refuses(MeshError, "coarse must be None or a positive integer"):
        deformer(coarse=coarse)


def test_mistakes_are_named_as_they_are_exactly() -> None:
    with shapes.refuses(ConstraintError, "handle 0 names vertex"):
        deformer(handles=[[len(V)]])
    with shapes.refuses(ConstraintError, "grab weights must be"):
        deformer().grab(np.ones(COUNT))
    with shapes.refuses(ConstraintError, "grab weights select no vertex"):
        deformer().grab(np.zeros(len(V)))
    with shapes.refuses(ConstraintError, "targets must be"):
        deformer().solve(np.zeros((3, 3)))
