"""Data of any layout gives the same surface."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from solver.types import FloatArray, IntArray
from tests.solver.mesh.formats.gltf.scenes import F, P, strip


@pytest.mark.parametrize("kind", ["u1", "u2", "u4"])
def test_indices_of_any_width(tmp_path: Path, kind: str) -> None:
    scene, primitive = strip()
    primitive["indices"] = scene.accessor(F.ravel(), kind)
    mesh = scene.load(tmp_path)
    assert mesh.faces.tolist() == F.tolist()
    assert mesh.vertices.tolist() == P.tolist()


@pytest.mark.parametrize(
    ("mode", "corners", "faces"),
    [(4, F.ravel(), F), (5, np.arange(6), F), (6, [0, 1, 3, 2], [[0, 1, 3], [0, 3, 2]])],
)
@pytest.mark.parametrize("indexed", [True, False])
def test_lists_strips_and_fans(
    tmp_path: Path, mode: int, corners: list[int], faces: list[list[int]], indexed: bool
) -> None:
    scene, primitive = strip(P if indexed else P[corners])
    primitive["mode"] = mode
    primitive["indices"] = scene.accessor(corners, "u1")
    if not indexed:
        del primitive["indices"]
    mesh = scene.load(tmp_path)
    assert mesh_triangles(mesh.vertices, mesh.faces) == mesh_triangles(P, np.array(faces))


def test_a_repeated_vertex_joins_strips_without_a_triangle(tmp_path: Path) -> None:
    scene, primitive = strip()
    primitive |= {"mode": 5, "indices": scene.accessor([0, 1, 2, 3, 3, 2, 2, 3, 4, 5], "u1")}
    mesh = scene.load(tmp_path)
    assert mesh_triangles(mesh.vertices, mesh.faces) == mesh_triangles(P, F)


def mesh_triangles(V: FloatArray, triangles: IntArray) -> set[bytes]:
    """Triangles as places in space, whichever corner comes first."""
    turns = (np.roll(triangle, -k, axis=0) for triangle in V[triangles] for k in range(3))
    return {turn.tobytes() for turn in turns}


def test_points_and_lines_are_left_out_and_counted(tmp_path: Path) -> None:
    scene, _ = strip()
    scene.json["meshes"][0]["primitives"] += [
        {"mode": mode, "attributes": {"POSITION": scene.positions(P + 5)}} for mode in range(4)
    ]
    mesh = scene.load(tmp_path)
    assert mesh.vertices.tolist() == P.tolist()
    assert mesh.extras["primitives left out"] == 4


def test_interleaved_attributes_are_told_apart(tmp_path: Path) -> None:
    scene, primitive = strip()
    rows = np.hstack([np.full((6, 1), 7), P, np.full((6, 2), 9)]).astype("<f4")
    view = scene.view(rows.tobytes(), byteStride=24)
    primitive["attributes"]["POSITION"] = scene.accessor(P, bufferView=view, byteOffset=4)
    assert scene.load(tmp_path).vertices.tolist() == P.tolist()


@pytest.mark.parametrize("kind", ["i1", "u1", "i2", "u2"])
@pytest.mark.parametrize("normalised", [True, False])
def test_quantised_positions(tmp_path: Path, kind: str, normalised: bool) -> None:
    whole = (P * 60).round()
    scene, primitive = strip()
    primitive["attributes"]["POSITION"] = scene.accessor(whole, kind, normalized=normalised)
    unit = np.iinfo(kind).max if normalised else 1
    np.testing.assert_array_equal(scene.load(tmp_path).vertices, whole / unit)


def test_the_lowest_normalised_integer_is_minus_one(tmp_path: Path) -> None:
    scene, primitive = strip()
    low = np.where(P == 0, -128, 127)
    primitive["attributes"]["POSITION"] = scene.accessor(low, "i1", normalized=True)
    assert set(scene.load(tmp_path).vertices.ravel()) == {-1.0, 1.0}


@pytest.mark.parametrize("based", [True, False])
def test_sparse_values_replace_those_of_a_base_or_zeros(tmp_path: Path, based: bool) -> None:
    scene, primitive = strip()
    at = [1, 3, 4]
    sparse = {
        "count": 3,
        "indices": {"bufferView": scene.view(np.array(at, "<u2").tobytes()), "componentType": 5123},
        "values": {"bufferView": scene.view(P[at].astype("<f4").tobytes())},
    }
    base: dict[str, Any] = {}
    if based:
        base["bufferView"] = scene.view(np.full(P.shape, 8, "<f4").tobytes())
    primitive["attributes"]["POSITION"] = scene.accessor(P, sparse=sparse, **base)
    expected = np.full_like(P, 8.0 if based else 0.0)
    expected[at] = P[at]
    assert scene.load(tmp_path).vertices.tolist() == expected.tolist()


def test_colours_of_an_unknown_type_are_none(tmp_path: Path) -> None:
    scene, primitive = strip()
    primitive["attributes"]["COLOR_0"] = scene.accessor(np.ones((len(P), 3)))
    scene.json["accessors"][primitive["attributes"]["COLOR_0"]]["type"] = "data:,"
    mesh = scene.load(tmp_path)
    assert mesh.colours is not None
    assert (mesh.colours() == 1).all()
    mesh.save(tmp_path / "out.obj", mesh.vertices)
    assert (tmp_path / "out.obj").exists()
