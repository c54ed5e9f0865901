"""Counts of what a mesh is and what is unusual about it."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from solver.mesh.mesh import Mesh, load_mesh
from solver.mesh.statistics import mesh_statistics

TETRAHEDRON = np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])
CORNERS = np.array([[0, 0, 0], [3, 0, 0], [0, 4, 0], [0, 0, 12.0]])


def test_a_closed_surface_has_nothing_unusual() -> None:
    found = mesh_statistics(Mesh.from_arrays(CORNERS, TETRAHEDRON))
    assert (found.vertices, found.triangles, found.polygon_sizes) == (4, 4, {3: 4})
    assert (found.components, found.boundary_edges, found.boundary_loops) == (1, 0, 0)
    assert found.non_manifold_edges == found.degenerate_triangles == found.duplicate_faces == 0
    assert found.isolated_vertices == 0
    assert (found.lower, found.upper, found.diagonal) == ((0, 0, 0), (3, 4, 12), 13)


def test_two_parts_count_as_the_sum_of_each() -> None:
    V = np.concatenate([CORNERS, CORNERS + 20])
    found = mesh_statistics(Mesh.from_arrays(V, np.concatenate([TETRAHEDRON, TETRAHEDRON[1:] + 4])))
    assert (found.components, found.boundary_edges, found.boundary_loops) == (2, 3, 1)


def test_a_surface_cut_along_a_seam_is_one_piece() -> None:
    V = np.concatenate([CORNERS, CORNERS])
    cut = np.concatenate([TETRAHEDRON[:2], TETRAHEDRON[2:] + 4])
    found = mesh_statistics(Mesh.from_arrays(V, cut))
    assert (found.components, found.pieces) == (2, 1)


def test_a_tube_has_two_boundary_loops() -> None:
    t = np.linspace(0, 2 * np.pi, 12, endpoint=False)
    ring = np.stack([np.cos(t), np.sin(t), 0 * t], axis=1)
    i = np.arange(12)
    quads = np.stack([i, (i + 1) % 12, (i + 1) % 12 + 12, i + 12], axis=1)
    found = mesh_statistics(Mesh.from_arrays(np.concatenate([ring, ring + np.eye(3)[2]]), quads))
    assert found.polygon_sizes == {4: 12}
    assert (found.components, found.boundary_edges, found.boundary_loops) == (1, 24, 2)


@pytest.mark.parametrize("scale", [1e-9, 1.0, 1e9])
def test_each_flaw_is_counted(scale: float) -> None:
    V = scale * np.array(
        [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [0, -1, 0], [2, 0, 0], [9, 9, 9]]
    )
    F = [[0, 1, 2], [0, 1, 3], [0, 1, 4], [2, 0, 1], [0, 1, 5], [3, 3, 4]]
    found = mesh_statistics(Mesh.from_arrays(V, F))
    assert found.non_manifold_edges == 1
    assert found.duplicate_faces == 1
    assert found.degenerate_triangles == 2
    assert found.isolated_vertices == 1


def test_what_an_obj_holds_beyond_its_surface(tmp_path: Path) -> None:
    path = tmp_path / "a.obj"
    path.write_bytes(
        b"g one\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 1 1\nvt 0 0\nvt 0 1\nvn 0 0 1\n"
        b"f 1/1/1 2/2/1 3/1/1\ng two\nf 1 2 3 4\n"
    )
    found = mesh_statistics(load_mesh(path))
    assert found.extras == {"texture coordinates": 2, "normals": 1, "objects": 0, "groups": 2}
    assert found.polygon_sizes == {3: 1, 4: 1}
