"""Files that hold no surface, or lie, are refused in one line; nothing else ever happens."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from solver.errors import MeshError
from solver.mesh.formats.gltf.saving import pack
from solver.mesh.mesh import Mesh
from tests.solver.mesh.formats.files import check_damage, check_refusal
from tests.solver.mesh.formats.gltf.scenes import P, skinned, strip


def changed(where: str, value: Any) -> bytes:
    """The strip with another value somewhere in its JSON."""
    scene, _ = strip()
    holder: Any = scene.json
    *way, last = where.split(".")
    for key in way:
        holder = holder[int(key) if key.isdigit() else key]
    holder[int(last) if last.isdigit() else last] = value
    return scene.gltf()


FLOATS = {"bufferView": 0, "componentType": 5126, "count": 3, "type": "SCALAR"}
PRIMITIVE, VIEW, ACCESSOR = "meshes.0.primitives.0", "bufferViews.0", "accessors.0"


@pytest.mark.parametrize(
    ("where", "value", "words"),
    [
        ("extensionsRequired", ["KHR_draco_mesh_compression"], "compressed by Draco (KHR_draco"),
        ("extensionsRequired", ["EXT_meshopt_compression"], "compressed by meshopt (EXT_mesh"),
        ("asset", {"version": "1.0"}, "glTF of version '1.0', expected 2.0"),
        ("asset", {}, "the JSON.asset: 'version' is missing"),
        (f"{PRIMITIVE}.mode", 1, "no triangles, expected a scene that shows at least one"),
        ("nodes", [], "no triangles"),
        (
            f"{PRIMITIVE}.attributes",
            {"POSITION": 7},
            "POSITION: expected the number of one of 2",
        ),
        (f"{PRIMITIVE}.indices", 0, "accessor 0: expected type SCALAR, got 'VEC3'"),
        (f"{PRIMITIVE}.attributes", [], "attributes: expected an object, got a list"),
        ("accessors.1", FLOATS, "accessor 1: expected whole numbers, got floats"),
        (f"{ACCESSOR}.type", "VEC2", "accessor 0: expected type VEC3, got 'VEC2'"),
        (f"{ACCESSOR}.componentType", 5124, "accessor 0: unknown component type 5124"),
        (f"{ACCESSOR}.count", 7, "accessor 0: ends at byte 84 of buffer view 0, which has 72"),
        (f"{ACCESSOR}.count", -1, "the JSON.accessors[0].count: expected a count, got -1"),
        (f"{ACCESSOR}.count", 2**52, "vertices and indices, expected 67108864 or less"),
        (f"{ACCESSOR}.count", 5, "an index names vertex 5, but they go from 0 to 4"),
        (f"{VIEW}.byteLength", 71, "ends at byte 72 of buffer view 0, which has 71"),
        (f"{VIEW}.byteOffset", 50, "ends at byte 122 of buffer 0, which has 96"),
        (f"{VIEW}.buffer", True, "expected the number of one of 1 buffers, got True"),
        ("nodes.0.scale", [1, 2], "the JSON.nodes[0].scale: expected 3 finite numbers, got a list"),
        ("nodes.0", 3, "the JSON.nodes[0]: expected an object, got 3"),
        ("meshes", {}, "the JSON.meshes: expected a list, got a dict"),
        ("nodes.0.name", 3, "the JSON.nodes[0].name: expected text, got 3"),
        (f"{ACCESSOR}.normalized", 1, "expected true or false, got 1"),
    ],
)
def test_what_cannot_be_read_is_refused(
    tmp_path: Path, where: str, value: object, words: str
) -> None:
    check_refusal(tmp_path / "a.gltf", changed(where, value), words)


GLB = strip()[0].glb()


@pytest.mark.parametrize(
    ("data", "words"),
    [
        (b"", "the file is empty"),
        (GLB[:9], "the file ends early, got 9 bytes"),
        (GLB[:-5], f"the file ends early, got {len(GLB) - 5} bytes, expected {len(GLB)}"),
        (GLB[:4] + b"\1" + GLB[5:], "GLB of version 1, expected 2"),
        (GLB[:16] + b"NOSJ" + GLB[20:], "the first chunk is not JSON"),
        (GLB[:12] + b"\xff" * 4 + GLB[16:], "a chunk of 4294967295 bytes starts at 12"),
        (b"[" * 100_000, "its JSON cannot be read"),
        (b"{" + b"1" * 9999, "its JSON cannot be read"),
        (b"\xff\xfe{}", "its JSON cannot be read"),
        (b"[]", "the JSON: expected an object, got a list"),
        (b"{}", "the JSON: 'asset' is missing"),
    ],
)
def test_what_is_no_gltf_is_refused(tmp_path: Path, data: bytes, words: str) -> None:
    check_refusal(tmp_path / "a.glb", data, words)


@pytest.mark.parametrize(
    ("uri", "words"),
    [
        ("lost.bin", "buffer 0: there is no file 'lost.bin' beside it"),
        ("a" * 300, "cannot be read"),
        (".", "buffer 0: there is no file '.' beside it"),
        ("/dev/zero", "is not a path relative to the file"),
        ("https://example.com/a.bin", "is not a path relative to the file"),
        ("data:;base64", "the data URI has no comma"),
        ("data:;base64,A", "the data URI is not base64"),
        ("a\0b", "buffer 0"),
    ],
)
def test_data_that_is_not_there_is_refused(tmp_path: Path, uri: str, words: str) -> None:
    data = changed("buffers", [{"byteLength": 96, "uri": uri}])
    check_refusal(tmp_path / "a.gltf", data, words)


@pytest.mark.parametrize(
    ("count", "index", "words"),
    [
        (7, [0], "sparse values that do not fit its 6 elements"),
        (1, [6], "a sparse value for element 6, which it does not have"),
        (2, [0], "accessor 2, sparse: ends at byte 4 of buffer view 2, which has 2"),
    ],
)
def test_sparse_values_that_do_not_fit_are_refused(
    tmp_path: Path, count: int, index: list[int], words: str
) -> None:
    scene, primitive = strip()
    places = scene.view(np.array(index, "<u2").tobytes())
    sparse = {
        "count": count,
        "indices": {"bufferView": places, "componentType": 5123},
        "values": {"bufferView": 0},
    }
    primitive["attributes"]["POSITION"] = scene.accessor(P, sparse=sparse)
    check_refusal(tmp_path / "a.glb", scene.glb(), words)


@pytest.mark.parametrize(
    ("joint", "matrices", "count", "words"),
    [
        (2, 2, 6, "a vertex hangs on joint 2, but the skin has 2"),
        (0, 1, 6, "a skin with 2 joints and 1 matrices"),
        (0, 2, 5, "expected joints and weights for 6 vertices"),
    ],
)
def test_skins_that_do_not_fit_are_refused(
    tmp_path: Path, joint: int, matrices: int, count: int, words: str
) -> None:
    scene, *_ = skinned()
    attributes = scene.json["meshes"][0]["primitives"][0]["attributes"]
    attributes["JOINTS_0"] = scene.accessor(np.full((count, 4), joint), "u1")
    skin = scene.json["skins"][0]
    scene.json["accessors"][skin["inverseBindMatrices"]]["count"] = matrices
    check_refusal(tmp_path / "a.glb", scene.glb(), words)


def test_positions_must_be_finite(tmp_path: Path) -> None:
    V = P.copy()
    V[3, 1] = np.inf
    check_refusal(tmp_path / "a.gltf", strip(V)[0].gltf().replace(b"Infinity", b"1"), "vertex 3")


def test_a_morph_target_of_another_size_is_refused(tmp_path: Path) -> None:
    scene, primitive = strip()
    primitive["targets"] = [{"POSITION": scene.accessor(P[:5])}]
    scene.json["meshes"][0]["weights"] = [1]
    check_refusal(tmp_path / "a.glb", scene.glb(), "a morph target of 5 for 6 vertices")


def test_a_short_file_cannot_ask_for_all_memory(tmp_path: Path) -> None:
    """Accessors need no data of their own, and any number of meshes may name the same one."""
    scene, primitive = strip()
    scene.json["accessors"][0] = {"componentType": 5126, "count": 2**20, "type": "VEC3"}
    for _ in range(100):
        scene.node(mesh=scene.mesh(primitive))
    check_refusal(tmp_path / "a.glb", scene.glb(), "vertices and indices, expected")


def test_damaged_files_load_or_are_refused(tmp_path: Path) -> None:
    check_damage(tmp_path / "a.glb", strip(NORMAL=P + 1)[0].glb())


def test_a_glb_of_more_than_four_gigabytes_is_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(pack, "LARGEST", 100)
    with pytest.raises(MeshError, match="bytes, expected less than 4 GiB in a GLB"):
        Mesh.from_arrays(P, [[0, 1, 2]]).save(tmp_path / "out.glb", P)


def test_positions_beyond_float32_are_refused(tmp_path: Path) -> None:
    mesh = strip()[0].load(tmp_path)
    with pytest.raises(MeshError, match=r"coordinates up to 1e\+39 do not fit float32"):
        mesh.save(tmp_path / "out.glb", np.full((6, 3), 1e39))
