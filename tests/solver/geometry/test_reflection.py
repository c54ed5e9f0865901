"""Laws of reflections, and the planes that are found in surfaces."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from solver import load_mesh
from solver.geometry.motions import rotation
from solver.geometry.reflection import Plane, find_plane, partners
from solver.types import FloatArray

ASSETS = Path(__file__).resolve().parents[3] / "assets"
TILTED = Plane(np.array([2.0, 3.0, -6.0]) / 7, 0.4)


def half(count: int) -> FloatArray:
    """Points on one side of x = 0, like no mirror image of each other."""
    return np.random.default_rng(0).random((count, 3)) * [1.0, 3.0, 0.5]


def both(points: FloatArray) -> FloatArray:
    return np.vstack([points, points * [-1, 1, 1]])


def test_a_reflection_is_its_own_inverse_and_keeps_its_plane() -> None:
    S = TILTED.matrix
    np.testing.assert_allclose(S @ S, np.eye(4), atol=1e-12)
    assert np.linalg.det(S[:3, :3]) == pytest.approx(-1)
    points = half(20)
    image = TILTED.reflect(points)
    np.testing.assert_allclose(image, points @ S[:3, :3].T + S[:3, 3], atol=1e-12)
    np.testing.assert_allclose(
        (image + points) / 2 @ TILTED.normal, np.full(20, TILTED.offset), atol=1e-12
    )


@pytest.mark.parametrize("turn", [0.0, 7.0, 50.0])
def test_the_plane_is_found_wherever_it_lies(turn: float) -> None:
    R, t = rotation([1, 2, 3], turn), np.array([5.0, -2.0, 0.3])
    points = both(half(1500)) @ R.T + t
    plane = find_plane(points)
    assert plane is not None
    assert abs(plane.normal @ R[:, 0]) == pytest.approx(1, abs=1e-6)
    assert abs(plane.offset) == pytest.approx(abs(plane.normal @ t), abs=1e-6)


@pytest.mark.parametrize("name", ["mannequin.obj", "dog.obj"])
def test_figures_are_symmetric_across_x(name: str) -> None:
    plane = find_plane(load_mesh(ASSETS / name).vertices)
    assert plane is not None
    assert abs(plane.normal[0]) > 0.999
    assert abs(plane.offset) < 0.01


def test_what_has_no_symmetry_has_no_plane() -> None:
    assert find_plane(np.cumsum(np.random.default_rng(1).normal(size=(900, 3)), axis=0)) is None


def test_partners_are_mutual_and_what_has_none_says_so() -> None:
    points = both(half(50))
    lonely = np.vstack([points, [[0.5, 9.0, 0.0]]])
    found = partners(lonely, Plane(np.array([1.0, 0.0, 0.0]), 0.0), np.full(101, 1e-9))
    np.testing.assert_array_equal(found[:50], np.arange(50, 100))
    np.testing.assert_array_equal(found[found[:100]], np.arange(100))
    assert found[100] == -1
