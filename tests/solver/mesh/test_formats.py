from __future__ import annotations

import struct
from collections.abc import Callable
from pathlib import Path

import igl
import numpy as np
import pytest

from solver.errors import MeshError
from solver.mesh.mesh import Mesh, load_mesh
from solver.types import FloatArray, IntArray

MESHES = Path(__file__).resolve().parents[3] / ".." / "shared" / "meshes"
SQUARE = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 1 / 3]])


def load(folder: Path, name: str, data: bytes) -> Mesh:
    (folder / name).write_bytes(data)
    return load_mesh(folder / name)


def surface(seed: int = 0) -> tuple[FloatArray, IntArray]:
    """A bumpy grid of triangles with float64 noise."""
    i = np.arange(42).reshape(6, 7)
    a, b, c, d = (s.ravel() for s in (i[:-1, :-1], i[:-1, 1:], i[1:, 1:], i[1:, :-1]))
    x, y = np.meshgrid(np.arange(7.0), np.arange(6.0))
    V = np.stack([x.ravel(), y.ravel(), np.zeros(42)], axis=1)
    V += 0.1 * np.random.default_rng(seed).normal(size=V.shape)
    return V, np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])


@pytest.mark.parametrize("suffix", [".off", ".ply", ".obj", ".OFF", ".Ply"])
def test_positions_and_polygons_survive_bit_for_bit(tmp_path: Path, suffix: str) -> None:
    rng = np.random.default_rng(0)
    hexagon = b"f 1 2 3 4 5 6\nf 1 2 7\nf 3 2 7 4\n"
    lines = b"".join(b"v %a %a %a\n" % tuple(p) for p in rng.normal(size=(7, 3)).tolist())
    mesh = load(tmp_path, "source.obj", lines + hexagon)
    X = rng.normal(size=(7, 3)) * 1e5
    mesh.save(tmp_path / f"out{suffix}", X)
    again = load_mesh(tmp_path / f"out{suffix}")
    assert again.vertices.tobytes() == X.tobytes()
    assert again.polygons == mesh.polygons


def test_large_polygons_survive_in_ply(tmp_path: Path) -> None:
    t = np.linspace(0, 2 * np.pi, 300, endpoint=False)
    lines = b"".join(
        b"v %a %a 0\n" % tuple(xy) for xy in np.stack([np.cos(t), np.sin(t)], axis=1).tolist()
    )
    mesh = load(tmp_path, "disk.obj", lines + b"f " + b" ".join(b"%d" % i for i in range(1, 301)))
    mesh.save(tmp_path / "disk.ply", mesh.vertices)
    again = load_mesh(tmp_path / "disk.ply")
    np.testing.assert_array_equal(again.polygons, mesh.polygons)


def test_stl_welds_corners_at_the_same_place(tmp_path: Path) -> None:
    V, F = surface()
    mesh = Mesh.from_arrays(V, F)
    mesh.save(tmp_path / "out.stl", V)
    again = load_mesh(tmp_path / "out.stl")
    assert again.vertices.shape == V.shape
    np.testing.assert_array_equal(again.vertices[again.faces], V.astype(np.float32)[F])
    # Vertices come in the order in which the triangles first name them.
    _, first = np.unique(again.faces, return_index=True)
    assert (np.diff(first) > 0).all()


def test_stl_takes_plus_and_minus_zero_for_one_place(tmp_path: Path) -> None:
    mesh = load(tmp_path, "a.stl", STL + STL.replace(b"vertex 0 0 0", b"vertex -0 0 0"))
    assert len(mesh.vertices) == 3


@pytest.mark.parametrize("suffix", [".off", ".ply", ".stl"])
@pytest.mark.parametrize("encoding", [igl.FileEncoding.Ascii, igl.FileEncoding.Binary])
def test_files_written_by_libigl_are_read(
    tmp_path: Path, suffix: str, encoding: igl.FileEncoding
) -> None:
    V, F = surface()
    igl.write_triangle_mesh(str(tmp_path / f"a{suffix}"), V, F, encoding)
    mesh = load_mesh(tmp_path / f"a{suffix}")
    assert mesh.vertices.shape == V.shape
    np.testing.assert_allclose(mesh.vertices[mesh.faces], V[F], atol=1e-5)


@pytest.mark.parametrize("suffix", [".off", ".ply", ".stl", ".obj"])
def test_libigl_reads_what_is_written(tmp_path: Path, suffix: str) -> None:
    V, F = surface()
    Mesh.from_arrays(V, F).save(tmp_path / f"a{suffix}", V)
    W, G = igl.read_triangle_mesh(str(tmp_path / f"a{suffix}"))
    np.testing.assert_allclose(W[G], V[F], rtol=1e-6, atol=1e-6)


@pytest.mark.parametrize(
    "text",
    [
        b"OFF\n4 1 0\n{v}\n{f}\n",
        b"OFF 4 1 0\n{v}\n{f}",
        b"# note\nOFF # keyword\n\n4 1\n# corners\n{v}\n\n{f} # face\nanything after it\n",
        b"OFF\r\n4 1 0\r\n{v}\r\n{f}\r\n",
        b"COFF\n4 1 0\n{c}\n{f} 255 0 0\n",
        b"NOFF\n4 1 0\n{c}\n{f}\n",
    ],
)
def test_every_way_to_write_an_off(tmp_path: Path, text: bytes) -> None:
    rows = [b"%a %a %a" % tuple(p) for p in SQUARE.tolist()]
    text = text.replace(b"{v}", b"\n".join(rows)).replace(b"{f}", b"4 0 1 2 3")
    text = text.replace(b"{c}", b" 0 0 1\n".join(rows) + b" 0 0 1")
    mesh = load(tmp_path, "a.off", text)
    assert mesh.vertices.tobytes() == SQUARE.tobytes()
    assert np.asarray(mesh.polygons).tolist() == [[0, 1, 2, 3]]


PLY_HEAD = b"""ply
format %b 1.0
comment made by hand
obj_info nothing
element camera 1
property float focal
property list uchar short pixels
element vertex 4
property uchar red
property double x
property double y
property double z
property float quality
element face %d
property list uchar float texcoord
property list uchar int vertex_indices
property uchar flags
element edge 1
property int v
end_header
"""
FACES = [[0, 1, 2, 3], [0, 1, 2]]


def text_ply(faces: list[list[int]]) -> bytes:
    vertices = b"".join(b"9 %a %a %a 0.5\n" % tuple(p) for p in SQUARE.tolist())
    rows = "".join(f"2 0.5 1 {len(f)} {' '.join(map(str, f))} 7\n" for f in faces)
    head = PLY_HEAD % (b"ascii", len(faces))
    return head + b"1.5 2 3 4\n\n" + vertices + rows.encode() + b"3\n"


def binary_ply(faces: list[list[int]], order: str) -> bytes:
    name = b"binary_little_endian" if order == "<" else b"binary_big_endian"
    body = struct.pack(f"{order}fB2h", 1.5, 2, 3, 4)
    body += b"".join(struct.pack(f"{order}B3df", 9, *p, 0.5) for p in SQUARE.tolist())
    for face in faces:
        body += struct.pack(f"{order}B2fB{len(face)}iB", 2, 0.5, 1, len(face), *face, 7)
    return PLY_HEAD % (name, len(faces)) + body + struct.pack(f"{order}i", 3)


PLY_WRITERS: dict[str, Callable[[list[list[int]]], bytes]] = {
    "text": text_ply,
    "text CRLF": lambda faces: text_ply(faces).replace(b"\n", b"\r\n"),
    "little": lambda faces: binary_ply(faces, "<"),
    "big": lambda faces: binary_ply(faces, ">"),
}


@pytest.mark.parametrize("kind", PLY_WRITERS)
@pytest.mark.parametrize("faces", [FACES, FACES[:1] * 3, FACES[1:], [[0, 1, 2], [0, 1, 2, 3]]])
def test_every_way_to_write_a_ply(tmp_path: Path, kind: str, faces: list[list[int]]) -> None:
    mesh = load(tmp_path, "a.ply", PLY_WRITERS[kind](faces))
    assert mesh.vertices.tobytes() == SQUARE.tobytes()
    assert [list(face) for face in mesh.polygons] == faces


OFF_ROWS = b"0 0 0\n1 0 0\n1 1 0\n0 1 0\n"
PLY = (
    b"ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
    b"property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
    b"0 0 0\n1 0 0\n1 1 0\n3 0 1 2\n"
)
LITTLE = binary_ply(FACES, "<")
STL = (
    b"solid a\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 1 0 0\n"
    b"   vertex 0 1 0\n  endloop\n endfacet\nendsolid a\n"
)
STL_BYTES = bytes(80) + struct.pack("<I12fH", 1, *[0.0] * 3, *range(9), 0)


@pytest.mark.parametrize(
    ("name", "data", "words"),
    [
        ("a.off", b"", "empty, expected an OFF mesh"),
        ("a.off", b"\0\1\2", "binary data, expected an OFF mesh"),
        ("a.off", b"hello", "line 1: expected an OFF file that starts with 'OFF', got 'hello'"),
        ("a.off", b"# only this\n", "line 1: expected an OFF file"),
        ("a.off", b"4OFF\n1 1 1\n", "line 1: expected an OFF file"),
        ("a.off", b"OFF BINARY\n", "line 1: expected the numbers of vertices and faces"),
        ("a.off", b"OFF\n", "line 1: expected the numbers of vertices and faces"),
        ("a.off", b"OFF\n-4 1 0\n", "line 2: expected the numbers of vertices and faces"),
        ("a.off", b"OFF\n4\n", "line 2: expected the numbers of vertices and faces"),
        ("a.off", b"OFF\n4 1 0\n" + OFF_ROWS, "ends early, expected 4 vertices and 1 faces"),
        ("a.off", b"OFF\n99999999999 1 0\n" + OFF_ROWS, "ends early"),
        ("a.off", b"OFF\n4 0 0\n" + OFF_ROWS, "no faces, expected at least one"),
        ("a.off", b"OFF\n0 0 0\n", "no faces, expected at least one"),
        ("a.off", b"OFF\n4 1 0\n" + OFF_ROWS + b"3 0 1 4\n", "line 7: the face names vertex 4"),
        ("a.off", b"OFF\n4 1 0\n" + OFF_ROWS + b"3 0 1 -1\n", "line 7: the face names vertex -1"),
        ("a.off", b"OFF\n4 1 0\n" + OFF_ROWS + b"2 0 1\n", "line 7: expected a count of at least"),
        ("a.off", b"OFF\n4 1 0\n" + OFF_ROWS + b"3 0 1\n", "line 7: expected a count of at least"),
        (
            "a.off",
            b"OFF\n4 1 0\n" + OFF_ROWS + b"3 0 1 b\n",
            "line 7: expected a count of at least",
        ),
        ("a.off", b"OFF\n4 1 0\n0 0\n" + OFF_ROWS, "line 3: expected three numbers"),
        ("a.off", b"OFF\n4 1 0\n0 x 0\n" + OFF_ROWS, "line 3: expected three numbers"),
        ("a.off", b"OFF\n4 1 0\n0 nan 0\n" + OFF_ROWS, "line 3: expected finite coordinates"),
        ("a.ply", b"", "not a PLY mesh"),
        ("a.ply", b"\0\1\2\3\xff", "not a PLY mesh"),
        ("a.ply", PLY[:60], "ends inside its header, expected 'end_header'"),
        ("a.ply", PLY.replace(b"ascii", b"utf8"), "line 2: expected a PLY header line"),
        ("a.ply", PLY.replace(b"vertex 3", b"vertex -3"), "line 3: expected a PLY header line"),
        ("a.ply", PLY.replace(b"vertex 3", b"vertex"), "line 3: expected a PLY header line"),
        ("a.ply", PLY.replace(b"float x", b"quad x"), "line 4: expected a PLY header line"),
        ("a.ply", b"ply\nproperty float x\nend_header\n", "line 2: expected a PLY header line"),
        ("a.ply", PLY.replace(b"list uchar", b"list float"), "line 8: expected a PLY header line"),
        ("a.ply", PLY.replace(b"format ascii 1.0\n", b""), "expected one format"),
        ("a.ply", PLY.replace(b"element face", b"element vertex"), "each PLY element once"),
        ("a.ply", PLY.replace(b"float z", b"float w"), "'vertex' with properties x, y, z"),
        ("a.ply", PLY.replace(b"float z", b"list int float z"), "with properties x, y, z"),
        ("a.ply", PLY.replace(b"vertex_indices", b"corners"), "with one list 'vertex_indices'"),
        ("a.ply", PLY.replace(b"uchar int", b"uchar float"), "with one list 'vertex_indices'"),
        ("a.ply", PLY.replace(b"element face", b"element tristrips"), "PLY element 'face'"),
        (
            "a.ply",
            PLY.replace(b"float z\n", b"float z\nproperty int z\n"),
            "the PLY element 'vertex' has a property twice",
        ),
        ("a.ply", PLY.replace(b"3 0 1 2\n", b""), "ends early, expected 1 lines of 'face', got 0"),
        ("a.ply", PLY.replace(b"vertex 3", b"vertex 99999999999"), "ends early"),
        ("a.ply", PLY.replace(b"1 0 0\n", b"1 x 0\n"), "line 11: expected 'vertex': x y z"),
        ("a.ply", PLY.replace(b"1 0 0\n", b"1 0\n"), "line 11: expected 'vertex': x y z"),
        ("a.ply", PLY.replace(b"3 0 1 2\n", b"3 0 1\n"), "line 13: expected 'face': vertex_ind"),
        ("a.ply", PLY.replace(b"3 0 1 2\n", b"-1 0 1\n"), "line 13: expected 'face': vertex_ind"),
        ("a.ply", PLY.replace(b"3 0 1 2\n", b"3 0 1 nan\n"), "line 13: expected 'face'"),
        ("a.ply", PLY.replace(b"3 0 1 2\n", b"3 0 1 99999999999999999999\n"), "line 13: expected"),
        ("a.ply", PLY.replace(b"1 0 0\n", b"1 nan 0\n"), "vertex 1: expected finite coordinates"),
        (
            "a.ply",
            PLY.replace(b"3 0 1 2", b"3 0 1 3"),
            "face 0: names vertex 3, but they go from 0",
        ),
        ("a.ply", PLY.replace(b"3 0 1 2", b"3 0 1 -2"), "face 0: names vertex -2"),
        ("a.ply", PLY.replace(b"3 0 1 2", b"2 0 1"), "face 0: a face needs at least three corners"),
        ("a.ply", PLY.replace(b"face 1", b"face 0"), "no faces, expected at least one"),
        ("a.ply", LITTLE[:-10], "ends early or is damaged, expected 2 rows of 'face'"),
        ("a.ply", LITTLE[:-60], "ends early or is damaged, expected 4 rows of 'vertex'"),
        ("a.ply", LITTLE.replace(b"vertex 4", b"vertex 99999999999"), "ends early"),
        ("a.ply", LITTLE.replace(b"face 2", b"face 99999999999"), "ends early"),
        ("a.ply", LITTLE.replace(b"uchar int", b"char int ")[:-25] + b"\xff" * 25, "damaged"),
        ("a.stl", b"", "empty, expected an STL mesh"),
        ("a.stl", b"hello", "not an STL mesh, or cut short: 5 bytes, expected 134 or more"),
        ("a.stl", bytes(84), "not an STL mesh"),
        ("a.stl", STL_BYTES[:-1], "cut short: 133 bytes, expected 134"),
        ("a.stl", bytes(80) + b"\xff\xff\xff\xff" + bytes(500), "cut short"),
        ("a.stl", STL_BYTES[:100] + b"\xff" * 34, "triangle 1: expected finite coordinates"),
        ("a.stl", STL[:-12], "ends early, got 3 vertices for 1 facets"),
        ("a.stl", STL[:80], "ends early, got 2 vertices for 1 facets"),
        ("a.stl", STL.replace(b"1 0 0", b"1 x 0"), "line 5: expected three numbers x y z"),
        ("a.stl", STL.replace(b"1 0 0", b"1 inf 0"), "line 5: expected finite coordinates"),
        ("a.stl", STL + b"\0", "binary data, expected an STL mesh"),
    ],
)
def test_bad_files_give_one_line_that_says_what_was_expected(
    tmp_path: Path, capfd: pytest.CaptureFixture[str], name: str, data: bytes, words: str
) -> None:
    with pytest.raises(MeshError) as caught:
        load(tmp_path, name, data)
    message = str(caught.value)
    assert words in message
    assert message.startswith(str(tmp_path / name))
    assert len(message.splitlines()) == 1
    assert capfd.readouterr() == ("", "")


@pytest.mark.parametrize(
    ("name", "whole"),
    [
        ("a.off", b"COFF\n4 2 0\n" + OFF_ROWS + b"3 0 1 2\n4 0 1 2 3\n"),
        ("a.ply", PLY),
        ("a.ply", LITTLE),
        ("a.stl", STL),
        ("a.stl", STL_BYTES),
    ],
)
def test_a_file_cut_or_damaged_anywhere_loads_or_gives_one_line(
    tmp_path: Path, name: str, whole: bytes
) -> None:
    rng = np.random.default_rng(0)
    assert len(load(tmp_path, name, whole).faces) > 0
    for i in range(len(whole)):
        for data in (whole[:i], whole[:i] + rng.bytes(1) + whole[i + 1 :]):
            message = ""
            try:
                mesh = load(tmp_path, name, data)
                assert mesh.faces.max() < len(mesh.vertices)
            except MeshError as error:
                message = str(error)
            assert len(message.splitlines()) <= 1


def test_the_shared_off_meshes_match_libigl() -> None:
    paths = sorted(MESHES.rglob("*.off"))
    if not paths:
        pytest.skip("the shared meshes are not there")
    for path in paths:
        mesh = load_mesh(path)
        V, F = igl.read_triangle_mesh(str(path))
        np.testing.assert_allclose(mesh.vertices, V, rtol=1e-15)
        np.testing.assert_array_equal(mesh.faces, F)
