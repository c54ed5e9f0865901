"""A saved file is the one that was read, but for what was deformed."""

from __future__ import annotations

import copy
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from solver.mesh.mesh import load_mesh
from solver.types import FloatArray
from tests.solver.mesh.formats.gltf.scenes import (
    TURN,
    F,
    P,
    Scene,
    bent,
    skinned,
    strip,
    unpack,
    values,
)

NORMALS = np.random.default_rng(1).normal(size=(6, 3))
NORMALS /= np.linalg.norm(NORMALS, axis=1, keepdims=True)


def everything() -> Scene:
    """A scene with something of each kind that no deformation changes."""
    scene, primitive = strip(NORMAL=NORMALS, TEXCOORD_0=P, _AGE=P)
    scene.json["nodes"][0] |= trs_members()
    primitive |= {"material": 0, "targets": [{"POSITION": scene.positions(P * 0.1)}]}
    primitive["extras"] = {"Größe": [1.5, None]}
    image = scene.view(b"not really a PNG")
    times, turns = scene.accessor([0, 1.5]), scene.accessor([[0, 0, 0, 1], [0, 1, 0, 0]])
    scene.json |= {
        "extensionsUsed": ["VENDOR_thing"],
        "extensions": {"VENDOR_thing": {"accessor": 0, "deep": [[{}]]}},
        "extras": "any",
        "materials": [{"name": "skin", "extensions": {"VENDOR_thing": {"1": 1e-7}}}],
        "images": [{"bufferView": image, "mimeType": "image/png"}],
        "textures": [{"source": 0}],
        "cameras": [{"type": "perspective", "perspective": {"yfov": 1, "znear": 0.1}}],
        "animations": [
            {
                "channels": [{"sampler": 0, "target": {"node": 0, "path": "rotation"}}],
                "samplers": [{"input": times, "output": turns}],
            }
        ],
        "unknown": {"kept": True},
    }
    return scene


def trs_members() -> dict[str, list[float]]:
    quaternion = TURN.as_quat().tolist()
    return {"translation": [1, 2, 3], "rotation": quaternion, "scale": [2, 2, 2]}


@pytest.mark.parametrize("name", ["a.glb", "a.gltf"])
def test_a_file_saved_as_it_was_has_the_same_bytes(tmp_path: Path, name: str) -> None:
    mesh = everything().load(tmp_path, name)
    (tmp_path / "elsewhere").mkdir()
    for path in (tmp_path / f"again-{name}", tmp_path / "elsewhere" / name):
        mesh.save(path, mesh.vertices)
        assert path.read_bytes() == (tmp_path / name).read_bytes()


@pytest.mark.parametrize("name", ["a.glb", "a.gltf"])
def test_everything_else_stays(tmp_path: Path, name: str) -> None:
    scene = everything()
    mesh = scene.load(tmp_path, name)
    mesh.save(tmp_path / f"out-{name}", bent(mesh.vertices))
    root, data = unpack(tmp_path / f"out-{name}")
    before, old = unpack(tmp_path / name)
    attributes = scene.json["meshes"][0]["primitives"][0]["attributes"]
    position, normal = attributes["POSITION"], attributes["NORMAL"]
    stored = values(tmp_path / f"out-{name}", position)
    expected = copy.deepcopy(before)
    expected["accessors"][position]["min"] = stored.min(axis=0).tolist()
    expected["accessors"][position]["max"] = stored.max(axis=0).tolist()
    if name == "a.gltf":
        expected["buffers"][0]["uri"] = root["buffers"][0]["uri"]
    assert root == expected
    kept = np.ones(len(old), dtype=bool)
    for number in (position, normal):
        start = before["bufferViews"][before["accessors"][number]["bufferView"]]["byteOffset"]
        kept[start : start + 72] = False
    a, b = (np.frombuffer(part, np.uint8) for part in (old, data))
    np.testing.assert_array_equal(a[kept], b[kept])


@pytest.mark.parametrize("source", ["a.glb", "a.gltf"])
@pytest.mark.parametrize("target", ["b.glb", "b.gltf"])
def test_positions_come_back(tmp_path: Path, source: str, target: str) -> None:
    mesh = everything().load(tmp_path, source)
    X = bent(mesh.vertices)
    mesh.save(tmp_path / target, X)
    again = load_mesh(tmp_path / target)
    np.testing.assert_allclose(again.vertices, X, atol=1e-6)
    assert again.faces.tolist() == mesh.faces.tolist()
    assert again.extras == mesh.extras


def test_vertices_that_did_not_move_keep_their_bytes(tmp_path: Path) -> None:
    V = P.copy()
    V[3] = -0.0, 1 / 3, 1e-40
    scene, _ = strip(V)
    scene.json["nodes"][0] |= trs_members()
    mesh = scene.load(tmp_path)
    X = mesh.vertices.copy()
    X[0] += 1
    mesh.save(tmp_path / "out.glb", X)
    after = values(tmp_path / "out.glb", 0)
    assert after[1:].tobytes() == V[1:].astype("<f4").tobytes()
    assert (after[0] != V[0]).any()


def test_a_skinned_mesh_is_written_in_its_own_space(tmp_path: Path) -> None:
    scene, transforms, joints, weights = skinned()
    mesh = scene.load(tmp_path)
    X = bent(mesh.vertices)
    mesh.save(tmp_path / "out.glb", X)
    np.testing.assert_allclose(load_mesh(tmp_path / "out.glb").vertices, X, atol=1e-6)
    share = weights / weights.sum(axis=1, keepdims=True)
    blended = np.einsum("ij,ijab->iab", share, transforms[joints])
    expected = [np.linalg.solve(A, [*x, 1])[:3] for A, x in zip(blended, X, strict=True)]
    np.testing.assert_allclose(values(tmp_path / "out.glb", 0), expected, atol=1e-5)


def test_normals_and_tangents_turn_with_the_surface(tmp_path: Path) -> None:
    tangents = np.column_stack([np.roll(NORMALS, 1, axis=1), [1, -1, 1, -1, 1, -1]])
    scene, primitive = strip(NORMAL=NORMALS, TANGENT=tangents)
    place = trs_members()
    scene.json["nodes"][0] |= place
    mesh = scene.load(tmp_path)
    spin = Rotation.from_rotvec([0.4, 1.0, -0.2])
    mesh.save(tmp_path / "out.glb", spin.apply(mesh.vertices.copy()))
    local = TURN.inv() * spin * TURN
    normals, turned = (
        values(tmp_path / "out.glb", primitive["attributes"][key]) for key in ("NORMAL", "TANGENT")
    )
    np.testing.assert_allclose(normals, local.apply(NORMALS), atol=1e-6)
    np.testing.assert_allclose(turned[:, :3], local.apply(tangents[:, :3]), atol=1e-6)
    assert turned[:, 3].tolist() == tangents[:, 3].tolist()


def test_a_normal_stays_across_its_surface_under_uneven_scales(tmp_path: Path) -> None:
    across = np.cross(P[1] - P[0], P[2] - P[0])
    scene = Scene()
    attributes = {
        "POSITION": scene.positions(P[:3]),
        "NORMAL": scene.accessor(np.tile(across / np.linalg.norm(across), (3, 1))),
    }
    scene.node(mesh=scene.mesh({"attributes": attributes}), scale=[1, 5, 0.5])
    mesh = scene.load(tmp_path)
    mesh.save(tmp_path / "out.glb", Rotation.from_rotvec([1, 0, 0]).apply(mesh.vertices.copy()))
    a, b, c = values(tmp_path / "out.glb", attributes["POSITION"])
    normals = values(tmp_path / "out.glb", attributes["NORMAL"])
    np.testing.assert_allclose(normals @ np.stack([b - a, c - a], axis=1), 0, atol=1e-6)
    np.testing.assert_allclose(np.linalg.norm(normals, axis=1), 1, atol=1e-6)


@pytest.mark.parametrize("normals", [NORMALS[:4], NORMALS[:, :1], NORMALS * np.nan])
def test_normals_that_make_no_sense_stay(tmp_path: Path, normals: FloatArray) -> None:
    scene, primitive = strip(NORMAL=normals)
    mesh = scene.load(tmp_path)
    mesh.save(tmp_path / "out.glb", bent(mesh.vertices))
    after = values(tmp_path / "out.glb", primitive["attributes"]["NORMAL"])
    np.testing.assert_array_equal(after, normals.astype("<f4"))


def test_a_flat_scale_saves_what_can_be_told(tmp_path: Path) -> None:
    scene, _ = strip()
    scene.json["nodes"][0]["scale"] = [1, 1, 0]
    mesh = scene.load(tmp_path)
    X = mesh.vertices + [1, 2, 0]
    mesh.save(tmp_path / "out.glb", X)
    np.testing.assert_allclose(load_mesh(tmp_path / "out.glb").vertices, X, atol=1e-6)
    assert mesh.faces.tolist() == F.tolist()
