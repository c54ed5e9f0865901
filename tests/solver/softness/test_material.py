"""Softness, gains, and softness from a few values."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from solver import (
    PRESETS,
    ConstraintError,
    Deformer,
    Material,
    MaterialError,
    MeshError,
    fundamental_forms,
    interpolate_softness,
)
from solver.geometry.laplacian import cotangent_laplacian
from solver.geometry.motions import motion, rotation
from solver.geometry.topology import Topology
from solver.softness.material import as_edge_gains, explicit_gains, resolve_material, softness_gains
from tests.solver import shapes

rng = np.random.default_rng(0)


def bent(V: np.ndarray, F: np.ndarray, **options: Any) -> np.ndarray:
    """A tube along x, its right end turned by 90 degrees."""
    ends = np.flatnonzero(V[:, 0] < 1), np.flatnonzero(V[:, 0] > 7)
    T = motion(rotation([0, 0, 1], 90), [-3, 3, 0], [7, 0, 0])
    return Deformer(V, F, ends[0], [ends[1]], **options).pose([T])


@pytest.mark.parametrize("material", [*PRESETS, Material(0.3, 7)])
def test_edge_gains_from_a_softness_equal_that_softness(material: str | Material) -> None:
    V, F = shapes.tube()
    s = rng.random(len(V))
    edges = fundamental_forms(V, F).edges
    gain = resolve_material(material)
    edge = (s[edges[:, 0]] + s[edges[:, 1]]) / 2
    gains = (edges[:, ::-1], gain.bending**edge, gain.stretching**edge)
    np.testing.assert_allclose(
        bent(V, F, edge_gains=gains), bent(V, F, softness=s, material=material), atol=1e-12
    )


def test_presets_are_those_of_the_documentation() -> None:
    assert {name: (m.bending, m.stretching) for name, m in PRESETS.items()} == {
        "hinge": (0.1, 1.0),
        "paper": (2.0, 0.5),
        "clay": (0.1, 0.1),
    }


def test_gains_run_from_one_to_the_materials() -> None:
    _, F = shapes.tube(3, 4)
    topology = Topology(F, 12)
    for softness, expected in ((None, (1, 1)), (np.zeros(12), (1, 1)), (np.ones(12), (2, 0.5))):
        bending, stretching = softness_gains(topology, softness, "paper")
        np.testing.assert_allclose(bending, expected[0])
        np.testing.assert_allclose(stretching, expected[1])


def test_edges_not_named_are_rigid() -> None:
    V, F = shapes.tube(3, 4)
    topology = Topology(F, len(V))
    one = topology.edges[5:6]
    bending, stretching = explicit_gains(topology, as_edge_gains((one, [3.0], [0.2])))
    assert bending[5] == 3
    assert stretching[5] == 0.2
    np.testing.assert_array_equal(np.delete(bending, 5), 1)
    np.testing.assert_array_equal(np.delete(stretching, 5), 1)


def test_a_soft_band_gathers_the_fold() -> None:
    V, F = shapes.tube(40, 16)
    band = np.clip(1 - np.abs(V[:, 0] - 4), 0, 1)

    def share(X: np.ndarray) -> float:
        """How much of the bend lies within the band."""
        centre = X.reshape(40, 16, 3).mean(axis=1)
        step = np.diff(centre, axis=0)
        turn = np.abs(np.diff(np.arctan2(step[:, 1], step[:, 0])))
        inside = np.abs(V[::16, 0][1:-1] - 4) < 1
        return float(turn[inside].sum() / turn.sum())

    plain = share(bent(V, F))
    soft = share(bent(V, F, softness=band))
    softer = share(bent(V, F, softness=band, material=Material(0.01, 1)))
    assert plain < soft < softer


def test_a_uniform_gain_on_both_energies_changes_nothing() -> None:
    V, F = shapes.tube()
    everywhere = np.ones(len(V))
    np.testing.assert_allclose(
        bent(V, F, softness=everywhere, material="clay"), bent(V, F), atol=1e-9
    )


@pytest.mark.parametrize("surface", [shapes.sphere(), shapes.bumpy_plane(), shapes.tube()])
def test_harmonic_softness_keeps_painted_values_and_stays_between_them(
    surface: shapes.Surface,
) -> None:
    V, F = surface
    indices = rng.choice(len(V), 9, replace=False)
    values = rng.uniform(0.2, 0.9, 9)
    s = interpolate_softness(V, F, indices, values)
    np.testing.assert_array_equal(s[indices], values)
    free = np.delete(np.arange(len(V)), indices)
    assert values.min() < s[free].min()
    assert s[free].max() < values.max()
    np.testing.assert_allclose((cotangent_laplacian(V, F) @ s)[free], 0, atol=1e-12)


def test_harmonic_softness_is_linear_between_the_ends_of_a_strip() -> None:
    V, F = shapes.tube(11, 8, length=10)  # a strip without sides: clamping cannot tilt it
    ends = np.flatnonzero(np.isin(V[:, 0], [0, 10]))
    s = interpolate_softness(V, F, ends, V[ends, 0] / 10)
    np.testing.assert_allclose(s, V[:, 0] / 10, atol=1e-12)


def test_a_piece_without_a_value_is_rigid() -> None:
    V, F = shapes.tetrahedron()
    s = interpolate_softness(np.vstack([V, V + 9]), np.vstack([F, F + 4]), [1], [0.75])
    np.testing.assert_allclose(s, [0.75] * 4 + [0] * 4, atol=1e-12)
    np.testing.assert_array_equal(interpolate_softness(V, F, [], []), 0)
    np.testing.assert_array_equal(interpolate_softness(V, F, range(4), np.full(4, 0.5)), 0.5)


def test_a_step_stays_a_step_where_everything_is_given() -> None:
    V, F = shapes.grid(6, 3)
    step = (V[:, 0] > 2.5).astype(float)
    np.testing.assert_array_equal(interpolate_softness(V, F, range(len(V)), step), step)


@pytest.mark.parametrize(
    ("indices", "values", "error", "text"),
    [
        ([0, 1], [0.5], MaterialError, "values must be (2,), one for each index, got (1,)"),
        ([0, 0], [0.5, 0.6], MaterialError, "indices name a vertex twice"),
        ([0], [1.5], MaterialError, "values must lie in [0, 1], got 1.5 at index 0"),
        ([0], [-0.1], MaterialError, "values must lie in [0, 1], got -0.1"),
        ([0], [np.nan], MaterialError, "values must be finite"),
        ([4], [0.5], ConstraintError, "indices names vertex 4, expected 0 to 3"),
        ([0.5], [0.5], ConstraintError, "indices must be a list of vertex indices"),
    ],
)
def test_refuses_softness_that_cannot_be_interpolated(
    indices: Any, values: Any, error: type[MaterialError], text: str
) -> None:
    with shapes.refuses(error, text):
        interpolate_softness(*shapes.tetrahedron(), indices, values)


def test_interpolation_refuses_what_is_no_mesh() -> None:
    with shapes.refuses(MeshError, "vertices must be"):
        interpolate_softness(np.zeros((2, 2)), [[0, 1, 1]], [0], [1])


@pytest.mark.parametrize(
    ("options", "text"),
    [
        ({"softness": [0.5]}, "softness must be (4,), got (1,)"),
        ({"softness": [0, 0, 2, 0]}, "softness must lie in [0, 1], got 2.0 at index 2"),
        ({"softness": [0, 0, np.nan, 0]}, "softness must be finite"),
        ({"softness": ["a", 0, 0, 0]}, "softness must be numbers"),
        ({"material": "jelly"}, "unknown material 'jelly', expected one of hinge, paper, clay"),
        ({"material": None}, "unknown material None"),
        ({"material": ["hinge"]}, "unknown material ['hinge']"),
        ({"bending_length": 0}, "bending_length must be a number from 1e-12 to 1000, got 0"),
        ({"bending_length": np.inf}, "bending_length must be a number from 1e-12 to 1000, got inf"),
        ({"bending_length": [1]}, "must be a number from 1e-12 to 1000, got [1]"),
        (
            {"bending_length": "long"},
            "must be a number from 1e-12 to 1000, got 'long'",
        ),
        (
            {"edge_gains": ([[0, 1]], [1.0])},
            "edge_gains must be (edges, bending, stretching), got 2",
        ),
        ({"edge_gains": ([0, 1], [1.0], [1.0])}, "edges must be (k, 2) integers"),
        ({"edge_gains": ([[0.0, 1.0]], [1.0], [1.0])}, "edges must be (k, 2) integers"),
        ({"edge_gains": ([[0, 1]], [1.0, 2.0], [1.0])}, "bending must be (1,), got (2,)"),
        (
            {"edge_gains": ([[0, 1]], [1.0], [0.0])},
            "must be from 1e-06 to 1e+06, got 0.0",
        ),
        ({"edge_gains": ([[0, 1]], [np.nan], [1.0])}, "bending must be finite"),
        ({"edge_gains": ([[0, 0]], [1.0], [1.0])}, "(0, 0), which is no edge of the mesh"),
        ({"edge_gains": ([[0, 4]], [1.0], [1.0])}, "(0, 4), which is no edge of the mesh"),
        ({"edge_gains": ([[1, -1]], [1.0], [1.0])}, "(1, -1), which is no edge of the mesh"),
        (
            {"edge_gains": ([[0, 1]], [1.0], [1.0]), "softness": np.zeros(4)},
            "give softness or edge_gains, got both",
        ),
    ],
)
def test_a_deformer_refuses_a_material_that_makes_no_sense(
    options: dict[str, Any], text: str
) -> None:
    with shapes.refuses(MaterialError, text):
        Deformer(*shapes.tetrahedron(), [0], [[1]], **options)


@pytest.mark.parametrize(
    ("bending", "stretching", "text"),
    [
        (0, 1, "bending gain must be from 1e-06 to 1e+06, got 0"),
        (1, -1, "stretching gain must be from 1e-06 to 1e+06, got -1"),
        (np.nan, 1, "bending gain must be from 1e-06 to 1e+06, got nan"),
        ("1", 1, "bending gain must be a number, got '1'"),
        (1, True, "stretching gain must be a number, got True"),
    ],
)
def test_a_material_refuses_gains_that_make_no_sense(
    bending: Any, stretching: Any, text: str
) -> None:
    with shapes.refuses(MaterialError, text):
        Material(bending, stretching)
