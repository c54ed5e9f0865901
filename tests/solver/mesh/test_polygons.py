"""Polygons into triangles: planar ones are covered once, any is split."""

from __future__ import annotations

import numpy as np
import pytest

from solver.mesh.polygons import Polygons, triangulate
from solver.types import FloatArray, IntArray

Outline = list[tuple[float, float]]

SQUARE: Outline = [(0, 0), (1, 0), (1, 1), (0, 1)]
DART: Outline = [(0, 0), (2, -1), (0.5, 0), (2, 1)]
# Its diagonal outside is shorter than the one inside.
ARROW: Outline = [(0, 0), (3, -0.5), (2, 0), (3, 0.5)]
L_SHAPE: Outline = [(0, 0), (3, 0), (3, 1), (1, 1), (1, 3), (0, 3)]
COMB: Outline = [
    (0, 0),
    (7, 0),
    (7, 3),
    (6, 3),
    (6, 1),
    (4, 1),
    (4, 3),
    (3, 3),
    (3, 1),
    (1, 1),
    (1, 3),
    (0, 3),
]
ON_EDGES: Outline = [(0, 0), (1, 0), (2, 0), (2, 1), (2, 2), (1, 2), (0, 2), (0, 1)]
SPIRAL: Outline = [
    (0, 0),
    (5, 0),
    (5, 5),
    (1, 5),
    (1, 2),
    (3, 2),
    (3, 3),
    (2, 3),
    (2, 4),
    (4, 4),
    (4, 1),
    (0, 1),
]
# The diagonal from the left to the right end of the base runs through the point between them.
SPIKE: Outline = [(0, 0), (1, 0), (2, 0), (5.2, 9.9), (5, 10)]
# A square with a square hole, opened by a bridge that is walked twice.
BRIDGED: Outline = [(0, 0), (6, 0), (6, 6), (0, 6), (0, 0), (2, 2), (2, 4), (4, 4), (4, 2), (2, 2)]
STAR: Outline = [
    (r * np.cos(t), r * np.sin(t))
    for r, t in zip([2, 0.7] * 7, np.linspace(0, 2 * np.pi, 14, endpoint=False), strict=True)
]
SHAPES: dict[str, Outline] = {
    "square": SQUARE,
    "dart": DART,
    "arrow": ARROW,
    "L": L_SHAPE,
    "spike": SPIKE,
    "comb": COMB,
    "points on edges": ON_EDGES,
    "spiral": SPIRAL,
    "bridged hole": BRIDGED,
    "star": STAR,
}


def place(outline: Outline, tilt: float, shift: int) -> FloatArray:
    """The outline in a tilted plane, starting at another corner."""
    flat = np.roll(np.array(outline, dtype=float), shift, axis=0)
    u = np.array([np.cos(tilt), np.sin(tilt), 0.3])
    v = np.cross([0.2, -0.5, 1.0], u)
    u, v = u / np.linalg.norm(u), v / np.linalg.norm(v)
    return flat[:, :1] * u + flat[:, 1:] * v + [100.0, -20.0, 3.0]


def area_vectors(P: FloatArray, triangles: IntArray) -> FloatArray:
    a, b, c = (P[triangles[:, k]] for k in range(3))
    return np.asarray(np.cross(b - a, c - a) / 2)


@pytest.mark.parametrize("tilt", [0.0, 1.0, 2.5, 4.0])
@pytest.mark.parametrize("name", SHAPES)
def test_triangles_cover_a_planar_polygon_once_and_face_its_way(name: str, tilt: float) -> None:
    for shift in range(len(SHAPES[name])):
        P = place(SHAPES[name], tilt, shift)
        polygons = Polygons.from_array(np.arange(len(P))[None])
        triangles = polygons.corners[triangulate(P, polygons)]
        areas = area_vectors(P, triangles)
        outline = np.cross(P - P[0], np.roll(P, -1, axis=0) - P[0]).sum(axis=0) / 2
        assert len(triangles) == len(P) - 2
        # Facing the same way with the whole area leaves no room for an overlap.
        assert (areas @ outline > 0).all()
        assert np.linalg.norm(areas, axis=1).sum() == pytest.approx(np.linalg.norm(outline))


@pytest.mark.parametrize("scale", [1e-6, 1.0, 1e6])
def test_a_quad_takes_the_shorter_diagonal_where_both_fit(scale: float) -> None:
    P = scale * np.array([[0, 0, 0], [1, 0, 0], [3, 1, 0], [0, 1, 0.0]])
    polygons = Polygons.from_array(np.array([[0, 1, 2, 3]]))
    triangles = {frozenset(t) for t in triangulate(P, polygons).tolist()}
    assert triangles == {frozenset({0, 1, 3}), frozenset({1, 2, 3})}


def test_a_regular_grid_is_split_one_way() -> None:
    x = np.linspace(0, 1, 8) / 3
    turn = np.array([[np.cos(1), np.sin(1), 0], [-np.sin(1), np.cos(1), 0], [0, 0, 1]])
    V = np.stack([*np.meshgrid(x, x), np.zeros((8, 8))], axis=2).reshape(-1, 3) @ turn
    i = np.arange(64).reshape(8, 8)
    quads = np.stack([i[:-1, :-1], i[:-1, 1:], i[1:, 1:], i[1:, :-1]], axis=2).reshape(-1, 4)
    corners = triangulate(V, Polygons.from_array(quads)) % 4
    assert (corners.reshape(-1, 6) == corners.reshape(-1, 6)[0]).all()


def test_a_strip_is_cut_across() -> None:
    side = np.stack([np.arange(12.0), np.zeros(12), np.zeros(12)], axis=1)
    V = np.concatenate([side, side[::-1] + np.eye(3)[1]])
    polygons = Polygons.from_array(np.arange(24)[None])
    P = V[triangulate(V, polygons)]
    edges = np.linalg.norm(P - np.roll(P, 1, axis=1), axis=2)
    assert edges.max() < 1.5


def test_polygons_of_many_sizes_keep_their_order() -> None:
    outlines = [SQUARE, COMB, DART, L_SHAPE, SQUARE[:3], STAR, COMB]
    V = np.concatenate([place(o, 0.4, 0) + 9.0 * i for i, o in enumerate(outlines)])
    sizes = np.array([len(o) for o in outlines])
    polygons = Polygons(sizes, np.arange(sizes.sum()))
    triangles = polygons.corners[triangulate(V, polygons)]
    owner = np.repeat(np.arange(len(sizes)), sizes)
    np.testing.assert_array_equal(
        owner[triangles], np.repeat(np.repeat(np.arange(len(sizes)), sizes - 2), 3).reshape(-1, 3)
    )
    assert [V[list(face)].tolist() for face in polygons.tolist()][2] == V[16:20].tolist()


@pytest.mark.parametrize("size", [4, 5, 9])
@pytest.mark.parametrize("kind", ["one point", "on a line", "crossing itself", "repeated"])
def test_a_polygon_without_a_proper_plane_is_split_all_the_same(kind: str, size: int) -> None:
    rng = np.random.default_rng(0)
    V = {
        "one point": np.ones((size, 3)),
        "on a line": np.outer(np.arange(size), [1.0, 2.0, 3.0]),
        "crossing itself": rng.normal(size=(size, 3)),
        "repeated": rng.normal(size=(size, 3))[np.arange(size) // 2],
    }[kind]
    polygons = Polygons.from_array(np.arange(size)[None])
    triangles = triangulate(V, polygons)
    assert triangles.shape == (size - 2, 3)
    # Each triangle is cut off along the ring, so every corner is used and none twice in a triangle.
    assert set(triangles.ravel()) == set(range(size))
    assert all(len(set(t)) == 3 for t in triangles.tolist())
