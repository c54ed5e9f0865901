"""The shapes that come out: what the default level reaches, and how it is measured."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from benchmarks.quality_cases import (
    BAND,
    Case,
    bent_cylinder,
    folded_arm,
    lifted_plane,
    mannequin,
    survey_case,
)
from benchmarks.quality_metrics import Limb, broken_triangles, measure
from tests.solver import shapes
from tests.solver.shapes import motion, moved, rotation

DEFAULT = 4


@pytest.mark.parametrize("name", ["cylinder", "bar"])
def test_the_survey_s_cases_stay_with_the_nonlinear_reference(name: str) -> None:
    case = survey_case(shapes.shared("bs08"), name)
    ours, primo = (
        measure(case.V, case.F, case.free, X)
        for X in (
            case.deformer().pose(case.transforms, DEFAULT),
            case.published["PriMo (nonlinear reference)"],
        )
    )
    assert ours.strain < primo.strain
    assert ours.dihedral < 1.5 * primo.dihedral
    assert ours.volume > primo.volume - 0.05


@pytest.mark.parametrize("make", [folded_arm, mannequin])
def test_a_soft_elbow_folds_where_it_is_soft_and_keeps_its_section(
    make: Callable[[], Case],
) -> None:
    case = make()
    assert case.limb is not None
    X = case.deformer().pose(case.transforms, DEFAULT)
    fold = case.limb.fold(X, case.joint, BAND * case.diagonal)
    assert fold.share >= 0.8
    assert fold.section >= 0.75
    assert broken_triangles(case.V, case.F, case.free, X) == 0


def test_a_lifted_plane_strains_less_than_linear_surfaces() -> None:
    case = lifted_plane()
    results = [case.deformer().pose(case.transforms, DEFAULT), case.harmonic(1), case.harmonic(2)]
    ours, *linear = [measure(case.V, case.F, case.free, X).strain for X in results]
    assert ours < min(linear)


def test_finer_triangles_give_the_same_shape() -> None:
    strains = []
    for rings in (4, 7):
        case = bent_cylinder(120, rings)
        X = case.deformer().pose(case.transforms, DEFAULT)
        strains.append(measure(case.V, case.F, case.free, X).strain)
    assert strains[0] == pytest.approx(strains[1], rel=0.05)


def test_a_rigid_motion_is_no_deformation() -> None:
    V, F = shapes.sphere()
    X = moved(motion(rotation([1, 2, 3], 70), [3, 2, 1]), V)
    m = measure(V, F, np.ones(len(V), dtype=bool), X)
    np.testing.assert_allclose([m.strain, m.dihedral, m.volume - 1], 0, atol=1e-7)
    assert m.broken == 0


def test_scaling_is_strain_and_volume_alone() -> None:
    V, F = shapes.sphere()
    m = measure(V, F, np.ones(len(V), dtype=bool), 2 * V)
    np.testing.assert_allclose([m.strain, m.dihedral, m.volume], [1, 0, 8], atol=1e-7)


def test_collapsed_and_inverted_triangles_are_counted() -> None:
    V, F = shapes.grid(6, 6)
    free = np.ones(len(V), dtype=bool)
    inverted, collapsed = V.copy(), V.copy()
    inverted[14] += [3, 0, 0]
    collapsed[14] = collapsed[15]
    assert broken_triangles(V, F, free, V) == 0
    assert broken_triangles(V, F, free, inverted) > 0
    assert broken_triangles(V, F, free, collapsed) == 2
    assert broken_triangles(V, F, ~free, inverted) == 0


def test_a_fold_at_one_place_is_found_there() -> None:
    V, F = shapes.tube(80, 24)
    angle = np.radians(90) * np.clip((V[:, 0] - 3) / 2, 0, 1)
    # The axis becomes an arc of 90 degrees between 3 and 5; sections stay circles.
    along = np.clip(V[:, 0], 3, 5)
    reach = 2 / np.radians(90)
    middle = np.column_stack([3 + reach * np.sin(angle), reach * (1 - np.cos(angle)), 0 * angle])
    middle += (V[:, 0] - along)[:, None] * np.column_stack(
        [np.cos(angle), np.sin(angle), 0 * angle]
    )
    X = middle + V[:, 1:2] * np.column_stack([-np.sin(angle), np.cos(angle), 0 * angle])
    X[:, 2] += V[:, 2]
    limb = Limb(V, F, np.zeros(2), (0.3, 7.7), 75)
    whole, half = limb.fold(X, 4, 1.2), limb.fold(X, 4, 0.5)
    assert whole.share == pytest.approx(1, abs=0.02)
    assert half.share == pytest.approx(0.5, abs=0.06)
    assert whole.section == pytest.approx(1, abs=0.02)
