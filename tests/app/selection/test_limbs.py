"""Limbs of the bundled figures: what a click takes."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from app.bundled import ASSETS
from app.selection import limbs as module
from app.selection.limbs import Limbs
from solver import Mesh, load_mesh
from solver.geometry.topology import Topology, components
from solver.types import BoolArray
from tests.app.person import sheet

Point = tuple[float, float, float]


@cache
def figure(name: str) -> tuple[Mesh, Limbs]:
    mesh = load_mesh(ASSETS / f"{name}.obj")
    return mesh, Limbs(mesh.vertices, mesh.faces)


def nearest(mesh: Mesh, point: Point) -> int:
    return int(np.linalg.norm(mesh.vertices - point, axis=1).argmin())


def limbs_at(name: str, point: Point) -> tuple[Mesh, list[BoolArray]]:
    mesh, limbs = figure(name)
    return mesh, list(limbs.around(nearest(mesh, point)))


def loops(mesh: Mesh, region: BoolArray) -> int:
    """How many loops the border of a region of a closed surface has."""
    topology = Topology(mesh.faces, len(mesh.vertices))
    leaves = region[topology.edges].sum(axis=1) == 1
    at = topology.half_edge_edge
    pairs = np.array([row[leaves[row]] for row in at if leaves[row].any()])
    return len(np.unique(components(pairs, len(leaves))[leaves]))


Box = tuple[tuple[float, float], tuple[float, float], tuple[float, float]]
ANY = (-9.0, 9.0)
# Where a person clicks, and a box that is taken whole, within one that nothing else is taken from.
TAKES: list[tuple[str, Point, Box, Box]] = [
    ("mannequin", (0.8, 1.425, 0.06), ((0.74, 9), ANY, ANY), ((0.66, 9), ANY, ANY)),  # hand
    ("mannequin", (0.6, 1.43, 0.03), ((0.5, 9), ANY, ANY), ((0.4, 9), ANY, ANY)),  # to the elbow
    ("mannequin", (0.3, 1.42, 0.05), ((0.3, 9), ANY, ANY), ((0.16, 9), ANY, ANY)),  # arm
    ("mannequin", (-0.3, 1.42, 0.05), ((-9, -0.3), ANY, ANY), ((-9, -0.16), ANY, ANY)),
    ("mannequin", (0.0, 1.7, 0.1), (ANY, (1.6, 9), ANY), (ANY, (1.5, 9), ANY)),  # head
    ("cactus", (-0.6, 1.5, 0.0), ((-9, -0.4), ANY, ANY), ((-9, -0.25), ANY, ANY)),
    ("cactus", (0.0, 1.9, 0.1), ((-0.25, 0.25), (1.5, 9), ANY), ((-0.3, 0.3), (1.3, 9), ANY)),
    ("dog", (0.2, 0.3, 0.75), ((0.05, 9), (-9, 0.2), (0.5, 9)), ((0, 9), (-9, 0.6), (0.4, 9))),
    ("dog", (0.0, 1.3, 1.2), (ANY, (0.9, 9), (0.9, 9)), (ANY, (0.5, 9), (0.4, 9))),  # head, neck
]


def within(mesh: Mesh, box: Box) -> BoolArray:
    low, high = np.array(box).T
    return np.asarray(((mesh.vertices >= low) & (mesh.vertices <= high)).all(axis=1))


@pytest.mark.parametrize(("name", "point", "inner", "outer"), TAKES)
def test_a_click_takes_what_is_beyond_the_nearest_neck_or_joint(
    name: str, point: Point, inner: Box, outer: Box
) -> None:
    mesh, (limb, *_) = limbs_at(name, point)
    assert within(mesh, inner).any()
    assert limb[within(mesh, inner)].all()
    assert not limb[~within(mesh, outer)].any()


def test_a_second_limb_is_the_whole_arm() -> None:
    hand, upper = (limbs_at("mannequin", (x, 1.425, 0.05))[1] for x in (0.8, 0.3))
    np.testing.assert_array_equal(hand[2], upper[0])


def test_a_leg_is_taken_from_the_thigh_and_its_foot_from_the_toes() -> None:
    mesh, found = limbs_at("mannequin", (0.11, 0.7, 0.08))
    x, y, _ = mesh.vertices.T
    assert found[0][(x > 0) & (y < 0.75)].all()
    assert not found[0][(x < 0) | (y > 0.95)].any()
    _, smaller = limbs_at("mannequin", (0.12, 0.03, 0.14))
    assert y[smaller[0]].max() < 0.25
    np.testing.assert_array_equal(smaller[-1][found[0]], True)


PLACES: list[tuple[str, Point]] = [
    ("mannequin", (0.9, 1.425, 0.02)),
    ("mannequin", (-0.4, 1.42, 0.03)),
    ("mannequin", (0.1, 0.3, 0.1)),
    ("mannequin", (0.0, 1.55, 0.07)),
    ("cactus", (0.6, 1.2, 0.0)),
    ("cactus", (-0.6, 1.7, 0.0)),
    ("dog", (0.2, 0.3, 0.75)),
    ("dog", (0.0, 1.2, -0.7)),
]


@pytest.mark.parametrize(("name", "point"), PLACES)
def test_a_limb_holds_the_click_and_ends_in_one_loop_and_each_holds_the_one_before(
    name: str, point: Point
) -> None:
    mesh, found = limbs_at(name, point)
    assert found
    before = np.zeros(len(mesh.vertices), dtype=bool)
    for limb in found:
        assert limb[nearest(mesh, point)]
        assert loops(mesh, limb) == 1
        assert limb[before].all()
        assert limb.sum() > before.sum()
        before = limb


def test_the_middle_of_a_body_is_no_limb() -> None:
    assert limbs_at("mannequin", (0.0, 1.1, 0.1))[1] == []
    flat = Mesh.from_arrays(*sheet(12, 12))
    assert list(Limbs(flat.vertices, flat.faces).around(6 * 13 + 6)) == []


def test_a_simplified_surface_has_the_same_limbs(monkeypatch: pytest.MonkeyPatch) -> None:
    mesh, exact = limbs_at("mannequin", (0.6, 1.43, 0.03))
    monkeypatch.setattr(module, "LARGE", 2000)
    vertex = nearest(mesh, (0.6, 1.43, 0.03))
    rough = list(Limbs(mesh.vertices, mesh.faces).around(vertex))
    assert rough[0][vertex]
    assert loops(mesh, rough[0]) == 1
    assert (rough[0] != exact[0]).sum() < 0.1 * exact[0].sum()


def test_seams_and_vertices_of_no_face_are_no_obstacle() -> None:
    mesh, exact = limbs_at("dog", (0.2, 0.3, 0.75))
    apart = mesh.vertices[mesh.faces.ravel()]
    vertices = np.vstack([[[9.0, 9.0, 9.0]], apart])
    limbs = Limbs(vertices, 1 + np.arange(len(apart)).reshape(-1, 3))
    corner = int(np.flatnonzero(mesh.faces.ravel() == nearest(mesh, (0.2, 0.3, 0.75)))[0])
    limb = next(limbs.around(1 + corner))
    assert not limb[0]
    assert (limb[1:] != exact[0][mesh.faces.ravel()]).mean() < 0.01


@pytest.mark.parametrize(
    ("vertices", "faces"),
    [
        ([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]),
        ([[0, 0, 0], [0, 0, 0], [0, 0, 0]], [[0, 1, 2]]),
        ([[0, 0, 0], [1, 0, 0], [2, 0, 0], [3, 0, 0]], [[0, 1, 2], [1, 2, 3]]),
        ([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 1]]),
    ],
)
@pytest.mark.filterwarnings("error")
def test_what_has_no_area_or_hardly_any_triangles_has_no_limbs(
    vertices: list[list[float]], faces: list[list[int]]
) -> None:
    limbs = Limbs(np.array(vertices, dtype=float), np.array(faces))
    assert list(limbs.around(0)) == []
