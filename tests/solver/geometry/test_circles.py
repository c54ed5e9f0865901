"""What lies across an axis, and triangles on the border of a set."""

from __future__ import annotations

import numpy as np
import pytest

from solver.geometry.circles import across, circle
from solver.geometry.cross_products import area_vectors
from solver.geometry.crossings import crossed_triangles
from solver.types import FloatArray
from tests.solver import shapes

AXES = [np.array(axis) for axis in ([0.0, 0, 2], [-3.0, 0, 0], [1.0, 1, 1], [1e-8, -5, 0.3])]


@pytest.mark.parametrize("axis", AXES)
def test_two_directions_across_an_axis_make_a_right_handed_frame(axis: FloatArray) -> None:
    frame = np.array([*across(axis), axis / np.linalg.norm(axis)])
    np.testing.assert_allclose(frame @ frame.T, np.eye(3), atol=1e-12)
    assert np.linalg.det(frame) == pytest.approx(1)


@pytest.mark.parametrize("axis", AXES)
def test_a_circle_lies_across_its_axis_at_its_radius_and_turns_right_handed(
    axis: FloatArray,
) -> None:
    centre = np.array([1.0, 2, 3])
    spokes = circle(centre, axis, 0.7, 12) - centre
    np.testing.assert_allclose(spokes @ axis, 0, atol=1e-12)
    np.testing.assert_allclose(np.linalg.norm(spokes, axis=1), 0.7)
    steps = np.cross(spokes, np.roll(spokes, -1, axis=0)) @ axis
    np.testing.assert_allclose(steps, 0.49 * np.sin(np.pi / 6) * np.linalg.norm(axis))


def test_crossed_triangles_have_one_corner_alone_and_keep_their_orientation() -> None:
    V, F = shapes.grid(6, 5)
    inside = np.random.default_rng(3).random(len(V)) < 0.5
    crossed = crossed_triangles(F, inside)
    expected = {tuple(sorted(f)) for f in F.tolist() if 0 < inside[f].sum() < 3}
    assert {tuple(sorted(f)) for f in crossed.tolist()} == expected
    assert len(crossed) == len(expected)
    first, second, third = inside[crossed].T
    assert (first != second).all()
    assert (second == third).all()
    assert (area_vectors(V, crossed)[:, 2] * area_vectors(V, F)[0, 2] > 0).all()
