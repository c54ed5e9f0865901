"""Which vertices are seen, against rays to each of them."""

from __future__ import annotations

import numpy as np
import pytest

from app.bundled import ASSETS
from app.pointing.brush import Neighbours
from app.pointing.picking import Picker
from app.selection.sight import CELL, in_sight
from app.viewpoint.camera import FIELD_OF_VIEW, Camera, Ray
from solver import Mesh, load_mesh
from solver.types import BoolArray, FloatArray
from tests.app.person import sheet, slab

SIZE = (1280.0, 800.0)


def camera_at(mesh: Mesh, eye: tuple[float, float, float]) -> Camera:
    middle = mesh.vertices.mean(axis=0)
    return Camera.look_at(middle + np.array(eye), middle, FIELD_OF_VIEW, SIZE)


def seen(mesh: Mesh, camera: Camera) -> BoolArray:
    pixels = camera.project(mesh.vertices)
    shown = np.flatnonzero(((pixels >= 0) & (pixels <= SIZE)).all(axis=1))
    solid = Neighbours(mesh.vertices, mesh.faces).solid
    result = np.zeros(len(pixels), dtype=bool)
    result[shown] = in_sight(camera, mesh.vertices, mesh.faces, shown, solid)
    return result


def met_first(mesh: Mesh, camera: Camera) -> BoolArray:
    """(n,) the vertices that a ray to them meets before anything else."""
    picker = Picker(mesh.vertices, mesh.faces)

    def free(vertex: FloatArray) -> bool:
        away = vertex - camera.position
        hit = picker.pick(Ray(camera.position, away / np.linalg.norm(away)), mesh.vertices)
        return hit is None or bool(hit.distance > np.linalg.norm(away) * (1 - 1e-6))

    return np.array([free(vertex) for vertex in mesh.vertices])


@pytest.mark.parametrize("name", ["cactus", "dog"])
@pytest.mark.parametrize("eye", [(0.0, 0.0, 5.0), (3.0, 1.0, 2.0)])
def test_what_is_seen_is_what_rays_meet(name: str, eye: tuple[float, float, float]) -> None:
    mesh = load_mesh(ASSETS / f"{name}.obj")
    camera = camera_at(mesh, eye)
    fast, slow = seen(mesh, camera), met_first(mesh, camera)
    assert 0.2 < slow.mean() < 0.8
    assert (slow & ~fast).mean() < 0.002, "nothing that is seen is left out"
    assert (fast & ~slow).mean() < 0.02, "no more than a rim is taken too much"


@pytest.mark.parametrize("eye", [(0, 0, 70), (0, 0, -70), (40, 0, -60), (0, -60, 50)])
def test_a_rough_sheet_hides_nothing_from_either_side(eye: tuple[float, float, float]) -> None:
    V, F = sheet(60, 40)
    V[:, 2] = 0.15 * np.sin(2.1 * V[:, 0]) * np.sin(1.7 * V[:, 1])
    mesh = Mesh.from_arrays(V, F)
    assert seen(mesh, camera_at(mesh, eye)).all()


@pytest.mark.parametrize("thickness", [0.01, 0.5])
def test_the_far_side_of_a_closed_slab_is_hidden(thickness: float) -> None:
    mesh = slab(20, 20, thickness)
    upper = np.arange(len(mesh.vertices)) < len(mesh.vertices) // 2
    np.testing.assert_array_equal(seen(mesh, camera_at(mesh, (0, 0, 30))), upper)
    np.testing.assert_array_equal(seen(mesh, camera_at(mesh, (0, 0, -30))), ~upper)


def test_a_near_square_hides_what_is_behind_it_and_no_more() -> None:
    """Two large triangles before a fine sheet."""
    V, F = sheet(40, 40)
    cover = np.array([[10, 10, 5], [30, 10, 5], [30, 30, 5], [10, 30, 5]], dtype=float)
    faces = np.vstack([F, len(V) + np.array([[0, 1, 2], [0, 2, 3]])])
    mesh = Mesh.from_arrays(np.vstack([V, cover]), faces)
    camera = Camera.look_at([20, 20, 60], [20, 20, 0], FIELD_OF_VIEW, SIZE)
    pixels = camera.project(mesh.vertices)
    low, high = pixels[-4:].min(axis=0), pixels[-4:].max(axis=0)
    beyond = np.maximum(low - pixels, pixels - high).max(axis=1)  # negative behind the square
    sight = seen(mesh, camera)
    assert sight[-4:].all()
    assert sight[beyond > 0].all()
    assert not sight[:-4][beyond[:-4] < -3 * CELL].any()


def test_what_is_behind_the_camera_is_no_obstacle() -> None:
    """One of two sheets is behind it, and a third reaches from there to before it."""
    V, F = sheet(10, 10)
    floor = np.array([[-50.0, -2, 40], [60, -2, 40], [5, -2, -60]])
    vertices = np.vstack([V, V + [0, 0, 40], floor])
    faces = np.vstack([F, F + len(V), 2 * len(V) + np.array([[0, 1, 2]])])
    mesh = Mesh.from_arrays(vertices, faces)
    camera = Camera.look_at([5, 5, 20], [5, 5, 0], FIELD_OF_VIEW, SIZE)
    assert seen(mesh, camera)[: len(V)].all()
    assert not seen(mesh, camera)[len(V) : 2 * len(V)].any()


def test_nothing_asked_nothing_seen() -> None:
    mesh = slab(2, 2, 1.0)
    camera = camera_at(mesh, (0, 0, 9))
    none = np.empty(0, dtype=np.int64)
    solid = np.ones(len(mesh.vertices), dtype=bool)
    assert len(in_sight(camera, mesh.vertices, mesh.faces, none, solid)) == 0


def test_closed_pieces_are_solid_and_open_or_turned_ones_are_not() -> None:
    box, (V, F) = slab(4, 4, 1.0), sheet(4, 4, 9.0)
    n = len(box.vertices)
    vertices = np.vstack([box.vertices, V, box.vertices + [20, 0, 0]])
    faces = np.vstack([box.faces, F + n, box.faces[:, ::-1] + n + len(V)])
    solid = Neighbours(vertices, faces).solid
    np.testing.assert_array_equal(np.flatnonzero(solid), np.arange(n))


def test_a_seam_leaves_a_piece_solid() -> None:
    """Every triangle of a box on vertices of its own."""
    box = slab(4, 4, 1.0)
    apart = box.vertices[box.faces.ravel()]
    assert Neighbours(apart, np.arange(len(apart)).reshape(-1, 3)).solid.all()
