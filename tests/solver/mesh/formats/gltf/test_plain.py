"""A surface from elsewhere as GLB, a GLB as anything else, and other libraries that read them."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import trimesh

from solver.mesh.mesh import Mesh, load_mesh
from tests.solver.mesh.formats.files import load, surface
from tests.solver.mesh.formats.gltf.scenes import P, bent, strip, unpack, values

ASSETS = Path(__file__).resolve().parents[5] / "assets"
CUBE = b"".join(b"v %d %d %d\n" % (x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1))
CUBE += b"f 1 2 4 3\nf 5 7 8 6\nf 1 5 6 2\nf 3 4 8 7\nf 1 3 7 5\nf 2 6 8 4\n"


@pytest.mark.parametrize("name", ["out.glb", "out.gltf"])
def test_an_obj_becomes_a_glb(tmp_path: Path, name: str) -> None:
    mesh = load(tmp_path, "cube.obj", CUBE)
    mesh.save(tmp_path / name, mesh.vertices + 3)
    again = load_mesh(tmp_path / name)
    assert again.vertices.tolist() == (mesh.vertices + 3).tolist()
    assert again.faces.tolist() == mesh.faces.tolist()
    # The corner normals of a cube lie near its diagonals.
    normals = values(tmp_path / name, 1)
    np.testing.assert_allclose(np.linalg.norm(normals, axis=1), 1, atol=1e-6)
    assert ((normals * (mesh.vertices - 0.5)).sum(axis=1) > 0.6).all()


@pytest.mark.parametrize(("count", "kind"), [(65535, 5123), (65536, 5125)])
def test_indices_are_as_narrow_as_they_can_be(tmp_path: Path, count: int, kind: int) -> None:
    V = np.random.default_rng(0).random((count, 3))
    Mesh.from_arrays(V, [[0, 1, count - 1]]).save(tmp_path / "a.glb", V)
    root, _ = unpack(tmp_path / "a.glb")
    assert root["accessors"][2]["componentType"] == kind
    assert load_mesh(tmp_path / "a.glb").faces.tolist() == [[0, 1, count - 1]]


def test_a_surface_far_from_the_origin_keeps_its_detail(tmp_path: Path) -> None:
    V, F = surface()
    V = V + [5e6, -3e5, 0]
    Mesh.from_arrays(V, F).save(tmp_path / "a.glb", V)
    np.testing.assert_allclose(load_mesh(tmp_path / "a.glb").vertices, V, rtol=0, atol=1e-6)


def test_vertices_that_no_face_uses_stay_in_place(tmp_path: Path) -> None:
    Mesh.from_arrays(P, [[5, 1, 3]]).save(tmp_path / "a.glb", P, poses={"a": P + 1})
    assert load_mesh(tmp_path / "a.glb").vertices.tolist() == P.tolist()
    assert values(tmp_path / "a.glb", 1)[0].tolist() == [0, 0, 1]


@pytest.mark.parametrize("suffix", [".obj", ".ply", ".off", ".stl"])
def test_a_glb_becomes_any_other_file(tmp_path: Path, suffix: str) -> None:
    mesh = strip()[0].load(tmp_path)
    X = bent(mesh.vertices)
    mesh.save(tmp_path / f"out{suffix}", X)
    again = load_mesh(tmp_path / f"out{suffix}")
    np.testing.assert_allclose(again.vertices[again.faces], X[mesh.faces], atol=1e-6)


@pytest.mark.parametrize("name", ["out.glb", "out.gltf"])
def test_another_library_reads_what_is_written(tmp_path: Path, name: str) -> None:
    scene, _ = strip()
    scene.json["nodes"][0] |= {"translation": [1, 2, 3], "scale": [2, 2, 2]}
    scene.json["scenes"] = [{"nodes": [0]}]
    mesh = scene.load(tmp_path)
    X = bent(mesh.vertices)
    mesh.save(tmp_path / name, X, poses={"fist": X + 1})
    (other,) = trimesh.load_scene(str(tmp_path / name), process=False).dump()
    assert isinstance(other, trimesh.Trimesh)
    np.testing.assert_allclose(np.asarray(other.vertices), X, atol=1e-6)
    assert np.asarray(other.faces).tolist() == mesh.faces.tolist()


def test_what_another_library_writes_is_read(tmp_path: Path) -> None:
    V, F = surface()
    trimesh.Trimesh(V, F, process=False).export(str(tmp_path / "a.glb"))
    mesh = load_mesh(tmp_path / "a.glb")
    np.testing.assert_allclose(mesh.vertices[mesh.faces], V[F], atol=1e-6)


def grid(columns: int, name: str, first: int, z: float = 0.0) -> tuple[bytes, bytes]:
    """Lines of vertices and, under a name, of quads of a strip of squares from vertex `first`."""
    corners = [(x, y) for x in range(columns + 1) for y in (0, 1)]
    vertices = b"".join(b"v %d %d %g\n" % (x, y, z) for x, y in corners)
    quads = (first + 2 * x for x in range(columns))
    faces = b"".join(b"f %d %d %d %d\n" % (a, a + 2, a + 3, a + 1) for a in quads)
    return vertices, b"o %s\n" % name.encode() + faces


def test_objects_become_nodes_of_their_names_and_vertices_keep_their_order(tmp_path: Path) -> None:
    (low, strip_faces), (high, tile_faces) = grid(3, "strip", 1), grid(1, "tile", 9, 2.0)
    mesh = load(tmp_path, "a.obj", low + high + b"v 9 9 9\n" + tile_faces + strip_faces)
    lifted = mesh.vertices + np.where(mesh.vertices[:, 2:] > 1, [0, 0, 1.0], 0)
    mesh.save(tmp_path / "a.glb", mesh.vertices, poses={"up": lifted})
    again = load_mesh(tmp_path / "a.glb")
    assert again.vertices.tolist() == mesh.vertices.tolist()
    assert again.groups is not None
    assert again.groups.names == ("strip", "tile")
    assert again.groups.of_polygon.tolist() == 6 * [0] + 2 * [1]
    assert sorted(again.faces.tolist()) == sorted(mesh.faces.tolist())
    root, _ = unpack(tmp_path / "a.glb")
    assert [entry["name"] for entry in root["meshes"]] == ["strip", "tile"]
    # The pose moves the tile alone.
    assert [len(entry["primitives"][0].get("targets", [])) for entry in root["meshes"]] == [0, 1]


def test_a_vertex_that_two_groups_use_is_in_both(tmp_path: Path) -> None:
    vertices, faces = grid(2, "left", 1)
    first, second = faces.splitlines()[1:]
    mesh = load(tmp_path, "a.obj", vertices + b"g left\n%s\ng right\n%s\n" % (first, second))
    X = bent(mesh.vertices)
    mesh.save(tmp_path / "a.glb", X)
    again = load_mesh(tmp_path / "a.glb")
    np.testing.assert_allclose(again.vertices[again.faces], X[mesh.faces], atol=1e-6)
    assert (len(again.vertices), again.pieces.max()) == (8, 0)
    # The border does not show: both sides have one normal.
    right, left = values(tmp_path / "a.glb", 1)[2:], values(tmp_path / "a.glb", 4)[:2]
    np.testing.assert_allclose(right, left, atol=1e-6)


@pytest.mark.parametrize(("slope", "smooth"), [(0.3, True), (2.0, False)])
def test_normals_pass_over_a_cut_but_not_over_an_edge(
    tmp_path: Path, slope: float, smooth: bool
) -> None:
    V = np.array([[-1, 0, 0], [0, 0, 0], [0, 1, 0], [0, 0, 0], [1, 0, slope], [0, 1, 0]])
    Mesh.from_arrays(V, [[0, 1, 2], [3, 4, 5]]).save(tmp_path / "a.glb", V)
    normals = values(tmp_path / "a.glb", 1)
    assert np.allclose(normals[1], normals[3], atol=1e-6) == smooth


def test_the_dressed_figure_is_one_surface_in_either_format() -> None:
    obj, glb = (load_mesh(ASSETS / f"dressed{suffix}") for suffix in (".obj", ".glb"))
    np.testing.assert_allclose(glb.vertices, obj.vertices, atol=1e-6)
    assert glb.faces.tolist() == obj.faces.tolist()
    assert obj.groups is not None
    assert glb.groups is not None
    assert glb.groups.names == obj.groups.names
