"""Laws of posing: equivariance, linearity, fixed points, and the ways to one answer."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest

from solver import ConstraintError, Deformer
from solver.geometry.bounding_box import diagonal
from solver.geometry.motions import motion, moved, rotation
from solver.measure.distortion import Distortion
from solver.types import FloatArray, IntArray
from tests.solver import shapes

LEVELS = [0, 1, 3]
rng = np.random.default_rng(0)


@dataclass(frozen=True)
class Case:
    """A surface with a fixed end, two handles and a softness."""

    V: FloatArray
    F: IntArray
    fixed: IntArray
    handles: list[IntArray]
    softness: FloatArray

    def deformer(self, V: FloatArray | None = None, **changes: Any) -> Deformer:
        options = {"fixed": self.fixed, "handles": self.handles, "softness": self.softness}
        return Deformer(self.V if V is None else V, self.F, **{**options, **changes})

    @property
    def posed(self) -> list[FloatArray]:
        """A bold transform for each handle."""
        c = [self.V[h].mean(axis=0) for h in self.handles]
        return [
            motion(rotation([1, 2, 1], 100), [-1, 2, 1], c[0]),
            motion(rotation([0, 1, 3], -60), [0.5, 0, -1], c[1]),
        ]


def case(surface: shapes.Surface) -> Case:
    V, F = surface
    along = (V[:, 0] - V[:, 0].min()) / np.ptp(V[:, 0])
    middle = (along > 0.4) & (along < 0.65) & (V[:, 2] >= np.median(V[:, 2]))
    handles = [np.flatnonzero(along > 0.85), np.flatnonzero(middle)]
    softness = np.exp(-(((along - 0.3) / 0.1) ** 2))
    return Case(V, F, np.flatnonzero(along < 0.1), handles, softness)


CASES = {
    "tube": case(shapes.tube()),
    "bumpy plane": case(shapes.bumpy_plane()),
    "sphere": case(shapes.sphere()),
}


@pytest.fixture(params=[*CASES.values()], ids=[*CASES])
def arm(request: pytest.FixtureRequest) -> Case:
    chosen: Case = request.param
    return chosen


@pytest.mark.parametrize("rigid", LEVELS)
def test_moving_every_constraint_moves_the_result(arm: Case, rigid: int) -> None:
    deformer = arm.deformer(fixed=[], handles=[arm.fixed, *arm.handles])
    T = [np.eye(4), *arm.posed]
    M = motion(shapes.random_rotation(rng), 5 * rng.normal(size=3))
    X = deformer.pose([M @ t for t in T], rigid)
    np.testing.assert_allclose(X, moved(M, deformer.pose(T, rigid)), atol=1e-8)


@pytest.mark.parametrize(("rigid", "turn"), [(0, True), (1, True), (3, False)])
def test_moving_the_whole_scene_moves_the_result(arm: Case, rigid: int, turn: bool) -> None:
    R = shapes.random_rotation(rng) if turn else np.eye(3)
    M = motion(R, 5 * rng.normal(size=3))
    T = [M @ t @ np.linalg.inv(M) for t in arm.posed]
    V = moved(M, arm.V)
    # Lengths are measured in diagonals of the bounding box, and turning changes the box.
    same_length = 0.01 * diagonal(arm.V) / diagonal(V)
    X = arm.deformer(V, bending_length=same_length).pose(T, rigid)
    np.testing.assert_allclose(X, moved(M, arm.deformer().pose(arm.posed, rigid)), atol=1e-8)


@pytest.mark.parametrize("factor", [1e-6, 25.4, 1e6])
@pytest.mark.parametrize("rigid", LEVELS)
def test_scaling_the_file_scales_the_result(arm: Case, rigid: int, factor: float) -> None:
    T = [t.copy() for t in arm.posed]
    for t in T:
        t[:3, 3] *= factor
    X = arm.deformer(factor * arm.V).pose(T, rigid)
    expected = factor * arm.deformer().pose(arm.posed, rigid)
    np.testing.assert_allclose(X, expected, atol=1e-8 * factor)


@pytest.mark.parametrize("rigid", [0, 1])
@pytest.mark.parametrize("orientation", [True, False])
def test_pose_equals_solve_on_the_same_targets(arm: Case, rigid: int, orientation: bool) -> None:
    deformer = arm.deformer(orientation=orientation)
    pairs = zip(arm.posed, arm.handles, strict=True)
    targets = np.concatenate([moved(t, arm.V[h]) for t, h in pairs])
    X = deformer.solve(targets, rigid)
    np.testing.assert_allclose(X, deformer.pose(arm.posed, rigid), atol=1e-8)


def test_the_linear_result_is_affine_in_the_transforms(arm: Case) -> None:
    deformer = arm.deformer()
    A, B = arm.posed, [np.eye(4), motion(rotation([1, 0, 0], 30), [0, 0, 3])]
    half = [0.25 * a + 0.75 * b for a, b in zip(A, B, strict=True)]
    X = 0.25 * deformer.pose(A) + 0.75 * deformer.pose(B)
    np.testing.assert_allclose(deformer.pose(half), X, atol=1e-11)
    G = 0.25 * deformer.frames(A) + 0.75 * deformer.frames(B)
    np.testing.assert_allclose(deformer.frames(half), G, atol=1e-11)


def test_the_rest_pose_is_a_fixed_point(arm: Case) -> None:
    deformer = arm.deformer()
    rest = [np.eye(4)] * 2
    np.testing.assert_array_equal(deformer.pose(rest), arm.V)
    for rigid in (1, 2, 5):
        np.testing.assert_allclose(deformer.pose(rest, rigid), arm.V, atol=1e-11)
        targets = arm.V[np.concatenate(arm.handles)]
        np.testing.assert_allclose(deformer.solve(targets, rigid), arm.V, atol=1e-11)
    np.testing.assert_array_equal(deformer.frames(rest), np.tile(np.eye(3), (len(arm.F), 1, 1)))


@pytest.mark.parametrize("rigid", LEVELS)
@pytest.mark.parametrize("orientation", [True, False])
def test_constraints_are_met(arm: Case, rigid: int, orientation: bool) -> None:
    deformer = arm.deformer(orientation=orientation)
    X = deformer.pose(arm.posed, rigid)
    np.testing.assert_array_equal(X[arm.fixed], arm.V[arm.fixed])
    for t, h in zip(arm.posed, arm.handles, strict=True):
        np.testing.assert_allclose(X[h], moved(t, arm.V[h]), atol=1e-12)
    held = np.concatenate(arm.handles)
    targets = arm.V[held] + rng.normal(size=(len(held), 3))
    Y = deformer.solve(targets, rigid)
    np.testing.assert_array_equal(Y[arm.fixed], arm.V[arm.fixed])
    np.testing.assert_allclose(Y[held], targets, atol=1e-12)


def test_frames_inside_a_handle_take_its_rotation(arm: Case) -> None:
    G = arm.deformer().frames(arm.posed)
    for t, h in zip(arm.posed, arm.handles, strict=True):
        inside = np.isin(arm.F, h).all(axis=1)
        assert inside.any()
        np.testing.assert_allclose(G[inside], np.tile(t[:3, :3], (inside.sum(), 1, 1)), atol=1e-12)


def test_rotations_keep_more_of_the_lengths_than_linear_frames(arm: Case) -> None:
    deformer = arm.deformer(handles=arm.handles[:1], softness=None)
    distortion = Distortion(arm.V, arm.F)
    linear, rigid = (distortion.strain(deformer.pose(arm.posed[:1], k)).rms for k in (0, 1))
    assert rigid < linear


def test_a_deformer_does_not_see_what_happens_to_its_arguments() -> None:
    arm = CASES["tube"]
    V, softness, handle = arm.V.copy(), arm.softness.copy(), arm.handles[0].copy()
    deformer = Deformer(V, arm.F, arm.fixed, [handle, arm.handles[1]], softness)
    V[:], softness[:], handle[:] = 0, 0, 0
    X = deformer.rebind(bending_length=0.01).pose(arm.posed)
    np.testing.assert_allclose(X, arm.deformer().pose(arm.posed), atol=1e-12)
    X[:] = 0
    np.testing.assert_allclose(deformer.pose([np.eye(4)] * 2), arm.V, atol=1e-12)


def test_without_handles_the_surface_rests() -> None:
    V, F = shapes.sphere(1)
    for deformer in (Deformer(V, F), Deformer(V, F, [0, 1])):
        for rigid in LEVELS:
            np.testing.assert_allclose(deformer.pose([], rigid), V, atol=1e-12)
            np.testing.assert_allclose(deformer.solve(np.empty((0, 3)), rigid), V, atol=1e-12)
        assert deformer.handle_count == 0


def test_everything_in_handles_leaves_nothing_to_solve() -> None:
    V, F = shapes.sphere(1)
    T = motion(rotation([1, 1, 0], 80), [1, 2, 3])
    deformer = Deformer(V, F, handles=[np.arange(len(V))])
    for rigid in LEVELS:
        np.testing.assert_allclose(deformer.pose([T], rigid), moved(T, V), atol=1e-12)


@pytest.mark.parametrize(
    ("transforms", "rigid", "text"),
    [
        ([np.eye(4)], 0, "expected 2 transforms, one for each handle, got 1"),
        ([np.eye(4), np.eye(3)], 0, "transform 1 must be (4, 4) with last row 0 0 0 1"),
        ([2 * np.eye(4), np.eye(4)], 0, "transform 0 must be (4, 4) with last row 0 0 0 1"),
        ([np.full((4, 4), np.nan), np.eye(4)], 0, "transform 0 must be finite"),
        ([np.eye(4), "T"], 0, "transform 1 must be numbers"),
        ([np.eye(4)] * 2, -1, "rigid must be an integer from 0 to 1000, got -1"),
        ([np.eye(4)] * 2, 0.5, "rigid must be an integer from 0 to 1000, got 0.5"),
        ([np.eye(4)] * 2, True, "rigid must be an integer from 0 to 1000, got True"),
    ],
)
def test_refuses_poses_that_make_no_sense(transforms: Any, rigid: Any, text: str) -> None:
    with shapes.refuses(ConstraintError, text):
        CASES["tube"].deformer().pose(transforms, rigid)


def test_refuses_targets_that_make_no_sense() -> None:
    arm = CASES["tube"]
    count = len(np.concatenate(arm.handles))
    with shapes.refuses(ConstraintError, f"targets must be ({count}, 3), got (1, 3)"):
        arm.deformer().solve([[0, 0, 0]])
    with shapes.refuses(ConstraintError, "targets must be finite"):
        arm.deformer().solve(np.full((count, 3), np.inf))
    with shapes.refuses(ConstraintError, "rigid must be an integer"):
        arm.deformer().solve(np.zeros((count, 3)), rigid=-2)
