"""Laws of the coarse surface: how many vertices, which pieces, and where points lie on it."""

from __future__ import annotations

import numpy as np
import pytest

from solver.coarse.closest import NearbySurface, nearest_in_triangles
from solver.coarse.simplification import Simplification, simplify
from solver.geometry.topology import Topology
from solver.types import FloatArray, IntArray
from tests.solver import shapes

SURFACES = {
    "tube": shapes.tube(60, 24),
    "bumpy plane": shapes.bumpy_plane(40),
    "sphere": shapes.sphere(4),
}


def simplified(surface: shapes.Surface, count: int) -> Simplification:
    V, F = surface
    return simplify(V, Topology(F, len(V)), count)


def boundary_length(P: FloatArray, F: IntArray) -> float:
    topology = Topology(F, len(P))
    ends = P[topology.edges[topology.valence == 1]]
    return float(np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1).sum())


@pytest.mark.parametrize("name", SURFACES)
@pytest.mark.parametrize("count", [100, 400])
def test_no_more_vertices_than_asked_for_and_all_of_them_on_the_surface(
    name: str, count: int
) -> None:
    V, F = SURFACES[name]
    coarse = simplified((V, F), count)
    assert 0.9 * count <= len(coarse.vertices) <= count
    assert len(np.unique(coarse.faces)) == len(coarse.vertices)
    assert np.array_equal(np.unique(coarse.cell), np.arange(len(coarse.vertices)))
    distance = [
        nearest_in_triangles(np.tile(p, (len(F), 1)), V[F])[1].min() for p in coarse.vertices[::7]
    ]
    assert max(distance) < 1e-20


@pytest.mark.parametrize("name", SURFACES)
def test_edges_are_about_equally_long_on_flat_and_on_round_parts(name: str) -> None:
    coarse = simplified(SURFACES[name], 300)
    edges = Topology(coarse.faces, len(coarse.vertices)).edges
    length = np.linalg.norm(np.diff(coarse.vertices[edges], axis=1)[:, 0], axis=1)
    low, high = np.quantile(length, [0.1, 0.9])
    assert high < 2.5 * low


def test_a_boundary_stays_where_it_is() -> None:
    V, F = SURFACES["tube"]
    coarse = simplified((V, F), 300)
    assert boundary_length(coarse.vertices, coarse.faces) == pytest.approx(
        boundary_length(V, F), rel=0.05
    )
    assert np.allclose([coarse.vertices[:, 0].min(), coarse.vertices[:, 0].max()], [0, 8])


def test_every_piece_survives_by_itself_and_a_small_one_as_it_is() -> None:
    V, F = SURFACES["sphere"]
    triangle = np.array([[3.0, 0, 0], [4, 0, 0], [3, 1, 0]]), np.array([[0, 1, 2]])
    touching = V + [2.0, 0, 0], F
    fine = shapes.together((V, F), triangle, touching)
    coarse = simplified(fine, 300)
    component = Topology(fine[1], len(fine[0])).vertex_component
    own = Topology(coarse.faces, len(coarse.vertices)).vertex_component
    assert own.max() == 2
    assert np.array_equal(own[coarse.cell], component)
    assert np.array_equal(coarse.vertices[coarse.cell[len(V) : len(V) + 3]], triangle[0])


def test_an_unreferenced_vertex_belongs_to_no_cell() -> None:
    V, F = SURFACES["sphere"]
    coarse = simplified((np.vstack([V, [[9.0, 9, 9]]]), F), 200)
    assert coarse.cell[-1] == -1
    assert (coarse.cell[:-1] >= 0).all()


def test_a_flap_on_a_branching_edge_does_not_keep_a_piece_fine() -> None:
    V, F = SURFACES["bumpy plane"]
    wall = np.flatnonzero(np.abs(V[:, 0] - 20) < 0.1)
    top = np.arange(len(wall)) + len(V)
    a, b, c, d = wall[:-1], wall[1:], top[1:], top[:-1]
    flap = np.concatenate([np.column_stack([a, b, c]), np.column_stack([a, c, d])])
    coarse = simplified((np.vstack([V, V[wall] + [0, 0, 1.0]]), np.vstack([F, flap])), 300)
    assert len(coarse.vertices) <= 300
    assert Topology(coarse.faces, len(coarse.vertices)).vertex_component.max() == 0


@pytest.mark.parametrize("name", SURFACES)
def test_closest_points_are_those_of_the_definition(name: str) -> None:
    V, F = SURFACES[name]
    coarse = simplified((V, F), 300)
    P, T = coarse.vertices, coarse.faces
    some = np.arange(0, len(V), 11)
    face, weights = NearbySurface(P, T).closest(V[some], coarse.cell[some])
    assert np.allclose(weights.sum(axis=1), 1)
    found = np.linalg.norm(V[some] - np.einsum("ij,ijk->ik", weights, P[T[face]]), axis=1)
    for vertex, distance in zip(some, found, strict=True):
        least = nearest_in_triangles(np.tile(V[vertex], (len(T), 1)), P[T])[1].min()
        assert distance == pytest.approx(np.sqrt(least), abs=1e-9)


def test_the_other_side_of_a_thin_sheet_is_not_taken_for_this_one() -> None:
    V, F = shapes.grid(40, 40)
    n = len(V)
    below = V + [0, 0, -1e-3], F[:, ::-1]
    rim = np.flatnonzero(V[:, 0] == 0)
    a, b = rim[:-1], rim[1:]
    side = np.concatenate([np.column_stack([a, b, b + n]), np.column_stack([a, b + n, a + n])])
    thin, faces = shapes.together((V, F), below)
    coarse = simplified((thin, np.vstack([faces, side])), 300)
    far = np.flatnonzero(V[:, 0] > 10)
    surface = NearbySurface(coarse.vertices, coarse.faces)
    for start in (0, n):
        face, _ = surface.closest(thin[far + start], coarse.cell[far + start])
        assert np.allclose(coarse.vertices[coarse.faces[face]][:, :, 2], thin[start, 2])
