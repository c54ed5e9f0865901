"""GLB, .gltf, data beside and inside, and textures."""

from __future__ import annotations

import base64
import json
import struct
from pathlib import Path
from urllib.parse import quote_from_bytes

import numpy as np
import pytest

from solver.mesh.mesh import Mesh, load_mesh
from tests.solver.mesh.formats.gltf.scenes import P, bent, pack_glb, strip, unpack

PICTURE = b"\x89PNG and so on"


def beside(folder: Path) -> Mesh:
    """A .gltf whose buffer and picture are files beside it, with a blank in their names."""
    scene, _ = strip()
    folder.mkdir(exist_ok=True)
    (folder / "the data.bin").write_bytes(scene.data)
    (folder / "a b.png").write_bytes(PICTURE)
    scene.json["buffers"] = [{"byteLength": len(scene.data), "uri": "the%20data.bin"}]
    scene.json["images"] = [{"uri": "a%20b.png", "name": "skin"}, {"uri": "lost.png"}]
    (folder / "a.gltf").write_text(json.dumps(scene.json))
    return load_mesh(folder / "a.gltf")


def test_data_beside_a_file_is_read_and_never_written(tmp_path: Path) -> None:
    mesh = beside(tmp_path)
    before = (tmp_path / "the data.bin").read_bytes()
    for name in ("a.gltf", "b.gltf", "b.glb"):
        X = bent(mesh.vertices)
        mesh.save(tmp_path / name, X)
        assert (tmp_path / "the data.bin").read_bytes() == before
        np.testing.assert_allclose(load_mesh(tmp_path / name).vertices, X, atol=1e-6)
    assert len(list(tmp_path.iterdir())) == 5


def test_a_file_saved_beside_its_source_names_the_same_pictures(tmp_path: Path) -> None:
    mesh = beside(tmp_path)
    mesh.save(tmp_path / "b.gltf", bent(mesh.vertices))
    root, _ = unpack(tmp_path / "b.gltf")
    assert root["images"] == [{"uri": "a%20b.png", "name": "skin"}, {"uri": "lost.png"}]


@pytest.mark.parametrize("name", ["far/b.gltf", "far/b.glb", "b.glb"])
def test_any_other_file_takes_its_pictures_along(tmp_path: Path, name: str) -> None:
    mesh = beside(tmp_path / "near")
    (tmp_path / "far").mkdir()
    mesh.save(tmp_path / name, mesh.vertices)
    root, data = unpack(tmp_path / name)
    image, lost = root["images"]
    assert lost == {"uri": "lost.png"}
    assert image["name"] == "skin"
    assert image["mimeType"] == "image/png"
    view = root["bufferViews"][image["bufferView"]]
    assert data[view["byteOffset"] :][: view["byteLength"]] == PICTURE


def test_more_buffers_than_one_come_along(tmp_path: Path) -> None:
    scene, primitive = strip()
    uri = "data:;base64," + base64.b64encode(P.astype("<f4").tobytes()).decode()
    scene.json["buffers"] = [
        {"byteLength": len(scene.data)},
        {"byteLength": 72, "uri": uri.rstrip("=")},
    ]
    scene.json["bufferViews"].append({"buffer": 1, "byteLength": 72})
    view = len(scene.json["bufferViews"]) - 1
    primitive["attributes"]["POSITION"] = scene.accessor(P, bufferView=view)
    (tmp_path / "a.glb").write_bytes(pack_glb(scene.json, scene.data))
    mesh = load_mesh(tmp_path / "a.glb")
    for name in ("b.glb", "b.gltf"):
        X = bent(mesh.vertices)
        mesh.save(tmp_path / name, X)
        np.testing.assert_allclose(load_mesh(tmp_path / name).vertices, X, atol=1e-6)


def test_data_inside_need_not_be_base64(tmp_path: Path) -> None:
    scene, _ = strip()
    uri = "data:application/octet-stream," + quote_from_bytes(scene.data)
    scene.json["buffers"] = [{"byteLength": len(scene.data), "uri": uri}]
    (tmp_path / "a.gltf").write_text(json.dumps(scene.json))
    assert load_mesh(tmp_path / "a.gltf").vertices.tolist() == P.tolist()


def test_chunks_that_nobody_knows_stay(tmp_path: Path) -> None:
    data = strip()[0].glb()
    extra = struct.pack("<I", 4) + b"MORE" + b"abcd"
    head = b"glTF" + struct.pack("<II", 2, len(data) + len(extra))
    (tmp_path / "a.glb").write_bytes(head + data[12:] + extra)
    mesh = load_mesh(tmp_path / "a.glb")
    mesh.save(tmp_path / "b.glb", bent(mesh.vertices))
    assert (tmp_path / "b.glb").read_bytes().endswith(extra)
