"""The shapes that come out: what the default level reaches."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from benchmarks.cases.assets import bent_cylinder, folded_arm, folded_mannequin, lifted_plane
from benchmarks.cases.case import Case
from benchmarks.cases.survey import PRIMO, survey_case
from tests.solver import shapes

DEFAULT = 4


@pytest.mark.parametrize("name", ["cylinder", "bar"])
def test_the_survey_s_cases_stay_with_the_nonlinear_reference(name: str) -> None:
    case = survey_case(shapes.shared("bs08"), name)
    ours = case.quality(case.deformer().pose(case.transforms, DEFAULT))
    primo = case.quality(case.published[PRIMO])
    assert ours.strain < primo.strain
    assert ours.dihedral < 1.5 * primo.dihedral
    assert ours.volume > primo.volume - 0.05


@pytest.mark.parametrize("make", [folded_arm, folded_mannequin])
def test_a_soft_elbow_folds_where_it_is_soft_and_keeps_its_section(
    make: Callable[[], Case],
) -> None:
    case = make()
    assert case.limb is not None
    X = case.deformer().pose(case.transforms, DEFAULT)
    fold = case.fold(X)
    assert fold.share >= 0.8
    assert fold.section >= 0.75
    assert case.broken(X) == 0


def test_a_lifted_plane_strains_less_than_linear_surfaces() -> None:
    case = lifted_plane()
    results = [case.deformer().pose(case.transforms, DEFAULT), case.harmonic(1), case.harmonic(2)]
    ours, *linear = [case.quality(X).strain for X in results]
    assert ours < min(linear)


def test_finer_triangles_give_the_same_shape() -> None:
    strains = []
    for rings in (4, 7):
        case = bent_cylinder(120, rings)
        X = case.deformer().pose(case.transforms, DEFAULT)
        strains.append(case.quality(X).strain)
    assert strains[0] == pytest.approx(strains[1], rel=0.05)
