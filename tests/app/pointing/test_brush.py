from __future__ import annotations

import numpy as np

from app.pointing.brush import Neighbours
from app.pointing.picking import Hit, Picker
from app.viewpoint.camera import Ray
from solver import Mesh
from solver.softness.falloff import falloff
from solver.types import FloatArray
from tests.app.person import sheet, slab


def hit_from_above(mesh: Mesh, x: float, y: float) -> Hit:
    ray = Ray(np.array([x, y, 50.0]), np.array([0.0, 0.0, -1.0]))
    hit = Picker(mesh.vertices, mesh.faces).pick(ray, mesh.vertices)
    assert hit is not None
    return hit


def neighbours(mesh: Mesh) -> Neighbours:
    return Neighbours(mesh.vertices, mesh.faces)


def test_a_brush_takes_the_disc_around_the_hit() -> None:
    mesh = Mesh.from_arrays(*sheet(20, 20))
    vertices, _ = neighbours(mesh).dab(mesh.vertices, hit_from_above(mesh, 9.8, 10.1), 3.3)
    away = np.linalg.norm(mesh.vertices - [9.8, 10.1, 0], axis=1)
    np.testing.assert_array_equal(np.sort(vertices), np.flatnonzero(away < 3.3))


def test_the_far_side_of_a_thin_part_is_not_reached() -> None:
    mesh = slab(20, 20, 0.1)
    upper = len(mesh.vertices) // 2
    inner, _ = neighbours(mesh).dab(mesh.vertices, hit_from_above(mesh, 10, 10), 4.0)
    assert len(inner) > 30
    assert inner.max() < upper
    # Near the rim the surface leads there within the radius.
    rim, _ = neighbours(mesh).dab(mesh.vertices, hit_from_above(mesh, 1, 10), 4.0)
    assert rim.max() >= upper


def test_the_nearest_vertex_is_taken_by_the_smallest_brush() -> None:
    mesh = Mesh.from_arrays(*sheet(4, 4))
    vertices, weights = neighbours(mesh).dab(mesh.vertices, hit_from_above(mesh, 1.4, 2.3), 1e-3)
    assert mesh.vertices[vertices].tolist() == [[1, 2, 0]]
    assert weights.tolist() == [1]


def test_vertices_no_face_uses_are_never_painted() -> None:
    V, F = sheet(4, 4)
    mesh = Mesh.from_arrays(np.vstack([V, [2.0, 2.0, 0.1]]), F)
    vertices, _ = neighbours(mesh).dab(mesh.vertices, hit_from_above(mesh, 2, 2), 10.0)
    np.testing.assert_array_equal(np.sort(vertices), np.arange(len(V)))


def test_the_falloff_is_smooth_monotone_and_ends_flat_at_the_rim() -> None:
    t = np.linspace(0, 1.5, 3001)
    w = falloff(t)
    slope = np.diff(w) / np.diff(t)
    assert w[0] == 1
    assert (w[t >= 1] == 0).all()
    assert (slope <= 0).all()
    # C1: the slope has no jump, and is 0 at the centre and at the rim.
    assert np.abs(np.diff(slope)).max() < 0.01
    assert abs(slope[0]) < 0.01
    assert abs(slope[t[:-1] >= 0.999][0]) < 0.01


def test_weights_fall_with_the_distance_from_the_path() -> None:
    mesh = Mesh.from_arrays(*sheet(30, 30))
    start: FloatArray = np.array([8.0, 15.0, 0.0])
    vertices, weights = neighbours(mesh).dab(
        mesh.vertices, hit_from_above(mesh, 20, 15), 5.0, start
    )
    x, y = mesh.vertices[vertices, 0], mesh.vertices[vertices, 1]
    away = np.hypot(x - np.clip(x, 8, 20), y - 15)
    order = np.argsort(away)
    assert (np.diff(weights[order]) <= 1e-12).all()
    np.testing.assert_allclose(weights[away < 1e-12], 1)
