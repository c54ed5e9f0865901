"""The objective of learning: its gradient against differences, and what it is zero at."""

from __future__ import annotations

import numpy as np
import pytest

from solver import Deformer
from solver.geometry.motions import motion, rotation
from solver.learning import objective, sensitivity
from solver.learning.objective import Objective
from solver.linear.rest_surface import RestSurface
from solver.rigid import levels
from solver.setup import Setup
from solver.softness.material import Material
from solver.types import FloatArray
from tests.solver import shapes

V, F = shapes.tube(14, 8)
FIXED, HANDLE = np.flatnonzero(V[:, 0] < 0.9), np.flatnonzero(V[:, 0] > 7.1)
REST = RestSurface.of(V, F)
RNG = np.random.default_rng(0)


@pytest.fixture(autouse=True)
def exact(monkeypatch: pytest.MonkeyPatch) -> None:
    """Equilibria and their sensitivities to rounding."""
    monkeypatch.setattr(objective, "ROUNDS", 200)
    monkeypatch.setattr(objective, "FIRST_ROUNDS", 200)
    monkeypatch.setattr(sensitivity, "ACCURACY", 1e-9)
    monkeypatch.setattr(sensitivity, "ITERATIONS", 400)
    monkeypatch.setattr(levels, "STILL", 1e-15)


def posed(degrees: float = 50) -> FloatArray:
    T = motion(rotation([0, 0.2, 1], degrees), centre=[3, 0, 0])
    soft = np.clip(1 - np.abs(V[:, 0] - 3), 0, 1)
    return Deformer(V, F, FIXED, [HANDLE], soft, "clay").pose([T], 30)


def at(material: str | Material, *poses: FloatArray) -> Objective:
    setup = Setup(FIXED, [HANDLE], material=material)
    return Objective(REST, setup, [REST.normalise(X) for X in poses])


@pytest.mark.parametrize("material", ["hinge", "clay", Material(bending=1, stretching=0.2)])
def test_the_gradient_is_that_of_differences(material: str | Material) -> None:
    J = at(material, posed(), posed(-30))
    s, step = 0.5 + 0.3 * RNG.uniform(-1, 1, len(V)), 1e-2
    slope = J(s)[1]
    for _ in range(3):
        way = RNG.normal(size=len(V))
        difference = (J(s + step * way)[0] - J(s - step * way)[0]) / (2 * step)
        assert slope @ way == pytest.approx(difference, abs=2e-2 * float(np.linalg.norm(slope)))


def test_a_pose_of_the_tool_itself_costs_nothing_but_the_prior(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(objective, "SMOOTH", 0.0)
    monkeypatch.setattr(objective, "FRAMES", 0.0)
    monkeypatch.setattr(objective, "NEAR", 1e-12)
    soft = np.clip(1 - np.abs(V[:, 0] - 3), 0, 1)
    J = at("clay", posed())
    assert J(soft)[0] < 1e-3 * J(np.zeros(len(V)))[0]


def test_a_pose_of_something_held_has_the_units_of_the_surface() -> None:
    """As large a mesh, as large an error: nothing depends on the scale of the file."""
    large = RestSurface.of(100 * V, F)
    setup = Setup(FIXED, [HANDLE])
    s = np.full(len(V), 0.4)
    there = Objective(large, setup, [large.normalise(100 * posed())])(s)
    np.testing.assert_allclose(there[0], at("hinge", posed())(s)[0], rtol=1e-6)
