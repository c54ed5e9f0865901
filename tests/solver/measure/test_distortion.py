"""Laws of the measures of a deformed surface."""

from __future__ import annotations

import numpy as np
import pytest

from solver import fundamental_forms
from solver.measure.distortion import Distortion
from solver.types import FloatArray
from tests.app.person import sheet, slab

MEASURES = ("strain", "dihedral", "area")


def turned(X: FloatArray, seed: int = 3) -> FloatArray:
    """X after some rotation and translation."""
    random = np.random.default_rng(seed)
    Q, _ = np.linalg.qr(random.normal(size=(3, 3)))
    Q[:, 0] *= np.linalg.det(Q)
    return X @ Q.T + random.normal(size=3)


def wavy(X: FloatArray) -> FloatArray:
    return X + 0.3 * np.sin(X[:, [1, 2, 0]])


@pytest.mark.parametrize("measure", MEASURES)
def test_a_rigid_motion_changes_nothing(measure: str) -> None:
    mesh = slab(6, 4, 1.0)
    measured = getattr(Distortion(mesh.vertices, mesh.faces), measure)
    at_rest, moved = measured(mesh.vertices), measured(turned(mesh.vertices))
    assert at_rest.rms == 0
    assert not at_rest.elements.any()
    assert not at_rest.vertices.any()
    assert moved.rms < 1e-12
    np.testing.assert_allclose(moved.vertices, 0, atol=1e-12)


@pytest.mark.parametrize("measure", MEASURES)
def test_what_is_measured_does_not_depend_on_where_the_surface_is(measure: str) -> None:
    mesh = slab(6, 4, 1.0)
    measured = getattr(Distortion(mesh.vertices, mesh.faces), measure)
    X = wavy(mesh.vertices)
    here, there = measured(X), measured(turned(X))
    assert here.rms > 0.01
    np.testing.assert_allclose(there.vertices, here.vertices, atol=1e-12)
    assert there.rms == pytest.approx(here.rms, rel=1e-10)


def test_scaling_by_a_tenth_is_a_strain_of_ten_percent_and_no_bend() -> None:
    mesh = slab(6, 4, 1.0)
    change = Distortion(mesh.vertices, mesh.faces)
    X = 1.1 * mesh.vertices
    for found, expected in ((change.strain(X), 0.1), (change.area(X), 0.21)):
        np.testing.assert_allclose(found.elements, expected, rtol=1e-12)
        np.testing.assert_allclose(found.vertices, expected, rtol=1e-12)
        assert found.rms == pytest.approx(expected)
    assert change.dihedral(X).rms < 1e-12


def test_folding_a_sheet_bends_one_line_and_stretches_nothing() -> None:
    V, F = sheet(6, 4)
    X, right = V.copy(), V[:, 0] > 3
    X[right, 0], X[right, 2] = 3, V[right, 0] - 3
    change = Distortion(V, F)
    assert change.strain(X).rms < 1e-12
    bend = change.dihedral(X)
    on_fold = V[:, 0] == 3
    np.testing.assert_allclose(bend.vertices[on_fold], np.pi / 2, atol=1e-12)
    np.testing.assert_allclose(bend.vertices[np.abs(V[:, 0] - 3) > 1], 0, atol=1e-12)
    assert bend.rms == pytest.approx(np.pi / 2 * np.sqrt(4 / len(bend.elements)))


def test_angles_are_those_of_the_second_fundamental_form() -> None:
    mesh = slab(6, 4, 1.0)
    V, F, X = mesh.vertices, mesh.faces, wavy(mesh.vertices)
    rest, now = fundamental_forms(V, F), fundamental_forms(X, F)
    turn = np.abs(np.angle(np.exp(1j * (now.dihedral_angles - rest.dihedral_angles))))
    change = Distortion(V, F)
    expected = np.sort(turn[~np.isnan(turn)])
    np.testing.assert_allclose(np.sort(change.dihedral(X).elements), expected, atol=1e-12)
    np.testing.assert_allclose(change.strain(X).elements, now.lengths / rest.lengths - 1)


def test_a_vertex_shows_the_edge_that_changed_most() -> None:
    V, F = sheet(6, 4)
    X = V * [1.3, 0.9, 1.0]
    change = Distortion(V, F)
    np.testing.assert_allclose(change.strain(X).vertices, 0.3)
    np.testing.assert_allclose(change.strain(V * [1.05, 0.8, 1.0]).vertices, -0.2)


@pytest.mark.parametrize("measure", MEASURES)
def test_the_rms_counts_what_has_a_counted_vertex(measure: str) -> None:
    V, F = sheet(8, 4)
    X, right = V.copy(), V[:, 0] > 4
    X[right] = wavy(V)[right]
    measured = getattr(Distortion(V, F), measure)
    assert measured(X, V[:, 0] < 2).rms < 1e-12
    assert measured(X, V[:, 0] > 6).rms > 0.01
    assert measured(X, V[:, 0] > -1).rms == measured(X).rms
    assert measured(X, np.zeros(len(V), dtype=bool)).rms == 0


def test_what_has_no_size_at_rest_counts_as_unchanged() -> None:
    V = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 0, 0], [5, 5, 5]])
    F = np.array([[0, 1, 2], [1, 3, 2]])  # an edge and a triangle without size, a loose vertex
    change = Distortion(V, F)
    X = V + np.arange(15).reshape(5, 3) ** 2 / 50
    for measure in MEASURES:
        found = getattr(change, measure)(X)
        assert np.isfinite(found.elements).all()
        assert np.isfinite(found.vertices).all()
        assert found.vertices[4] == 0
