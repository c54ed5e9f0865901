"""Laws of smoothing a softness field, and when a field is found fault with."""

from __future__ import annotations

import numpy as np
import pytest

from solver import Material, MaterialError
from solver.geometry.laplacian import cotangent_laplacian
from solver.geometry.topology import Topology
from solver.softness.checks import check_softness, smooth_softness
from solver.types import FloatArray
from tests.app.person import sheet

V, F = sheet(40, 8)
EDGES = Topology(F, len(V)).edges


def band(edges_wide: float) -> FloatArray:
    """Soft to the left of x = 20.5, a ramp of so many edges, rigid to the right of it."""
    return np.clip((20.5 - V[:, 0]) / edges_wide + 0.5, 0, 1)


def noise(seed: int) -> FloatArray:
    return np.random.default_rng(seed).uniform(0, 1, len(V)) ** 2


@pytest.mark.parametrize("field", [band(0.5), band(4), noise(0), noise(1) * 0.3 + 0.2])
def test_smoothing_keeps_the_bounds_and_lowers_the_dirichlet_energy(field: FloatArray) -> None:
    L = cotangent_laplacian(V, F)
    smooth = smooth_softness(V, F, field)
    assert field.min() <= smooth.min() <= smooth.max() <= field.max()
    assert smooth @ (L @ smooth) < 0.7 * (field @ (L @ field))


def test_smoothing_leaves_a_constant_field_and_what_is_far_away_alone() -> None:
    for value in (0.0, 0.37, 1.0):
        smooth = smooth_softness(V, F, np.full(len(V), value))
        np.testing.assert_allclose(smooth, value, rtol=1e-12)
    far = V[:, 0] > 34
    assert not smooth_softness(V, F, band(0.5))[far].any()


def test_smoothing_does_not_depend_on_the_scale_of_the_file() -> None:
    np.testing.assert_allclose(
        smooth_softness(1e-3 * V, F, band(0.5)), smooth_softness(V, F, band(0.5)), atol=1e-12
    )


def test_smoothing_asks_for_one_value_in_the_unit_interval_a_vertex() -> None:
    with pytest.raises(MaterialError, match=r"softness must be \(369,\), got \(3,\)"):
        smooth_softness(V, F, np.zeros(3))
    with pytest.raises(MaterialError, match=r"must lie in \[0, 1\], got 2 to 2"):
        smooth_softness(V, F, np.full(len(V), 2.0))


@pytest.mark.parametrize(("wide", "steep"), [(0.5, True), (1.5, True), (3.0, False), (9.0, False)])
def test_an_abrupt_end_is_steep_and_one_smoothing_mends_it(wide: float, steep: bool) -> None:
    field = band(wide)
    assert check_softness(EDGES, field, "hinge").steep == steep
    assert not check_softness(EDGES, smooth_softness(V, F, field), "hinge").steep


@pytest.mark.parametrize(
    ("stretching", "most", "weak"),
    [(1.0, 1.0, False), (0.1, 1.0, False), (0.03, 1.0, True), (0.03, 0.5, False)],
)
def test_a_fold_tears_where_almost_no_stretching_stiffness_is_left(
    stretching: float, most: float, weak: bool
) -> None:
    check = check_softness(EDGES, most * band(9), Material(1.0, stretching))
    assert check.weak == weak
    assert check.stretching == pytest.approx(stretching**most)


def test_a_rigid_field_has_no_fault_in_any_material() -> None:
    check = check_softness(EDGES, np.zeros(len(V)), Material(1e-6, 1e-6))
    assert (check.jump, check.stretching) == (0.0, 1.0)
    assert not check.steep
    assert not check.weak
