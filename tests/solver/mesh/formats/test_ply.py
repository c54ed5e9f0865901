"""PLY files: every way to write one, and what is refused."""

from __future__ import annotations

import struct
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from solver.mesh.mesh import load_mesh
from tests.solver.mesh.formats.files import SQUARE, check_damage, check_refusal, load

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
PLY = (
    b"ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
    b"property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
    b"0 0 0\n1 0 0\n1 1 0\n3 0 1 2\n"
)
LITTLE = binary_ply(FACES, "<")


@pytest.mark.parametrize("kind", PLY_WRITERS)
@pytest.mark.parametrize("faces", [FACES, FACES[:1] * 3, FACES[1:], [[0, 1, 2], [0, 1, 2, 3]]])
def test_every_way_to_write_a_ply(tmp_path: Path, kind: str, faces: list[list[int]]) -> None:
    mesh = load(tmp_path, "a.ply", PLY_WRITERS[kind](faces))
    assert mesh.vertices.tobytes() == SQUARE.tobytes()
    assert [list(face) for face in mesh.polygons] == faces


def test_large_polygons_survive_in_ply(tmp_path: Path) -> None:
    t = np.linspace(0, 2 * np.pi, 300, endpoint=False)
    lines = b"".join(
        b"v %a %a 0\n" % tuple(xy) for xy in np.stack([np.cos(t), np.sin(t)], axis=1).tolist()
    )
    mesh = load(tmp_path, "disk.obj", lines + b"f " + b" ".join(b"%d" % i for i in range(1, 301)))
    mesh.save(tmp_path / "disk.ply", mesh.vertices)
    again = load_mesh(tmp_path / "disk.ply")
    np.testing.assert_array_equal(again.polygons, mesh.polygons)


@pytest.mark.parametrize(
    ("data", "words"),
    [
        (b"", "not a PLY mesh"),
        (b"\0\1\2\3\xff", "not a PLY mesh"),
        (PLY[:60], "ends inside its header, expected 'end_header'"),
        (PLY.replace(b"ascii", b"utf8"), "line 2: expected a PLY header line"),
        (PLY.replace(b"vertex 3", b"vertex -3"), "line 3: expected a PLY header line"),
        (PLY.replace(b"vertex 3", b"vertex"), "line 3: expected a PLY header line"),
        (PLY.replace(b"float x", b"quad x"), "line 4: expected a PLY header line"),
        (b"ply\nproperty float x\nend_header\n", "line 2: expected a PLY header line"),
        (PLY.replace(b"list uchar", b"list float"), "line 8: expected a PLY header line"),
        (PLY.replace(b"format ascii 1.0\n", b""), "expected one format"),
        (PLY.replace(b"element face", b"element vertex"), "each PLY element once"),
        (PLY.replace(b"float z", b"float w"), "'vertex' with properties x, y, z"),
        (PLY.replace(b"float z", b"list int float z"), "with properties x, y, z"),
        (PLY.replace(b"vertex_indices", b"corners"), "with one list 'vertex_indices'"),
        (PLY.replace(b"uchar int", b"uchar float"), "with one list 'vertex_indices'"),
        (PLY.replace(b"element face", b"element tristrips"), "PLY element 'face'"),
        (
            PLY.replace(b"float z\n", b"float z\nproperty int z\n"),
            "the PLY element 'vertex' has a property twice",
        ),
        (PLY.replace(b"3 0 1 2\n", b""), "ends early, expected 1 lines of 'face', got 0"),
        (PLY.replace(b"vertex 3", b"vertex 99999999999"), "ends early"),
        (PLY.replace(b"1 0 0\n", b"1 x 0\n"), "line 11: expected 'vertex': x y z"),
        (PLY.replace(b"1 0 0\n", b"1 0\n"), "line 11: expected 'vertex': x y z"),
        (PLY.replace(b"3 0 1 2\n", b"3 0 1\n"), "line 13: expected 'face': vertex_ind"),
        (PLY.replace(b"3 0 1 2\n", b"-1 0 1\n"), "line 13: expected 'face': vertex_ind"),
        (PLY.replace(b"3 0 1 2\n", b"3 0 1 nan\n"), "line 13: expected 'face'"),
        (PLY.replace(b"3 0 1 2\n", b"3 0 1 99999999999999999999\n"), "line 13: expected"),
        (PLY.replace(b"1 0 0\n", b"1 nan 0\n"), "vertex 1: expected finite coordinates"),
        (
            PLY.replace(b"3 0 1 2", b"3 0 1 3"),
            "face 0: names vertex 3, but they go from 0",
        ),
        (PLY.replace(b"3 0 1 2", b"3 0 1 -2"), "face 0: names vertex -2"),
        (PLY.replace(b"3 0 1 2", b"2 0 1"), "face 0: a face needs at least three corners"),
        (PLY.replace(b"face 1", b"face 0"), "no faces, expected at least one"),
        (LITTLE[:-10], "ends early or is damaged, expected 2 rows of 'face'"),
        (LITTLE[:-60], "ends early or is damaged, expected 4 rows of 'vertex'"),
        (LITTLE.replace(b"vertex 4", b"vertex 99999999999"), "ends early"),
        (LITTLE.replace(b"face 2", b"face 99999999999"), "ends early"),
        (LITTLE.replace(b"uchar int", b"char int ")[:-25] + b"\xff" * 25, "damaged"),
    ],
)
def test_bad_files_give_one_line_that_says_what_was_expected(
    tmp_path: Path, capfd: pytest.CaptureFixture[str], data: bytes, words: str
) -> None:
    check_refusal(tmp_path / "a.ply", data, words)
    assert capfd.readouterr() == ("", "")


@pytest.mark.parametrize("whole", [PLY, LITTLE])
def test_a_file_cut_or_damaged_anywhere_loads_or_gives_one_line(
    tmp_path: Path, whole: bytes
) -> None:
    check_damage(tmp_path / "a.ply", whole)
