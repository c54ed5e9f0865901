"""Poses become morph targets by name, and those that were there stay."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from solver.errors import MeshError
from solver.mesh.mesh import Mesh, load_mesh
from solver.types import FloatArray
from tests.solver.mesh.formats.gltf.scenes import (
    Json,
    P,
    Scene,
    bent,
    pack_glb,
    skinned,
    strip,
    unpack,
    values,
)

NORMALS = np.tile([0.0, 0.6, 0.8], (6, 1))


def shown(path: Path, name: str) -> FloatArray:
    """What the file shows with a target's weight at one in place of nought."""
    root, data = unpack(path)
    for mesh in root["meshes"]:
        names = mesh.get("extras", {}).get("targetNames", [])
        if name in names:
            mesh["weights"][names.index(name)] = 1
    other = path.with_name("shown.glb")
    other.write_bytes(pack_glb(root, data))
    return load_mesh(other).vertices


@pytest.mark.parametrize("build", [lambda: strip()[0], lambda: skinned()[0]])
@pytest.mark.parametrize("saved_from", ["rest", "deformed"])
def test_a_target_takes_what_is_saved_to_its_pose(
    tmp_path: Path, build: Any, saved_from: str
) -> None:
    mesh: Mesh = build().load(tmp_path)
    X = mesh.vertices if saved_from == "rest" else bent(mesh.vertices)
    poses = {"fist": bent(X), "wave": X + [0, 0, 1]}
    mesh.save(tmp_path / "out.glb", X, poses=poses)
    np.testing.assert_allclose(load_mesh(tmp_path / "out.glb").vertices, X, atol=1e-6)
    for name, pose in poses.items():
        np.testing.assert_allclose(shown(tmp_path / "out.glb", name), pose, atol=1e-6)
    root, _ = unpack(tmp_path / "out.glb")
    assert root["meshes"][0]["weights"] == [0, 0]
    for target in root["meshes"][0]["primitives"][0]["targets"]:
        stored = values(tmp_path / "out.glb", target["POSITION"])
        accessor = root["accessors"][target["POSITION"]]
        assert accessor["min"] == stored.min(axis=0).tolist()
        assert accessor["max"] == stored.max(axis=0).tolist()


def test_normals_turn_with_their_pose(tmp_path: Path) -> None:
    scene, primitive = strip(NORMAL=NORMALS)
    mesh = scene.load(tmp_path)
    quarter = np.array([[0, 1, 0], [-1, 0, 0], [0, 0, 1]])
    mesh.save(tmp_path / "out.glb", P, poses={"turned": P @ quarter})
    root, _ = unpack(tmp_path / "out.glb")
    (target,) = root["meshes"][0]["primitives"][0]["targets"]
    base = values(tmp_path / "out.glb", primitive["attributes"]["NORMAL"])
    after = base + values(tmp_path / "out.glb", target["NORMAL"])
    np.testing.assert_allclose(after, NORMALS @ quarter, atol=1e-6)


def morphed() -> tuple[Scene, Json]:
    """The strip with two targets, the first at weight one half, animated."""
    scene, primitive = strip()
    primitive["targets"] = [{"POSITION": scene.positions(P * k)} for k in (1, 2)]
    mesh = scene.json["meshes"][0]
    mesh |= {"weights": [0.5, 0], "extras": {"targetNames": ["smile", "fist"], "more": 1}}
    scene.json["nodes"][0]["weights"] = [0.5, 0]
    sampler = {
        "input": scene.accessor([0, 1, 2]),
        "output": scene.accessor([0, 1, 0.5, 0.25, 1, 0]),
    }
    channel = {"sampler": 0, "target": {"node": 0, "path": "weights"}}
    scene.json["animations"] = [{"channels": [channel], "samplers": [sampler]}]
    return scene, primitive


def test_targets_that_were_there_stay(tmp_path: Path) -> None:
    scene, primitive = morphed()
    mesh = scene.load(tmp_path)
    X = bent(mesh.vertices)
    mesh.save(tmp_path / "out.glb", X, poses={"wave": X + 1})
    root, _ = unpack(tmp_path / "out.glb")
    after = root["meshes"][0]
    assert after["extras"] == {"targetNames": ["smile", "fist", "wave"], "more": 1}
    assert after["weights"] == root["nodes"][0]["weights"] == [0.5, 0, 0]
    assert after["primitives"][0]["targets"][:2] == primitive["targets"]
    for k, target in enumerate(primitive["targets"], start=1):
        stored = values(tmp_path / "out.glb", target["POSITION"])
        np.testing.assert_array_equal(stored, (P * k).astype("<f4"))
    np.testing.assert_allclose(load_mesh(tmp_path / "out.glb").vertices, X, atol=1e-6)


def test_animated_weights_stay_what_they_were(tmp_path: Path) -> None:
    mesh = morphed()[0].load(tmp_path)
    mesh.save(tmp_path / "out.glb", mesh.vertices, poses={"a": mesh.vertices + 1, "b": P})
    root, _ = unpack(tmp_path / "out.glb")
    (sampler,) = root["animations"][0]["samplers"]
    weights = values(tmp_path / "out.glb", sampler["output"]).reshape(3, 4)
    assert weights.tolist() == [[0, 1, 0, 0], [0.5, 0.25, 0, 0], [1, 0, 0, 0]]


def test_a_sampler_that_another_mesh_reads_stays_for_it(tmp_path: Path) -> None:
    scene, primitive = morphed()
    scene.node(mesh=scene.mesh(primitive), translation=[5, 0, 0])
    channel = {"sampler": 0, "target": {"node": 1, "path": "weights"}}
    scene.json["animations"][0]["channels"].append(channel)
    mesh = scene.load(tmp_path)
    pose = mesh.vertices.copy()
    pose[:6] += 1
    mesh.save(tmp_path / "out.glb", mesh.vertices, poses={"first alone": pose})
    root, _ = unpack(tmp_path / "out.glb")
    animation = root["animations"][0]
    counts = [
        root["accessors"][animation["samplers"][channel["sampler"]]["output"]]["count"]
        for channel in animation["channels"]
    ]
    assert counts == [9, 6]
    assert [len(m["primitives"][0]["targets"]) for m in root["meshes"]] == [3, 2]


def test_a_name_that_is_taken_gets_a_number(tmp_path: Path) -> None:
    mesh = morphed()[0].load(tmp_path)
    mesh.save(tmp_path / "out.glb", mesh.vertices, poses={"fist": mesh.vertices + 1})
    root, _ = unpack(tmp_path / "out.glb")
    assert root["meshes"][0]["extras"]["targetNames"] == ["smile", "fist", "fist.001"]


def test_targets_without_names_are_numbered(tmp_path: Path) -> None:
    scene, _ = morphed()
    scene.json["meshes"][0]["extras"] = "not an object"
    mesh = scene.load(tmp_path)
    mesh.save(tmp_path / "out.glb", mesh.vertices, poses={"fist": mesh.vertices + 1})
    root, _ = unpack(tmp_path / "out.glb")
    names = ["target 0", "target 1", "fist"]
    assert root["meshes"][0]["extras"] == {"extras": "not an object", "targetNames": names}


def test_all_primitives_of_a_mesh_get_as_many_targets(tmp_path: Path) -> None:
    scene, primitive = strip()
    points = {"mode": 0, "attributes": {"POSITION": scene.positions(P[:2])}}
    odd = {"attributes": {"POSITION": scene.positions(P[:3])}}
    scene.json["meshes"][0]["primitives"] += [points, odd]
    primitive["targets"] = [{"POSITION": scene.positions(P)}]
    mesh = scene.load(tmp_path)
    X = mesh.vertices + 1
    mesh.save(tmp_path / "out.glb", mesh.vertices, poses={"a": X, "b": X + 1})
    root, _ = unpack(tmp_path / "out.glb")
    _, still, last = (entry["targets"] for entry in root["meshes"][0]["primitives"])
    assert len(still) == len(last) == 3
    for target in (*still, last[0]):
        accessor = root["accessors"][target["POSITION"]]
        # Without data, an accessor is all zeros.
        assert "bufferView" not in accessor
        assert accessor["min"] == accessor["max"] == [0, 0, 0]
    np.testing.assert_allclose(shown(tmp_path / "out.glb", "a"), X, atol=1e-6)


@pytest.mark.parametrize("pointer", ["/meshes/0/weights", "/nodes/0/weights"])
def test_weights_that_a_pointer_animates_stay_what_they_were(tmp_path: Path, pointer: str) -> None:
    scene, _ = morphed()
    (channel,) = scene.json["animations"][0]["channels"]
    extension = {"KHR_animation_pointer": {"pointer": pointer}}
    channel["target"] = {"path": "pointer", "extensions": extension}
    mesh = scene.load(tmp_path)
    mesh.save(tmp_path / "out.glb", mesh.vertices, poses={"a": mesh.vertices + 1})
    root, _ = unpack(tmp_path / "out.glb")
    (sampler,) = root["animations"][0]["samplers"]
    assert root["accessors"][sampler["output"]]["count"] == 9


@pytest.mark.parametrize("count", [5, 2**40])
def test_an_animation_that_makes_no_sense_stays(tmp_path: Path, count: int) -> None:
    scene, _ = morphed()
    (sampler,) = scene.json["animations"][0]["samplers"]
    scene.json["accessors"][sampler["output"]]["count"] = count
    mesh = scene.load(tmp_path)
    mesh.save(tmp_path / "out.glb", mesh.vertices, poses={"a": mesh.vertices + 1})
    root, _ = unpack(tmp_path / "out.glb")
    assert root["animations"] == scene.json["animations"]


def test_a_pose_that_moves_nothing_keeps_its_name(tmp_path: Path) -> None:
    mesh = strip()[0].load(tmp_path)
    mesh.save(tmp_path / "out.gltf", P, poses={"rest": P})
    root, _ = unpack(tmp_path / "out.gltf")
    assert root["meshes"][0]["extras"]["targetNames"] == ["rest"]


@pytest.mark.parametrize("suffix", [".obj", ".ply", ".off", ".stl"])
def test_other_formats_write_poses_beside(tmp_path: Path, suffix: str) -> None:
    mesh = Mesh.from_arrays(P, [[0, 1, 2], [2, 1, 3], [3, 4, 5]])
    mesh.save(tmp_path / f"out{suffix}", P, poses={"fist": P + 1, "a/b é": P + 2})
    names = sorted(path.name for path in tmp_path.iterdir())
    assert names == sorted([f"out{suffix}", f"out-fist{suffix}", f"out-a_b_é{suffix}"])
    again = load_mesh(tmp_path / f"out-fist{suffix}")
    np.testing.assert_allclose(again.vertices[again.faces], (P + 1)[mesh.faces], atol=1e-6)


def test_poses_that_cannot_be_saved_are_refused(tmp_path: Path) -> None:
    mesh = Mesh.from_arrays(P, [[0, 1, 2]])
    with pytest.raises(MeshError, match="two poses would be saved there"):
        mesh.save(tmp_path / "a.obj", P, poses={"a/b": P, "a_b": P})
    with pytest.raises(MeshError, match=r"positions must be \(6, 3\), got \(5, 3\)"):
        mesh.save(tmp_path / "a.glb", P, poses={"a": P[:5]})
    assert not list(tmp_path.iterdir())
