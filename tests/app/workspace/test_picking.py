from __future__ import annotations

import numpy as np
import pytest

from app.workspace.camera import Ray
from app.workspace.picking import Picker
from solver.types import FloatArray
from tests.app.person import sheet


def two_sheets() -> tuple[FloatArray, Picker]:
    low, F = sheet(10, 10)
    high, _ = sheet(10, 10, height=1.0)
    return np.vstack([low, high]), Picker(np.vstack([F, F + len(low)]))


def towards(origin: FloatArray, point: FloatArray) -> Ray:
    direction = point - origin
    return Ray(origin, direction / np.linalg.norm(direction))


@pytest.mark.parametrize("scale", [1e-5, 1.0, 1e5])
def test_the_first_of_two_sheets_is_hit_from_both_sides(scale: float) -> None:
    V, picker = two_sheets()
    V = V * scale
    for side, height in ((1, 1.0), (-1, 0.0)):
        eye = np.array([5.0, 5.0, side * 30.0]) * scale
        for x, y in np.random.default_rng(0).uniform(0.1, 9.9, (200, 2)):
            point = np.array([x, y, height]) * scale
            hit = picker.pick(towards(eye, point), V)
            assert hit is not None
            np.testing.assert_allclose(hit.position, point, atol=1e-6 * scale)


def test_rays_exactly_through_edges_and_vertices_do_not_slip_through() -> None:
    V, picker = two_sheets()
    eye = np.array([4.3, 5.7, 30.0])
    for x in np.arange(1, 9.5, 0.5):
        for y in np.arange(1, 9.5, 0.5):
            hit = picker.pick(towards(eye, np.array([x, y, 1.0])), V)
            assert hit is not None
            np.testing.assert_allclose(hit.position, [x, y, 1.0], atol=1e-4)


def test_a_hit_names_its_place_and_the_nearest_corner() -> None:
    V, F = sheet(10, 10)
    hit = Picker(F).pick(Ray(np.array([3.9, 2.2, 7.0]), np.array([0.0, 0.0, -1.0])), V)
    assert hit is not None
    np.testing.assert_allclose(hit.barycentric @ V[F[hit.face]], [3.9, 2.2, 0], atol=1e-9)
    np.testing.assert_allclose(V[hit.vertex], [4, 2, 0])
    assert hit.distance == pytest.approx(7)


def test_a_ray_that_passes_by_or_points_away_hits_nothing() -> None:
    V, F = sheet(10, 10)
    up = np.array([0.0, 0.0, 1.0])
    assert Picker(F).pick(Ray(np.array([12.0, 5.0, -3.0]), up), V) is None
    assert Picker(F).pick(Ray(np.array([5.0, 5.0, 3.0]), up), V) is None


def test_the_surface_that_moved_is_the_one_that_is_hit() -> None:
    V, F = sheet(10, 10)
    picker = Picker(F)
    ray = Ray(np.array([5.2, 5.1, 9.0]), np.array([0.0, 0.0, -1.0]))
    for height in (0.0, 3.0, -2.0):
        hit = picker.pick(ray, np.add(V, [0, 0, height]))
        assert hit is not None
        assert hit.position[2] == pytest.approx(height)


def test_a_stray_vertex_far_away_does_not_spoil_the_picking() -> None:
    V, F = sheet(10, 10)
    V = np.vstack([V, [1e9, 1e9, 1e9]])
    ray = Ray(np.array([3.9, 2.2, 7.0]), np.array([0.0, 0.0, -1.0]))
    hit = Picker(F).pick(ray, V)
    assert hit is not None
    np.testing.assert_allclose(hit.position, [3.9, 2.2, 0.0], atol=1e-6)
