"""The rotation a dragged handle takes by itself."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from solver import ConstraintError, Deformer
from solver.geometry.bounding_box import diagonal
from solver.geometry.motions import motion, moved, rotation
from solver.types import FloatArray
from tests.solver import shapes
from tests.solver.definition import Definition, resolved, stack

V, F = shapes.tube(16, 8)
FIXED = np.flatnonzero(V[:, 0] < 1)
TIP, SIDE = np.flatnonzero(V[:, 0] > 7), np.flatnonzero((abs(V[:, 0] - 4) < 0.4) & (V[:, 1] > 0.5))
ENERGY = Definition(V, F, resolved(V, F))


def energy(deformer: Deformer, T: list[FloatArray]) -> float:
    return ENERGY.energy(stack(deformer.pose(T), deformer.frames(T)))


SCENES: dict[str, tuple[Deformer, int, list[FloatArray]]] = {
    "one handle": (Deformer(V, F, FIXED, [TIP]), 0, [np.eye(4)]),
    "another handle posed": (
        Deformer(V, F, FIXED, [SIDE, TIP]),
        1,
        [motion(rotation([1, 0, 1], 50), [0, 1, 1], V[SIDE].mean(axis=0)), np.eye(4)],
    ),
    "positions only": (Deformer(V, F, FIXED, [TIP], orientation=False), 0, [np.eye(4)]),
    "a soft handle": (Deformer(V, F, FIXED).grab(V[:, 0] > 6), 0, [np.eye(4)]),
    "a soft beside a hard one": (
        Deformer(V, F, FIXED, [TIP]).grab(np.exp(-((V[:, 0] - 4) ** 2))),
        1,
        [motion(rotation([0, 0, 1], 40), [0, 1, 0], V[TIP].mean(axis=0)), np.eye(4)],
    ),
    "a hard beside a soft one": (
        Deformer(V, F, FIXED, [TIP]).grab(np.exp(-((V[:, 0] - 4) ** 2))),
        0,
        [np.eye(4), motion(rotation([0, 0, 1], 20), [0, 0.5, 0.5], [4, 0, 0])],
    ),
}


@pytest.mark.parametrize("name", SCENES)
def test_no_rotation_has_less_energy(name: str) -> None:
    deformer, handle, T = SCENES[name]
    rng = np.random.default_rng(0)
    grabbed, target = np.array([7.5, 1, 0.2]), np.array([4.0, 5, 2])
    best = deformer.orient(handle, grabbed, target, T)
    np.testing.assert_allclose(moved(best, grabbed), target, atol=1e-9)
    np.testing.assert_allclose(best[:3, :3] @ best[:3, :3].T, np.eye(3), atol=1e-12)
    assert np.linalg.det(best) > 0

    def turned(R: FloatArray) -> float:
        posed = list(T)
        posed[handle] = motion(R, target - grabbed, grabbed)
        return energy(deformer, posed)

    least = turned(best[:3, :3])
    others = [shapes.random_rotation(rng) for _ in range(1000)]
    near = [rotation(rng.normal(size=3), 0.5) @ best[:3, :3] for _ in range(50)]
    assert least < min(map(turned, others))
    assert least < min(map(turned, near))


@pytest.mark.parametrize("degrees", [90, 179.9, 180])
def test_a_tip_carried_around_turns_with_the_limb(degrees: float) -> None:
    deformer = Deformer(V, F, FIXED, [TIP])
    root, tip = np.array([1.0, 0, 0]), np.array([8.0, 0, 0])
    target = root + rotation([0, 0, 1], degrees) @ (tip - root)
    T = deformer.orient(0, tip, target, [np.eye(4)])
    assert np.isfinite(deformer.pose([T], rigid=1)).all()
    turned = np.degrees(np.arctan2(T[1, 0], T[0, 0])) % 360
    assert turned == pytest.approx(degrees, abs=10)


def test_a_point_left_in_place_leaves_the_handle_in_place() -> None:
    for deformer, handle, T in SCENES.values():
        rest = [np.eye(4)] * len(T)
        best = deformer.orient(handle, [7, 0, 0], [7, 0, 0], rest)
        np.testing.assert_allclose(best, np.eye(4), atol=1e-6)


@pytest.mark.parametrize("where", [0, 1, 2])
def test_a_handle_that_nothing_resists_keeps_its_rotation(where: int) -> None:
    loose = [
        Deformer(V, F, [], [TIP]),  # nothing is fixed
        Deformer(V, F, [], [np.arange(len(V))]),  # nothing is free
        Deformer(V, F).grab(np.ones(len(V))),  # a component carried whole
    ][where]
    R = rotation([1, 2, 3], 77)
    T = loose.orient(0, V[TIP[0]], [10, 10, 10], [motion(R, [3, 4, 5])])
    np.testing.assert_allclose(T[:3, :3], R, atol=1e-9)
    np.testing.assert_allclose(moved(T, V[TIP[0]]), [10, 10, 10], atol=1e-9)


def test_the_answer_does_not_depend_on_where_the_handle_is_now() -> None:
    deformer = Deformer(V, F, FIXED, [TIP])
    R = motion(rotation([1, 2, 3], 120), [1, 2, 3])
    one, other = (deformer.orient(0, V[TIP[0]], [5, 4, 3], [T]) for T in (np.eye(4), R))
    np.testing.assert_allclose(one, other, atol=1e-12)


def test_turning_the_scene_turns_the_answer() -> None:
    rng = np.random.default_rng(1)
    M = motion(shapes.random_rotation(rng), rng.normal(size=3))
    grabbed, target = V[TIP[0]], np.array([5.0, 4, 3])
    here = Deformer(V, F, FIXED, [TIP]).orient(0, grabbed, target, [np.eye(4)])
    turned = moved(M, V)
    # Lengths are measured in diagonals of the bounding box, and turning changes the box.
    same_length = 0.01 * diagonal(V) / diagonal(turned)
    deformer = Deformer(turned, F, FIXED, [TIP], bending_length=same_length)
    there = deformer.orient(0, moved(M, grabbed), moved(M, target), [np.eye(4)])
    np.testing.assert_allclose(there, M @ here @ np.linalg.inv(M), atol=1e-8)


@pytest.mark.parametrize(
    ("arguments", "text"),
    [
        ((1, [0, 0, 0], [1, 1, 1], [np.eye(4)]), "handle must be 0 to 0, got 1"),
        ((-1, [0, 0, 0], [1, 1, 1], [np.eye(4)]), "handle must be 0 to 0, got -1"),
        ((0, [0, 0], [1, 1, 1], [np.eye(4)]), "grabbed must be (3,), got (2,)"),
        ((0, [0, 0, 0], [1, 1, np.inf], [np.eye(4)]), "target must be finite"),
        ((0, [0, 0, 0], [1, 1, 1], []), "expected 1 transforms"),
    ],
)
def test_refuses_what_makes_no_sense(arguments: Any, text: str) -> None:
    with shapes.refuses(ConstraintError, text):
        Deformer(V, F, FIXED, [TIP]).orient(*arguments)


@pytest.mark.parametrize("name", SCENES)
def test_no_place_of_a_turned_handle_has_less_energy(name: str) -> None:
    deformer, handle, T = SCENES[name]
    rng = np.random.default_rng(1)
    turned = [np.array(one) for one in T]
    turned[handle] = motion(rotation([0, 1, 2], 70), [3, 1, -2], V[TIP].mean(axis=0))
    best = deformer.drag_model.place([handle], turned)
    np.testing.assert_array_equal(best[handle, :3, :3], turned[handle][:3, :3])
    np.testing.assert_array_equal(np.delete(best, handle, 0), np.delete(turned, handle, 0))
    least = energy(deformer, list(best))
    for length in (1e-3, 0.1, 5.0):
        for _ in range(20):
            shifted = best.copy()
            shifted[handle, :3, 3] += length * rng.normal(size=3)
            assert energy(deformer, list(shifted)) > least


def test_handles_find_their_places_together() -> None:
    deformer = Deformer(V, F, FIXED, [SIDE, TIP])
    T = [motion(rotation([0, 0, 1], 30), [0, 3, 0]), motion(rotation([0, 0, 1], 60), [2, 0, 1])]
    both = deformer.drag_model.place([0, 1], T)
    for handle in (0, 1):  # neither can do better alone
        np.testing.assert_allclose(deformer.drag_model.place([handle], both), both, atol=1e-9)
    assert energy(deformer, list(both)) < energy(deformer, list(T))


def test_a_handle_that_nothing_resists_keeps_its_place() -> None:
    T = motion(rotation([0, 0, 1], 30), [0, 3, 0])
    loose = Deformer(V, F, [], [TIP]).drag_model
    np.testing.assert_allclose(loose.place([0], [T]), [T], atol=1e-9)
    rest = Deformer(V, F, FIXED, [TIP]).drag_model.place([0], [np.eye(4)])
    np.testing.assert_allclose(rest, [np.eye(4)], atol=1e-9)


def test_a_limb_whose_tip_is_turned_bends_to_an_arc() -> None:
    """Bent by a turn alone, it has the same curvature everywhere: its chord turns by half."""
    deformer = Deformer(V, F, FIXED, [TIP])
    (T,) = deformer.drag_model.place([0], [motion(rotation([0, 0, 1], 20))])
    root, tip = np.array([1.0, 0, 0]), np.array([7.0, 0, 0])
    x, y, z = T[:3, :3] @ tip + T[:3, 3] - root
    assert np.degrees(np.arctan2(y, x)) == pytest.approx(10, abs=1)
    assert abs(z) < 1e-6


def test_only_handles_that_there_are_can_be_placed() -> None:
    model = Deformer(V, F, FIXED, [TIP]).drag_model
    with pytest.raises(ConstraintError, match=r"handles must be 0 to 0, got \[1\]"):
        model.place([1], [np.eye(4)])
