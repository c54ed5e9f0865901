"""Edges and vertices with very many triangles: the work grows with the mesh, not its square."""

from __future__ import annotations

import numpy as np
import pytest

from solver import Deformer
from solver.geometry.bounding_box import diagonal
from solver.geometry.motions import motion, moved, rotation
from solver.geometry.topology import CROWDED, Topology
from solver.types import FloatArray, IntArray

T = motion(rotation([1, 2, 3], 40), [0.2, 0, 0.1])


def book(pages: int) -> tuple[FloatArray, IntArray]:
    """Triangles around one edge, 0 to 1."""
    angle = 2 * np.pi * np.arange(pages) / pages
    tips = np.column_stack([np.cos(angle), np.sin(angle), np.full(pages, 0.5)])
    faces = np.column_stack([np.zeros(pages), np.ones(pages), 2 + np.arange(pages)])
    return np.vstack([[[0, 0, 0], [0, 0, 1]], tips]), faces.astype(np.int64)


def star(count: int) -> tuple[FloatArray, IntArray]:
    """Triangles that share one vertex, 0, and no edge."""
    angle = np.arange(2 * count)
    tips = np.column_stack([np.cos(angle), np.sin(angle), angle / (2 * count)])
    first = 1 + 2 * np.arange(count)
    return np.vstack([[[0, 0, 0]], tips]), np.column_stack([0 * first, first, first + 1])


def test_every_two_triangles_of_an_edge_are_paired_up_to_a_bound() -> None:
    pairs = Topology(book(CROWDED)[1], CROWDED + 2).pairs
    assert len(pairs.first) == CROWDED * (CROWDED - 1) // 2
    assert (pairs.partners == CROWDED - 1).all()


@pytest.mark.parametrize("pages", [CROWDED + 1, 8000])
def test_beyond_it_each_is_paired_with_the_first(pages: int) -> None:
    pairs = Topology(book(pages)[1], pages + 2).pairs
    assert (pairs.first == 0).all()
    np.testing.assert_array_equal(np.sort(pairs.second), np.arange(1, pages))
    # In the mean over its triangles: the first has all others, each other has the first.
    np.testing.assert_allclose(pairs.partners, 2 * (pages - 1) / pages)


def test_equal_faces_are_paired_at_all_three_edges() -> None:
    pairs = Topology(np.tile([[0, 1, 2]], (20_000, 1)), 3).pairs
    assert len(pairs.first) == 3 * 19_999
    assert (pairs.first != pairs.second).all()


def test_a_repeated_vertex_at_a_crowded_edge_pairs_no_triangle_with_itself() -> None:
    faces = np.vstack([book(40)[1], [[0, 1, 0]]])
    pairs = Topology(faces, 42).pairs
    assert (pairs.first != pairs.second).all()


@pytest.mark.parametrize("rigid", [0, 1, 4])
@pytest.mark.parametrize("coarse", [None, 500])
@pytest.mark.parametrize(
    "surface", [book(2000), star(1000), (book(1)[0], np.tile(book(1)[1], (20_000, 1)))]
)
def test_what_moves_as_one_carries_the_rest(
    surface: tuple[FloatArray, IntArray], coarse: int | None, rigid: int
) -> None:
    V, F = surface
    X = Deformer(V, F, handles=[[0, 1, 2]], coarse=coarse).pose([T], rigid)
    np.testing.assert_allclose(X, moved(T, V), atol=1e-8 * diagonal(V))
