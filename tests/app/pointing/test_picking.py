from __future__ import annotations

import numpy as np
import pytest

from app.pointing.picking import Picker
from app.viewpoint.camera import Ray
from solver.types import FloatArray
from tests.app.person import sheet


def two_sheets() -> tuple[FloatArray, Picker]:
    low, F = sheet(10, 10)
    high, _ = sheet(10, 10, height=1.0)
    V = np.vstack([low, high])
    return V, Picker(V, np.vstack([F, F + len(low)]))


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
    hit = Picker(V, F).pick(Ray(np.array([3.9, 2.2, 7.0]), np.array([0.0, 0.0, -1.0])), V)
    assert hit is not None
    np.testing.assert_allclose(hit.barycentric @ V[F[hit.face]], [3.9, 2.2, 0], atol=1e-9)
    np.testing.assert_allclose(V[hit.vertex], [4, 2, 0])
    assert hit.distance == pytest.approx(7)


def test_a_ray_that_passes_by_or_points_away_hits_nothing() -> None:
    V, F = sheet(10, 10)
    up = np.array([0.0, 0.0, 1.0])
    assert Picker(V, F).pick(Ray(np.array([12.0, 5.0, -3.0]), up), V) is None
    assert Picker(V, F).pick(Ray(np.array([5.0, 5.0, 3.0]), up), V) is None


def test_the_surface_that_moved_is_the_one_that_is_hit() -> None:
    V, F = sheet(10, 10)
    picker = Picker(V, F)
    ray = Ray(np.array([5.2, 5.1, 9.0]), np.array([0.0, 0.0, -1.0]))
    for height in (0.0, 3.0, -2.0):
        hit = picker.pick(ray, np.add(V, [0, 0, height]))
        assert hit is not None
        assert hit.position[2] == pytest.approx(height)


def test_a_stray_vertex_far_away_does_not_spoil_the_picking() -> None:
    V, F = sheet(10, 10)
    V = np.vstack([V, [1e9, 1e9, 1e9]])
    ray = Ray(np.array([3.9, 2.2, 7.0]), np.array([0.0, 0.0, -1.0]))
    hit = Picker(V, F).pick(ray, V)
    assert hit is not None
    np.testing.assert_allclose(hit.position, [3.9, 2.2, 0.0], atol=1e-6)


def test_on_a_bent_surface_it_finds_what_asking_every_triangle_finds() -> None:
    V, F = sheet(60, 40)
    picker = Picker(V, F)
    angle = V[:, 0] / 9
    X = np.column_stack([9 * np.sin(angle), V[:, 1], 9 - 9 * np.cos(angle)])  # a roll
    eye, rng = np.array([3.0, -40.0, 25.0]), np.random.default_rng(1)
    for point in rng.uniform([-12, -5, -3], [12, 45, 20], (200, 3)):
        ray = towards(eye, point)
        distance = first_of_all(ray, X[F])
        hit = picker.pick(ray, X)
        assert (hit is None) == (distance == np.inf)
        if hit is not None:
            assert hit.distance == pytest.approx(distance)


def first_of_all(ray: Ray, corners: FloatArray) -> float:
    """Where a ray meets the first of some triangles (m, 3, 3); infinity for none."""
    a, b, c = (corners[:, k] for k in range(3))
    sides = np.stack([b - a, c - a, np.broadcast_to(-ray.direction, a.shape)], axis=2)
    u, v, t = np.linalg.solve(sides, (ray.origin - a)[..., None])[..., 0].T
    met = (u >= 0) & (v >= 0) & (u + v <= 1) & (t > 0)
    return float(np.where(met, t, np.inf).min())
