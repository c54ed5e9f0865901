"""Softness learned from poses: what made them is found, and bad examples are refused."""

from __future__ import annotations

import pickle
from functools import cache

import numpy as np
import pytest

from solver import Deformer, MeshError, learn_softness, load_mesh
from solver.errors import ConstraintError, MaterialError, SolverError
from solver.geometry.motions import motion, moved, rotation
from solver.softness.falloff import falloff
from solver.types import FloatArray
from tests.solver import shapes

V, F = shapes.tube(32, 10)
X = V[:, 0]
FIXED, HANDLE = np.flatnonzero(X < 0.8), np.flatnonzero(X > 7.2)
#: A hinge that is nearer to the fixed end than to the handle.
JOINT = 2.8
SOFT = falloff((X - JOINT) / 1.2)


def turn(axis: list[float], degrees: float) -> FloatArray:
    """What turns the end about the joint."""
    return motion(rotation(axis, degrees), centre=[JOINT, 0, 0])


@cache
def poses() -> tuple[FloatArray, ...]:
    """The tube bent in its hinge, by the tool itself."""
    deformer = Deformer(V, F, FIXED, [HANDLE], SOFT)
    turns = turn([0, 0, 1], 60), turn([0, 1, 0], -50)
    return tuple(deformer.pose([T], 8) for T in turns)


def learned(**options: object) -> FloatArray:
    return learn_softness(V, F, poses(), FIXED, [HANDLE], **options)  # type: ignore[arg-type]


def rms(A: FloatArray, B: FloatArray) -> float:
    return float(np.sqrt(((A - B) ** 2).sum(axis=1).mean()))


def test_the_softness_that_made_the_poses_is_found() -> None:
    s = learned()
    assert s.shape == (len(V),)
    assert s.min() >= 0
    assert s.max() <= 1
    free = (X >= 0.8) & (X <= 7.2)
    assert np.corrcoef(s[free], SOFT[free])[0, 1] > 0.9
    assert abs(X[s.argmax()] - JOINT) < 0.6


def test_a_pose_that_was_not_shown_comes_nearer() -> None:
    T = [turn([0, 1, 1], 70)]
    wanted = Deformer(V, F, FIXED, [HANDLE], SOFT).pose(T, 8)
    away = [rms(Deformer(V, F, FIXED, [HANDLE], s).pose(T, 8), wanted) for s in (None, learned())]
    assert away[1] < 0.3 * away[0]


def test_the_same_examples_teach_the_same() -> None:
    np.testing.assert_array_equal(learned(), learned())


def test_size_place_and_turn_of_the_examples_do_not_count() -> None:
    T = motion(rotation([1, 2, 3], 130), [30.0, -20.0, 5.0])
    others = [moved(T, 0.01 * P) for P in poses()]
    s = learn_softness(V, F, others, FIXED, [HANDLE])
    np.testing.assert_allclose(s, learned(), atol=0.02)


def test_what_is_held_is_found_where_it_is_not_given() -> None:
    s = learn_softness(V, F, poses())
    assert abs(X[s.argmax()] - JOINT) < 0.9
    near = X < 5  # beyond, the tube is held: softness there does nothing
    assert np.corrcoef(s[near], SOFT[near])[0, 1] > 0.8


def test_seams_do_not_count() -> None:
    corners = F.ravel()  # every triangle apart
    apart = np.arange(len(corners)).reshape(-1, 3)
    fixed, handle = (np.flatnonzero(np.isin(corners, held)) for held in (FIXED, HANDLE))
    s = learn_softness(V[corners], apart, [P[corners] for P in poses()], fixed, [handle])
    np.testing.assert_allclose(s, learned()[corners], atol=0.05)


def test_fine_meshes_are_learned_on_a_coarse_one() -> None:
    fine, faces = shapes.tube(80, 24)
    x = fine[:, 0]
    held = np.flatnonzero(x < 0.8), np.flatnonzero(x > 7.2)
    soft = falloff((x - JOINT) / 1.2)
    P = Deformer(fine, faces, held[0], [held[1]], soft).pose([turn([0, 0, 1], 60)], 6)
    s = learn_softness(fine, faces, [P], held[0], [held[1]])
    assert abs(x[s.argmax()] - JOINT) < 0.6
    assert np.corrcoef(s, soft)[0, 1] > 0.8


def test_progress_grows_to_the_end() -> None:
    told: list[float] = []
    learned(progress=told.append)
    assert told == sorted(told)
    assert told[-1] == 1.0
    assert len(told) > 3


def test_it_ends_with_the_best_so_far_when_it_is_told_to() -> None:
    told: list[float] = []

    def after_three(fraction: float) -> bool:
        told.append(fraction)
        return len(told) == 3

    s = learned(progress=after_three)
    assert len(told) == 3
    assert s.std() > 0.01
    assert 0 <= s.min() <= s.max() <= 1


def test_it_is_cancelled_where_progress_raises() -> None:
    def cancel(fraction: float) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        learned(progress=cancel)


def test_another_process_can_do_it() -> None:
    assert pickle.loads(pickle.dumps(learn_softness)) is learn_softness


def with_a_hole() -> FloatArray:
    P = poses()[0].copy()
    P[3, 1] = np.nan
    return P


@pytest.mark.parametrize(
    ("examples", "error", "text"),
    [
        ([], MeshError, "no poses to learn from"),
        ([poses()[0][:-1]], MeshError, "pose 0 must be (320, 3)"),
        ([poses()[0], with_a_hole()], MeshError, "pose 1 must be finite"),
        ([poses()[0], 3 * V + 1], MeshError, "pose 1 shows no motion"),
        ([np.zeros_like(V)], MeshError, "pose 0 has no size"),
    ],
)
def test_bad_examples_are_refused(
    examples: list[FloatArray], error: type[SolverError], text: str
) -> None:
    with shapes.refuses(error, text):
        learn_softness(V, F, examples, FIXED, [HANDLE])


def test_what_holds_and_the_material_are_checked() -> None:
    with shapes.refuses(ConstraintError, "handle 0 names vertex 320"):
        learn_softness(V, F, poses(), FIXED, [[320]])
    with shapes.refuses(ConstraintError, "both fixed and in handle 0"):
        learn_softness(V, F, poses(), FIXED, [FIXED])
    with shapes.refuses(MaterialError, "unknown material"):
        learned(material="steel")


def test_poses_without_a_rigid_end_need_handles() -> None:
    rng = np.random.default_rng(0)
    with shapes.refuses(ConstraintError, "no end that moves rigidly"):
        learn_softness(V, F, [V + rng.normal(size=V.shape)])


def test_an_animal_is_taught_by_its_poses() -> None:
    rest = load_mesh(shapes.shared("cat/cat-reference.obj"))
    examples = [load_mesh(shapes.shared(f"cat/cat-0{k}.obj")).vertices for k in (1, 3)]
    s = learn_softness(rest.vertices, rest.faces, examples)
    assert s.shape == (len(rest.vertices),)
    assert s.max() > 0.5 > 0.1 > s.min()
