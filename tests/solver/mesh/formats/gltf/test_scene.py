"""What a file shows is where its scene puts it."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from tests.solver.mesh.formats.gltf.scenes import TURN, F, P, skinned, strip, trs


def test_transforms_of_nodes_add_up_from_child_to_root(tmp_path: Path) -> None:
    scene, _ = strip()
    t, s = [1.0, 2.0, 3.0], [2.0, 1.0, 0.5]
    outer = trs([0, 0, 4], TURN.inv(), [1, 1, 3])
    scene.json["nodes"][0] |= {"translation": t, "rotation": TURN.as_quat().tolist(), "scale": s}
    scene.node(children=[0], matrix=outer.T.ravel().tolist())
    expected = (np.column_stack([P, np.ones(6)]) @ (outer @ trs(t, TURN, s)).T)[:, :3]
    np.testing.assert_allclose(scene.load(tmp_path).vertices, expected, atol=1e-12)


def test_a_mirrored_mesh_keeps_its_outside(tmp_path: Path) -> None:
    scene, _ = strip()
    scene.json["nodes"][0]["scale"] = [-1, 1, 1]
    mesh = scene.load(tmp_path)
    a, b, c = (mesh.vertices[mesh.faces[:, k]] for k in range(3))
    A, B, C = (P[F[:, k]] for k in range(3))
    expected = np.cross(B - A, C - A) * [-1, 1, 1]
    np.testing.assert_allclose(np.cross(b - a, c - a), expected, atol=1e-12)


def test_only_the_default_scene_is_shown(tmp_path: Path) -> None:
    scene, primitive = strip()
    scene.node(mesh=scene.mesh(primitive), translation=[5, 0, 0])
    scene.json |= {"scenes": [{"nodes": [0]}, {"nodes": [1]}], "scene": 1}
    assert scene.load(tmp_path).vertices.tolist() == (P + [5, 0, 0]).tolist()
    del scene.json["scene"]
    assert scene.load(tmp_path).vertices.tolist() == P.tolist()
    del scene.json["scenes"]
    both = np.concatenate([P, P + [5, 0, 0]])
    assert scene.load(tmp_path).vertices.tolist() == both.tolist()


def test_a_mesh_of_several_nodes_is_shown_by_the_first(tmp_path: Path) -> None:
    scene, _ = strip()
    scene.json["nodes"] = [{"mesh": 0, "translation": [k, 0, 0]} for k in (3, 1, 2)]
    mesh = scene.load(tmp_path)
    assert mesh.vertices.tolist() == (P + [3, 0, 0]).tolist()
    assert mesh.extras["instances left out"] == 2


def test_primitives_of_a_mesh_share_the_vertices_of_one_accessor(tmp_path: Path) -> None:
    scene, primitive = strip()
    scene.json["accessors"][1]["count"] = 6
    rest = scene.accessor(F[2:].ravel(), "u2")
    scene.json["meshes"][0]["primitives"].append(primitive | {"indices": rest})
    mesh = scene.load(tmp_path)
    assert mesh.vertices.tolist() == P.tolist()
    assert mesh.faces.tolist() == F.tolist()


def test_nodes_in_a_circle_end(tmp_path: Path) -> None:
    scene, _ = strip()
    scene.json["nodes"][0]["children"] = [1]
    scene.node(children=[0])
    scene.json["scenes"] = [{"nodes": [0]}]
    assert scene.load(tmp_path).vertices.tolist() == P.tolist()


def test_triangles_are_grouped_by_the_names_of_nodes_and_meshes(tmp_path: Path) -> None:
    scene, primitive = strip()
    scene.json["nodes"][0]["name"] = "Körper"
    scene.node(mesh=scene.mesh(primitive, name="hat"))
    scene.node(mesh=scene.mesh(primitive))
    groups = scene.load(tmp_path).groups
    assert groups is not None
    assert groups.names == ("Körper", "hat", "mesh 2")
    assert groups.of_polygon.tolist() == [0] * 4 + [1] * 4 + [2] * 4


def test_a_skin_moves_vertices_by_its_joints_alone(tmp_path: Path) -> None:
    """x = sum over joints of weight (joint's world transform) (inverse bind matrix) x."""
    scene, transforms, joints, weights = skinned()
    expected = np.zeros_like(P)
    for i, p in enumerate(P):
        for j, w in zip(joints[i], weights[i] / weights[i].sum(), strict=True):
            expected[i] += w * (transforms[j] @ [*p, 1])[:3]
    np.testing.assert_allclose(scene.load(tmp_path).vertices, expected, atol=1e-6)


@pytest.mark.parametrize("holder", ["nodes", "meshes"])
def test_default_weights_of_morph_targets_shape_what_is_shown(tmp_path: Path, holder: str) -> None:
    scene, primitive = strip()
    primitive["targets"] = [{"POSITION": scene.positions(P * k)} for k in (1, 2, 4)]
    scene.json["meshes"][0]["weights"] = [0, 0, 0]
    scene.json[holder][0]["weights"] = [1, 0, 0.5]
    mesh = scene.load(tmp_path)
    assert mesh.vertices.tolist() == (P * 4).tolist()
    assert mesh.extras["morph targets"] == 3
