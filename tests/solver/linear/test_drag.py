"""What a drag needs, without anything that solves."""

from __future__ import annotations

import pickle

import numpy as np
import pytest

from solver import Deformer
from solver.geometry.motions import motion, rotation
from solver.linear.drag_model import DragModel
from solver.types import FloatArray
from tests.solver import shapes

V, F = shapes.tube(16, 8)
NEAR, FAR, TIP = (np.flatnonzero(mask) for mask in (V[:, 0] < 1, V[:, 0] < 6, V[:, 0] > 7))
ONE = motion(rotation([1, 2, 3], 40), [0, 1, 2], V[TIP].mean(axis=0))
TWO = motion(rotation([0, 1, 0], -70), [1, 0, -1], V[TIP].mean(axis=0))


def deformer(fixed: str) -> Deformer:
    """Where little is fixed most vertices move, where much is fixed few do."""
    return Deformer(V, F, {"little": NEAR, "much": FAR}[fixed], [TIP])


@pytest.mark.parametrize("fixed", ["little", "much"])
def test_it_says_what_the_deformer_says_also_in_another_process(fixed: str) -> None:
    whole = deformer(fixed)
    model: DragModel = pickle.loads(pickle.dumps(whole.drag_model))
    assert model.handle_count == whole.handle_count
    np.testing.assert_array_equal(model.pose([ONE]), whole.pose([ONE]))
    np.testing.assert_allclose(model.pose([ONE]), whole.solve(model.pose([ONE])[TIP]), atol=1e-8)
    for R in (np.eye(4), ONE):
        args = 0, V[TIP[0]], V[TIP[0]] + [-1.0, 2.0, 0.5], [R]
        np.testing.assert_array_equal(model.orient(*args), whole.orient(*args))


@pytest.mark.parametrize("fixed", ["little", "much"])
def test_what_cannot_move_is_at_rest_to_the_last_bit(fixed: str) -> None:
    model = deformer(fixed).drag_model
    held = {"little": NEAR, "much": FAR}[fixed]
    np.testing.assert_array_equal(model.pose([ONE])[held], V[held])
    np.testing.assert_array_equal(model.pose([np.eye(4)]), V)
    assert len(model.basis) < len(V)


@pytest.mark.parametrize("fixed", ["little", "much"])
def test_a_surface_is_carried_from_one_pose_to_another(fixed: str) -> None:
    whole = deformer(fixed)
    model = whole.drag_model
    np.testing.assert_allclose(model.carry(V, [np.eye(4)], [ONE]), model.pose([ONE]), atol=1e-12)
    np.testing.assert_allclose(
        model.carry(model.pose([ONE]), [ONE], [TWO]), model.pose([TWO]), atol=1e-12
    )
    refined = whole.pose([ONE], rigid=1)
    before = refined.copy()
    carried = model.carry(refined, [ONE], [TWO])
    np.testing.assert_array_equal(refined, before)
    np.testing.assert_allclose(carried[TIP], at(TWO), atol=1e-9)
    np.testing.assert_array_equal(carried[NEAR], V[NEAR])


def test_posing_changes_nothing_it_was_given() -> None:
    model = deformer("little").drag_model
    rest = model.vertices.copy()
    first = model.pose([ONE])
    model.pose([TWO])
    np.testing.assert_array_equal(model.vertices, rest)
    np.testing.assert_array_equal(first, model.pose([ONE]))


def at(T: FloatArray) -> FloatArray:
    """Where the tip is."""
    X: FloatArray = V[TIP] @ T[:3, :3].T + T[:3, 3]
    return X
