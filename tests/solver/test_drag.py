"""A drag with a memory: turns add up, small moves stay small, and nothing else differs."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import pairwise

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from solver import ConstraintError, Deformer
from solver.geometry.motions import motion, moved, rotation, rotation_about
from solver.geometry.procrustes import rigid_fit
from solver.measure.quality import broken_triangles
from solver.types import FloatArray, IntArray
from tests.solver import shapes

RINGS, AROUND = 40, 16
X_AXIS = [1, 0, 0]
FAR = np.array([8.0, 0, 0])


def tube() -> tuple[FloatArray, IntArray, IntArray, IntArray]:
    """A tube of length 8 along x, its fixed and its moved end."""
    V, F = shapes.tube(RINGS, AROUND)
    return V, F, np.flatnonzero(V[:, 0] < 0.5), np.flatnonzero(V[:, 0] > 7.5)


def deformer(coarse: int | None = None) -> Deformer:
    V, F, fixed, tip = tube()
    return Deformer(V, F, fixed, [tip], coarse=coarse)


def twist(degrees: float) -> list[FloatArray]:
    return [rotation_about(X_AXIS, degrees)]


def bend(degrees: float) -> list[FloatArray]:
    return [motion(rotation([0, 0, 1], degrees), centre=[4, 0, 0])]


def turn_along(X: FloatArray) -> float:
    """Degrees about x that rings of the tube turn by, from one to the next, in all."""
    rings = np.stack([tube()[0], X], axis=1).reshape(RINGS, AROUND, 2, 3)
    R = [rigid_fit(ring[:, 0], ring[:, 1]) for ring in rings]
    steps = [Rotation.from_matrix(b @ a.T).as_rotvec()[0] for a, b in pairwise(R)]
    return float(np.degrees(sum(steps)))


def farthest(a: FloatArray, b: FloatArray) -> float:
    return float(np.linalg.norm(a - b, axis=1).max())


@pytest.mark.parametrize("coarse", [None, 250])
@pytest.mark.parametrize("rigid", [1, 4])
def test_a_twist_shows_all_its_turns(rigid: int, coarse: int | None) -> None:
    V, F, fixed, tip = tube()
    drag = deformer(coarse).drag()
    free = np.ones(len(V), dtype=bool)
    free[np.concatenate([fixed, tip])] = False
    for degrees in range(0, 375, 15):
        X = drag.move(twist(degrees), rigid)
        assert turn_along(X) == pytest.approx(degrees, abs=0.01)
        assert broken_triangles(V, F, free, X) == 0
    assert turn_along(deformer(coarse).pose(twist(360), rigid)) == pytest.approx(0, abs=0.01)


def test_two_turns_and_back() -> None:
    drag = deformer().drag()
    for degrees in range(0, 735, 15):
        X = drag.move(twist(degrees))
    assert turn_along(X) == pytest.approx(720, abs=0.01)
    for degrees in range(720, -15, -15):
        X = drag.move(twist(degrees))
    np.testing.assert_allclose(drag.move(twist(0), 60), tube()[0], atol=1e-3)


@pytest.mark.parametrize("way", [twist, bend])
@pytest.mark.parametrize("coarse", [None, 250])
@pytest.mark.parametrize("rigid", [1, 4])
def test_small_moves_stay_small_beyond_half_a_turn(
    rigid: int, coarse: int | None, way: Callable[[float], list[FloatArray]]
) -> None:
    tip = tube()[3]
    drag = deformer(coarse).drag()
    X = drag.move(way(0), rigid)
    for degrees in range(5, 245, 5):
        before, X = X, drag.move(way(degrees), rigid)
        assert farthest(X, before) < 1.5 * farthest(X[tip], before[tip])


def test_without_a_memory_the_surface_swaps_sides() -> None:
    """That the steps above are small is the memory's doing."""
    soft, tip = deformer(), tube()[3]
    poses = [soft.pose(twist(degrees), 4) for degrees in range(170, 195, 5)]
    steps = [farthest(b, a) / farthest(b[tip], a[tip]) for a, b in pairwise(poses)]
    assert max(steps) > 5


@pytest.mark.parametrize("coarse", [None, 250])
@pytest.mark.parametrize("way", [twist, bend])
def test_small_turns_look_as_without_a_memory(
    way: Callable[[float], list[FloatArray]], coarse: int | None
) -> None:
    soft = deformer(coarse)
    drag = soft.drag()
    for degrees in range(0, 105, 15):
        X = drag.move(way(degrees), 4)
        assert farthest(X, soft.pose(way(degrees), 4)) < 0.02  # of a length of 8
        settled = soft.drag()
        settled.move(way(0.5 * degrees), 60)
        np.testing.assert_allclose(
            settled.move(way(degrees), 60), soft.pose(way(degrees), 60), atol=1e-3
        )


@pytest.mark.parametrize("coarse", [None, 250])
@pytest.mark.parametrize("rigid", [0, 1, 4])
def test_the_first_frame_is_the_pose(rigid: int, coarse: int | None) -> None:
    soft = deformer(coarse)
    for way in (twist(0), twist(140), bend(175)):
        np.testing.assert_array_equal(soft.drag().move(way, rigid), soft.pose(way, rigid))


def test_the_same_moves_give_the_same_answers() -> None:
    soft = deformer()
    one, other = soft.drag(), soft.drag()
    for degrees in (0, 100, 200, 190, 300):
        np.testing.assert_array_equal(one.move(bend(degrees)), other.move(bend(degrees)))


def test_a_long_move_is_several_short_ones() -> None:
    one, other = deformer().drag(), deformer().drag()
    for drag, stops in ((one, (0, 150, 300)), (other, range(0, 330, 30))):
        for degrees in stops:
            X = drag.move(twist(degrees))
        assert turn_along(X) == pytest.approx(300, abs=0.01)
    np.testing.assert_allclose(one.move(twist(300)), other.move(twist(300)), atol=1e-6)


def test_the_linear_level_has_no_memory_and_spoils_none() -> None:
    soft = deformer()
    one, other = soft.drag(), soft.drag()
    for degrees in range(0, 260, 20):
        one.move(twist(degrees))
        other.move(twist(degrees))
        linear = other.move(twist(degrees + 10), rigid=0)
        np.testing.assert_array_equal(linear, soft.pose(twist(degrees + 10)))
    np.testing.assert_array_equal(one.move(twist(260)), other.move(twist(260)))


def test_what_is_refused_is_not_remembered() -> None:
    one, other = deformer().drag(), deformer().drag()
    for drag in (one, other):
        drag.move(twist(20))
    with pytest.raises(ConstraintError, match="expected 1 transforms"):
        one.move([])
    with pytest.raises(ConstraintError, match="last row 0 0 0 1"):
        one.move([np.ones((4, 4))])
    with pytest.raises(ConstraintError, match="rigid must be an integer from 0"):
        one.move(twist(30), -1)
    np.testing.assert_array_equal(one.move(twist(40)), other.move(twist(40)))


def test_one_motion_of_everything_costs_nothing() -> None:
    V, F, one, other = tube()
    drag = Deformer(V, F, handles=[one, other]).drag()
    for degrees in range(0, 420, 20):
        T = rotation_about([1, 2, 3], degrees, [1, 1, 0])
        X = drag.move([T, T], 4)
        np.testing.assert_allclose(X, moved(T, V), atol=1e-4)


def around(radius: float, steps: int) -> Iterator[FloatArray]:
    """Targets of the tube's far end, once around where it is fixed, slightly off the plane."""
    for angle in np.linspace(0, 2 * np.pi, steps + 1):
        yield radius * np.array([np.cos(angle), np.sin(angle), 0.03 * np.sin(angle / 2)])


@pytest.mark.parametrize("reach", [7.6, 3.0])
def test_a_handle_turns_no_faster_than_the_hand_moves(reach: float) -> None:
    V, _, _, tip = tube()
    drag = deformer().drag()
    T = np.eye(4)
    for target in around(reach, 60):
        before, T = T, drag.orient(0, FAR, target, [T])
        np.testing.assert_allclose(moved(T, FAR[None])[0], target, atol=1e-9)
        step = np.linalg.norm(target - moved(before, FAR[None])[0])
        assert farthest(moved(T, V[tip]), moved(before, V[tip])) <= 2 * step + 1e-9


def test_what_is_asked_for_twice_is_not_turned_twice() -> None:
    drag = deformer().drag()
    T = drag.orient(0, FAR, [-1, 3, 1], [np.eye(4)])
    np.testing.assert_allclose(drag.orient(0, FAR, [-1, 3, 1], [T]), T, atol=1e-9)


def test_a_hand_that_comes_along_finds_the_best_rotation() -> None:
    soft = deformer()
    drag = soft.drag()
    T = rotation_about([0, 1, 1], 170, FAR)  # as badly turned as may be
    for target in around(7.0, 60):
        T = drag.orient(0, FAR, target, [T])
        best = soft.orient(0, FAR, target, [T])
    np.testing.assert_allclose(T, best, atol=1e-9)


@pytest.mark.parametrize("coarse", [None, 250])
def test_a_grab_has_a_memory_too(coarse: int | None) -> None:
    V, F, fixed, tip = tube()
    weights = np.zeros(len(V))
    weights[tip] = 1.0
    soft = Deformer(V, F, fixed, coarse=coarse).grab(weights)
    drag = soft.drag()
    X = drag.move(twist(0))
    for degrees in range(15, 375, 15):
        before, X = X, drag.move(twist(degrees))
        assert farthest(X, before) < 2 * 2 * np.sin(np.radians(7.5))
    T = drag.orient(0, FAR, FAR + [0, 1, 0], [np.eye(4)])
    assert farthest(moved(T, V[tip]), V[tip]) <= 2
