"""What a surface is bound to: compared by content, and shared where it is the same."""

from __future__ import annotations

import pickle

import numpy as np
import pytest

from solver import Deformer, Material, Setup
from solver.bound_surface import BoundSurface
from solver.geometry.motions import motion, rotation
from solver.surface.embedding import embed
from tests.solver import shapes

V, F = shapes.tube(12, 8)
ROOT, TIP = np.arange(8), np.arange(88, 96)
SOFTNESS = np.linspace(0, 1, len(V))


def setup() -> Setup:
    """New arrays at every call."""
    return Setup(ROOT.copy(), [TIP.copy()], SOFTNESS.copy(), "hinge")


def test_equal_content_in_new_arrays_is_equal() -> None:
    assert setup() == setup()
    assert setup() == pickle.loads(pickle.dumps(setup()))
    assert setup() == Setup(list(ROOT), (TIP.tolist(),), SOFTNESS, Material(0.1, 1.0))
    gains = [[0, 1]], [2.0], [3.0]
    assert Setup(edge_gains=gains) == Setup(edge_gains=gains)


@pytest.mark.parametrize(
    "changes",
    [
        {"fixed": ROOT[1:]},
        {"handles": [TIP, ROOT[:1]]},
        {"handles": [TIP[::-1]]},
        {"softness": SOFTNESS**2},
        {"softness": None},
        {"material": "clay"},
        {"bending_length": 0.02},
        {"orientation": False},
        {"edge_gains": ([[0, 1]], [2.0], [3.0])},
    ],
)
def test_any_other_content_is_another_setup(changes: dict[str, object]) -> None:
    assert setup() != setup().changed(**changes)


def test_what_the_caller_does_to_its_arrays_later_does_not_reach_it() -> None:
    softness, fixed = SOFTNESS.copy(), ROOT.copy()
    made = Setup(fixed, [TIP], softness)
    softness[:], fixed[:] = 0.5, 50
    assert made == setup()
    with pytest.raises(ValueError, match="read-only"):
        made.fixed[0] = 3


def test_a_rebind_shares_what_is_equal_by_content() -> None:
    bound = BoundSurface.of(embed(V, F), setup())
    assert bound.rebound(setup()).binding is bound.binding
    softer = bound.rebound(setup().changed(softness=SOFTNESS**2)).binding
    assert softer.structure is bound.binding.structure
    assert softer.constraints is bound.binding.constraints
    moved = bound.rebound(setup().changed(handles=[TIP[1:]])).binding
    assert moved.structure is not bound.binding.structure
    assert moved.rest is bound.binding.rest


def test_a_deformer_of_a_setup_is_the_deformer_of_its_arguments() -> None:
    T = motion(rotation([0, 0, 1], 40), [1, 0, 0])
    expected = Deformer(V, F, ROOT, [TIP], SOFTNESS).pose([T], rigid=1)
    np.testing.assert_array_equal(Deformer.of(V, F, setup()).pose([T], rigid=1), expected)
    rebound = Deformer(V, F, TIP, [ROOT]).rebound(setup())
    np.testing.assert_allclose(rebound.pose([T], rigid=1), expected, atol=1e-12)
    assert rebound.setup == setup()
