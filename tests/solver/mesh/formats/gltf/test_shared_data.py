"""What is deformed never changes data that something else uses."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from solver.mesh.mesh import load_mesh
from tests.solver.mesh.formats.gltf.scenes import P, Scene, bent, strip, unpack, values


@pytest.mark.parametrize("kind", ["i1", "u2"])
def test_quantised_positions_that_move_become_float(tmp_path: Path, kind: str) -> None:
    scene, primitive = strip()
    number = scene.accessor((P * 60).round(), kind, normalized=True, min=[0] * 3, max=[120] * 3)
    primitive["attributes"]["POSITION"] = number
    scene.json["extensionsRequired"] = ["KHR_mesh_quantization"]
    mesh = scene.load(tmp_path)
    X = mesh.vertices.copy()
    X[4] += 2
    mesh.save(tmp_path / "out.glb", X)
    again = load_mesh(tmp_path / "out.glb")
    np.testing.assert_allclose(again.vertices, X, atol=1e-7)
    root, _ = unpack(tmp_path / "out.glb")
    assert root["extensionsRequired"] == ["KHR_mesh_quantization"]
    np.testing.assert_array_equal(values(tmp_path / "out.glb", number), (P * 60).round())


def shared_by_a_hidden_mesh() -> Scene:
    scene, primitive = strip()
    scene.mesh(primitive)
    return scene


def shared_by_a_morph_target() -> Scene:
    scene, primitive = strip()
    primitive["targets"] = [{"POSITION": 0}]
    return scene


def shared_by_an_overlapping_accessor() -> Scene:
    scene, _ = strip()
    scene.mesh({"attributes": {"POSITION": scene.accessor(P, bufferView=0)}})
    return scene


def shared_by_a_compressed_form() -> Scene:
    scene, _ = strip()
    scene.json["bufferViews"][0]["extensions"] = {"EXT_meshopt_compression": {}}
    return scene


@pytest.mark.parametrize(
    "build",
    [
        shared_by_a_hidden_mesh,
        shared_by_a_morph_target,
        shared_by_an_overlapping_accessor,
        shared_by_a_compressed_form,
    ],
)
def test_data_that_something_else_uses_stays(tmp_path: Path, build: Callable[[], Scene]) -> None:
    mesh = build().load(tmp_path)
    X = bent(mesh.vertices)
    mesh.save(tmp_path / "out.glb", X)
    np.testing.assert_array_equal(values(tmp_path / "out.glb", 0), P.astype("<f4"))
    np.testing.assert_allclose(load_mesh(tmp_path / "out.glb").vertices, X, atol=1e-6)


def test_two_meshes_with_one_accessor_move_apart(tmp_path: Path) -> None:
    scene, primitive = strip()
    scene.node(mesh=scene.mesh(primitive), translation=[5, 0, 0])
    mesh = scene.load(tmp_path)
    X = bent(mesh.vertices)
    mesh.save(tmp_path / "out.glb", X)
    np.testing.assert_allclose(load_mesh(tmp_path / "out.glb").vertices, X, atol=1e-6)


def test_interleaved_data_is_written_in_its_place(tmp_path: Path) -> None:
    scene, primitive = strip()
    view = scene.view(np.hstack([P, P + 1, P]).astype("<f4").tobytes(), byteStride=36)
    keys = ("POSITION", "NORMAL", "_AGE")
    numbers = {k: scene.accessor(P, bufferView=view, byteOffset=12 * i) for i, k in enumerate(keys)}
    primitive["attributes"] = numbers
    mesh = scene.load(tmp_path)
    X = bent(mesh.vertices)
    mesh.save(tmp_path / "out.glb", X)
    assert len(unpack(tmp_path / "out.glb")[1]) == len(unpack(tmp_path / "source.glb")[1])
    np.testing.assert_array_equal(values(tmp_path / "out.glb", numbers["_AGE"]), P.astype("<f4"))
    np.testing.assert_allclose(load_mesh(tmp_path / "out.glb").vertices, X, atol=1e-6)


def test_a_compressed_copy_of_what_moved_is_dropped(tmp_path: Path) -> None:
    scene, primitive = strip()
    primitive["extensions"] = {"KHR_draco_mesh_compression": {"bufferView": 0}, "OTHER": {}}
    mesh = scene.load(tmp_path)
    mesh.save(tmp_path / "out.glb", bent(mesh.vertices))
    root, _ = unpack(tmp_path / "out.glb")
    assert root["meshes"][0]["primitives"][0]["extensions"] == {"OTHER": {}}
