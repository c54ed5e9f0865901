"""From one format to another: colours come along, and what does not is told in words."""

from __future__ import annotations

import struct
from pathlib import Path

import numpy as np
import pytest
import trimesh
from trimesh.visual.color import ColorVisuals

from solver.errors import MeshError
from solver.mesh.mesh import load_mesh
from tests.solver.mesh.formats.files import load

COLOURS = [(255, 0, 0), (0, 128, 255), (1, 2, 3), (255, 255, 255)]
CORNERS = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]
HEAD = """ply
format {} 1.0
element vertex 4
property float x
property float y
property float z
property {kind} {red}
property {kind} green
property {kind} blue
element face 1
property list uchar int vertex_indices
end_header
"""


def ply(kind: str = "uchar", largest: float = 255) -> bytes:
    text = HEAD.format("ascii", kind=kind, red="red")
    for corner, colour in zip(CORNERS, COLOURS, strict=True):
        scaled = [c * largest / 255 for c in colour]
        numbers = scaled if kind == "float" else [round(c) for c in scaled]
        text += " ".join(map(str, (*corner, *numbers))) + "\n"
    return (text + "4 0 1 2 3\n").encode()


def big_ply() -> bytes:
    data = HEAD.format("binary_big_endian", kind="uchar", red="red").encode()
    for corner, colour in zip(CORNERS, COLOURS, strict=True):
        data += struct.pack(">3f3B", *corner, *colour)
    return data + struct.pack(">B4i", 4, 0, 1, 2, 3)


def lines(head: str, scale: float, foot: str, alpha: str = "") -> bytes:
    rows = zip(CORNERS, COLOURS, strict=True)
    text = "".join(
        f"{head} {x} {y} {z} " + " ".join(f"{c * scale:g}" for c in colour) + f"{alpha}\n"
        for (x, y, z), colour in rows
    )
    return (text + foot).encode()


SOURCES = {
    "a.ply": ply(),
    "short.ply": ply("ushort", 65535),
    "float.ply": ply("float", 1.0),
    "big.ply": big_ply(),
    "a.off": b"COFF\n4 1 0\n" + lines("", 1, "4 0 1 2 3\n", " 255"),
    "three.off": b"COFF\n4 1 0\n" + lines("", 1, "4 0 1 2 3\n"),
    "float.off": b"COFF\n4 1 0\n" + lines("", 1 / 255, "4 0 1 2 3\n", " 1.0"),
    "a.obj": lines("v", 1 / 255, "f 1 2 3 4\n"),
    "whole.obj": lines("v", 1, "f 1 2 3 4\n"),
}


@pytest.mark.parametrize("target", ["ply", "off", "obj", "glb", "gltf"])
@pytest.mark.parametrize("name", SOURCES)
def test_colours_of_vertices_come_along(tmp_path: Path, name: str, target: str) -> None:
    mesh = load(tmp_path, name, SOURCES[name])
    assert mesh.extras["colours"] == 4
    mesh.save(tmp_path / f"out.{target}", mesh.vertices + 1)
    again = load_mesh(tmp_path / f"out.{target}")
    assert again.extras["colours"] == 4
    assert again.vertices.tolist() == (mesh.vertices + 1).tolist()
    assert again.colours is not None
    expected = np.array([(*colour, 255) for colour in COLOURS]) / 255
    np.testing.assert_allclose(again.colours(), expected, atol=2e-6)
    again.save(tmp_path / "back.ply", again.vertices)
    visual = trimesh.load_mesh(tmp_path / "back.ply", process=False).visual
    assert isinstance(visual, ColorVisuals)
    np.testing.assert_array_equal(np.asarray(visual.vertex_colors)[:, :3], COLOURS)


def test_alpha_comes_along(tmp_path: Path) -> None:
    data = b"STCNOFF 3 1 0\n" + b"".join(
        b"%d 0 %d 0 0 1 10 20 30 %d 0.5 0.5\n" % (i, i * i, 40 * i) for i in range(3)
    )
    mesh = load(tmp_path, "a.off", data + b"3 0 1 2\n")
    for target in ("b.ply", "c.off", "d.glb"):
        mesh.save(tmp_path / target, mesh.vertices)
        mesh = load_mesh(tmp_path / target)
        assert mesh.colours is not None
        expected = np.array([[10, 20, 30, 40 * i] for i in range(3)]) / 255
        np.testing.assert_allclose(mesh.colours(), expected, atol=1e-6)


def test_a_vertex_without_a_colour_is_white(tmp_path: Path) -> None:
    mesh = load(tmp_path, "a.obj", b"v 0 0 0 0 0.5 1\nv 1 0 0\nv 0 1 0 x y z\nf 1 2 3\n")
    mesh.save(tmp_path / "b.ply", mesh.vertices)
    colours = load_mesh(tmp_path / "b.ply").colours
    assert colours is not None
    assert (255 * colours()).tolist() == [[0, 128, 255, 255], [255] * 4, [255] * 4]


TEXTURED = (
    b"mtllib a.mtl\no arm\nusemtl skin\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\n"
    b"g hand\nf 1/1/1 2/1/1 3/1/1 4/1/1\nl 1 2\np 3\n"
)
PLAIN = TEXTURED.split(b"vt")[0].split(b"skin\n")[1]
LEFT_OUT = [
    ("a.obj", TEXTURED, "obj", ""),
    (
        *("a.obj", TEXTURED, "ply"),
        "PLY keeps no texture coordinates, normals, objects, groups, materials, lines, points",
    ),
    (
        *("a.obj", TEXTURED, "GLB"),
        "GLB keeps no texture coordinates, materials, lines, points, "
        "polygons (1 quad became triangles)",
    ),
    ("a.obj", PLAIN + b"f 1 2 3\n", "stl", ""),
    ("a.obj", PLAIN + b"f 1 2 3 4\n" * 2, "off", ""),
    (
        "a.obj",
        PLAIN + b"f 1 2 3 4\n" * 2,
        "stl",
        "STL keeps no polygons (2 quads became triangles)",
    ),
    (
        *("a.obj", PLAIN + b"f 1 2 3 4\n" + b"f 1 2 3 4 3\n", "gltf"),
        "GLTF keeps no polygons (2 polygons became triangles)",
    ),
    ("a.ply", ply(), "ply", ""),
    ("a.ply", ply(), "off", ""),
    ("a.ply", ply(), "stl", "STL keeps no colours, polygons (1 quad became triangles)"),
    (
        *("a.ply", ply().replace(b"red", b"heat").replace(b"blue", b"rain"), "obj"),
        "OBJ keeps no further properties",
    ),
    (
        "a.off",
        b"OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 9 9 9\n",
        "ply",
        "PLY keeps no face colours",
    ),
]


@pytest.mark.parametrize(("name", "data", "target", "words"), LEFT_OUT)
def test_what_a_format_does_not_keep_is_told(
    tmp_path: Path, name: str, data: bytes, target: str, words: str
) -> None:
    assert load(tmp_path, name, data).left_out(f"out.{target}") == words


def test_what_is_not_shown_of_a_scene_is_told_too(tmp_path: Path) -> None:
    mesh = load(tmp_path, "a.obj", TEXTURED)
    mesh.save(tmp_path / "a.glb", mesh.vertices)
    mesh = load_mesh(tmp_path / "a.glb")
    assert mesh.left_out("b.glb") == mesh.left_out("b.gltf") == ""
    assert mesh.left_out("b.ply") == "PLY keeps no normals, groups"


def test_an_unknown_format_is_refused(tmp_path: Path) -> None:
    mesh = load(tmp_path, "a.ply", ply())
    with pytest.raises(MeshError, match=r"unknown mesh format '.fbx'"):
        mesh.left_out("out.fbx")
