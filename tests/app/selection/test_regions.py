"""Regions grown, shrunk and smoothed."""

from __future__ import annotations

import numpy as np

from app.pointing.brush import Neighbours
from app.selection.regions import grown, shrunk, smoothed_region
from solver.geometry.cross_products import triangle_areas, vertex_areas
from solver.types import BoolArray
from tests.app.person import sheet, slab

V, F = sheet(30, 20)
GRAPH = Neighbours(V, F).graph


def disc(radius: float) -> BoolArray:
    return np.asarray(np.linalg.norm(V - [15, 10, 0], axis=1) < radius)


def border(region: BoolArray) -> int:
    """How many edges leave a region."""
    a, b = Neighbours(V, F).edges.T
    return int((region[a] != region[b]).sum())


def test_a_ring_more_is_the_neighbours_and_a_ring_less_what_has_none_outside() -> None:
    region = disc(5.2)
    larger, smaller = grown(GRAPH, region), shrunk(GRAPH, region)
    for vertex in range(len(V)):
        around = GRAPH[[vertex]].indices
        assert larger[vertex] == (region[vertex] or region[around].any())
        assert smaller[vertex] == (region[vertex] and region[around].all())


def test_a_region_grows_over_a_seam() -> None:
    """Two sheets that meet along an edge, on vertices of their own."""
    left, faces = sheet(4, 4)
    vertices = np.vstack([left, left + [4, 0, 0]])
    graph = Neighbours(vertices, np.vstack([faces, faces + len(left)])).graph
    region = np.arange(len(vertices)) < len(left)
    more = vertices[grown(graph, region) & ~region]
    assert set(more[:, 0]) == {4.0}


def test_a_smooth_border_is_shorter_and_keeps_the_area() -> None:
    area = vertex_areas(triangle_areas(V, F), F, len(V))
    ragged = disc(6.3)
    ragged ^= (np.abs(np.linalg.norm(V - [15, 10, 0], axis=1) - 6) < 1.3) & (V[:, 1] % 2 == 0)
    smooth = smoothed_region(GRAPH, ragged, area)
    assert border(smooth) < 0.8 * border(ragged)
    assert abs(area[smooth].sum() - area[ragged].sum()) <= area.max()
    np.testing.assert_array_equal(smooth[disc(3)], True)
    assert not smooth[~disc(9)].any()


def test_what_has_no_border_has_nothing_to_smooth() -> None:
    for region in (np.zeros(len(V), dtype=bool), np.ones(len(V), dtype=bool)):
        np.testing.assert_array_equal(smoothed_region(GRAPH, region, np.ones(len(V))), region)


def test_areas_of_vertices_add_up_to_that_of_the_surface() -> None:
    mesh = slab(6, 3, 2.0)
    areas = triangle_areas(mesh.vertices, mesh.faces)
    shares = vertex_areas(areas, mesh.faces, len(mesh.vertices))
    assert np.isclose(shares.sum(), 2 * (18 + 12 + 6))
