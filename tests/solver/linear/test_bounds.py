"""Transforms, targets and gains of any size: solved right, or refused by a typed error."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from solver import ConstraintError, Deformer, FactorizationError, Material, MeshError, SolverError
from solver.factor import check_factor, factorize
from solver.forms.fundamental_forms import fundamental_forms
from solver.forms.reconstruction import reconstruct
from solver.geometry.motions import motion, rotation
from solver.linear.system import System
from solver.softness.harmonic import interpolate_softness
from tests.solver import shapes

V, F = shapes.bumpy_plane(10)
LEFT, RIGHT = np.flatnonzero(V[:, 0] == 0), np.flatnonzero(V[:, 0] == 9)
DEFORMERS = [Deformer(V, F, LEFT, [RIGHT], coarse=coarse) for coarse in (None, 40)]
FAR = np.array([1e300, 0, 0])


@pytest.mark.parametrize("deformer", DEFORMERS, ids=["exact", "coarse"])
@pytest.mark.parametrize("rigid", [0, 1, 4])
@pytest.mark.parametrize(
    ("T", "words"),
    [
        (motion(np.eye(3), [1e308, 0, 0]), "move the surface by at most 5000 of its diagonals"),
        (motion(np.eye(3), [1e5, 0, 0]), "move the surface by at most 5000 of its diagonals"),
        (np.diag([1e308, 1, 1, 1]), "linear part of entries up to 1000, got 1e+308"),
        (np.diag([1, 1001, 1, 1]), "linear part of entries up to 1000, got 1e+03"),
    ],
)
def test_a_transform_out_of_reach_is_refused(
    deformer: Deformer, rigid: int, T: Any, words: str, recwarn: pytest.WarningsRecorder
) -> None:
    with pytest.raises(ConstraintError) as caught:
        deformer.pose([T], rigid)
    assert str(caught.value).startswith("transform 0 must ")
    assert words in str(caught.value)
    assert not list(recwarn)


@pytest.mark.parametrize("deformer", DEFORMERS, ids=["exact", "coarse"])
@pytest.mark.parametrize("rigid", [0, 1, 4])
def test_the_largest_transform_is_solved(deformer: Deformer, rigid: int) -> None:
    turn = motion(rotation([0, 1, 0], 100), [4e3 * np.ptp(V), 0, 0])
    stretched = motion(999 * np.eye(3))
    for T in (turn, stretched):
        X = deformer.pose([T], rigid)
        assert np.isfinite(X).all()
        np.testing.assert_allclose(X[RIGHT], V[RIGHT] @ T[:3, :3].T + T[:3, 3], rtol=1e-9)


@pytest.mark.parametrize("deformer", DEFORMERS, ids=["exact", "coarse"])
def test_targets_out_of_reach_are_refused(deformer: Deformer) -> None:
    words = "must lie within 5000 diagonals of the surface, got"
    with pytest.raises(ConstraintError, match=f"targets {words}"):
        deformer.solve(V[RIGHT] + FAR)
    with pytest.raises(ConstraintError, match=f"target {words}"):
        deformer.orient(0, V[RIGHT[0]], FAR, [np.eye(4)])


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"bending_length": 10**400}, "bending_length must be a number from 1e-12 to 1000"),
        ({"bending_length": 1e4}, "bending_length must be a number from 1e-12 to 1000"),
        ({"edge_gains": ([[0, 1]], [1e7], [1.0])}, "bending must be from 1e-06 to 1e+06, got 1"),
        ({"softness": [10**400] * len(V)}, "softness must be numbers"),
        ({"coarse": -(10**400)}, "coarse must be None or a positive integer"),
    ],
)
def test_an_extreme_option_is_refused(options: dict[str, Any], words: str) -> None:
    with pytest.raises(SolverError) as caught:
        Deformer(V, F, LEFT, [RIGHT], **options)
    assert words in str(caught.value)


@pytest.mark.parametrize("gain", [1e7, 1e-7, 10**400])
def test_an_extreme_gain_is_refused(gain: float) -> None:
    with pytest.raises(SolverError, match=r"bending gain must be from 1e-06 to 1e\+06, got"):
        Material(gain, 1.0)


@pytest.mark.parametrize(
    ("factor", "words"),
    [
        (1e160, "vertices must have coordinates up to 1e+60"),
        (1e-200, "the surface must be 1e-60 large or more"),
    ],
)
def test_coordinates_beyond_the_arithmetic_are_refused(factor: float, words: str) -> None:
    for use in (
        lambda: Deformer(factor * V, F, LEFT, [RIGHT]),
        lambda: fundamental_forms(factor * V, F),
        lambda: interpolate_softness(factor * V, F, [0, 1], [0.0, 1.0]),
    ):
        with pytest.raises(MeshError) as caught:
            use()
        assert words in str(caught.value)


@pytest.mark.parametrize("factor", [1e-50, 1e50])
def test_coordinates_within_it_change_nothing(factor: float) -> None:
    T = motion(rotation([0, 1, 0], 70), [1, 2, 3])
    small = motion(T[:3, :3], factor * T[:3, 3])
    for rigid in (0, 1, 4):
        X = Deformer(factor * V, F, LEFT, [RIGHT]).pose([small], rigid)
        np.testing.assert_allclose(X / factor, DEFORMERS[0].pose([T], rigid), atol=1e-8)


@pytest.mark.parametrize("length", [np.nan, -1.0, 1e200])
def test_forms_of_no_surface_are_refused(length: float) -> None:
    forms = fundamental_forms(V, F)
    lengths = forms.lengths.copy()
    lengths[3] = length
    with pytest.raises(MeshError, match="lengths must be positive, the longest from 1e-60"):
        reconstruct(F, replace(forms, lengths=lengths))


def test_forms_without_an_area_are_refused() -> None:
    flat = V * [1, 0, 0]
    with pytest.raises(MeshError, match="triangles must have an area, got none"):
        reconstruct(F, fundamental_forms(flat, F))


def test_gains_too_far_apart_are_refused() -> None:
    soft, material = np.ones(len(V)), Material(1e-6, 1e6)
    with pytest.raises(FactorizationError, match=r"only, expected .*: triangles are too thin"):
        Deformer(V, F, LEFT, [RIGHT], soft, material)
    with pytest.raises(FactorizationError, match="of its diagonal only"):
        DEFORMERS[0].rebind(softness=soft, material=material)


class Wrong:
    """A factor that solves something else."""

    def __init__(self, system: System, flaw: float) -> None:
        self._factor, self._flaw = system.factor, flaw

    def solve(self, B: Any) -> Any:
        X = self._factor.solve(B)
        X[len(X) // 2] += self._flaw
        return X


@pytest.mark.parametrize("flaw", [0.01, np.nan])
def test_a_factor_that_is_wrong_somewhere_is_noticed(
    flaw: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    system = DEFORMERS[0].system
    system.check()
    monkeypatch.setattr(system, "factor", Wrong(system, flaw))
    with pytest.raises(FactorizationError, match="of its diagonal only"):
        system.check()


def test_the_check_solves_what_it_is_given() -> None:
    K = DEFORMERS[0].system.matrix()
    free = DEFORMERS[0].system.free
    A = K[free][:, free]
    known = np.random.default_rng(0).normal(size=len(free))
    check_factor(factorize(A), known, A @ known)
    with pytest.raises(FactorizationError):
        check_factor(factorize(A), known, A @ known * 1.01)
