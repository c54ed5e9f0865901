"""Writing a PLY that was read: all stays but positions that moved and normals that turned."""

from __future__ import annotations

import struct
from pathlib import Path

import numpy as np
import pytest

from solver.mesh.mesh import load_mesh
from solver.types import FloatArray
from tests.solver.mesh.formats.files import SQUARE, load
from tests.solver.mesh.formats.test_ply import FACES, PLY, PLY_WRITERS

HEAD = b"""ply
format %b 1.0
comment TextureFile skin.png
element camera 1
property list uchar int pixels
element vertex 4
property float nx
property double z
property uchar red
property uchar green
property uchar blue
property double y
property float u
property float v
property float ny
property float nz
property double x
element face 1
property list uchar int vertex_indices
property uchar flags
element edge 1
property int v
end_header
"""
# nx z red green blue y u v ny nz x: every normal points up.
FLAT = (SQUARE * [1, 1, 0]).tolist()
ROWS = [(0.0, z, 1, 2, 3, y, 0.5, 0.25, 0.0, 1.0, x) for x, y, z in FLAT]
ROW = "<fd3Bd4fd"
TEXT = (
    HEAD % b"ascii"
    + b"2 7 8\r\n"
    + b"\n".join(b" ".join(b"%a" % x for x in row) for row in ROWS)
    + b"  extra\n\n4 0  1 2 3 9\n3\n# no comment, but after the end"
)
BINARY = (
    HEAD % b"binary_little_endian"
    + struct.pack("<B2i", 2, 7, 8)
    + b"".join(struct.pack(ROW, *row) for row in ROWS)
    + struct.pack("<B4iBi", 4, 0, 1, 2, 3, 9, 3)
)


def saved(folder: Path, data: bytes, X: FloatArray) -> bytes:
    load(folder, "a.ply", data).save(folder / "b.ply", X)
    return (folder / "b.ply").read_bytes()


@pytest.mark.parametrize("kind", PLY_WRITERS)
def test_saving_the_rest_positions_gives_the_source(tmp_path: Path, kind: str) -> None:
    data = PLY_WRITERS[kind](FACES)
    assert saved(tmp_path, data, SQUARE) == data


@pytest.mark.parametrize("kind", PLY_WRITERS)
def test_only_what_moved_changes(tmp_path: Path, kind: str) -> None:
    data = PLY_WRITERS[kind](FACES)
    X = SQUARE.copy()
    X[2] = [0.1, 1 / 7, -2.5]
    out = saved(tmp_path, data, X)
    assert load_mesh(tmp_path / "b.ply").vertices.tobytes() == X.tobytes()
    if kind.startswith("text"):
        assert out == data.replace(b"1.0 1.0 0.0", b"%a %a %a" % tuple(X[2].tolist()))
    else:
        order = "<" if kind == "little" else ">"
        old, new = (struct.pack(f"{order}3d", *p[2]) for p in (SQUARE, X))
        assert out == data.replace(old, new)


@pytest.mark.parametrize("data", [TEXT, BINARY])
def test_normals_turn_with_the_surface(tmp_path: Path, data: bytes) -> None:
    mesh = load(tmp_path, "a.ply", data)
    assert mesh.extras == {
        **{"texture coordinates": 4, "normals": 4, "colours": 4},
        **{"further properties": 1, "further elements": 2},
    }
    X = mesh.vertices[:, [2, 1, 0]] * [1, 1, -1] + 0.0
    rows = [(1.0, z, 1, 2, 3, y, 0.5, 0.25, 0.0, 0.0, x) for x, y, z in X.tolist()]
    out = saved(tmp_path, data, X)
    if data is BINARY:
        assert out == data.replace(
            b"".join(struct.pack(ROW, *row) for row in ROWS),
            b"".join(struct.pack(ROW, *row) for row in rows),
        )
    else:
        lines, source = out.splitlines(), data.splitlines()
        found = [list(map(float, line.split()[:11])) for line in lines[-8:-4]]
        assert found == [[float(x) for x in row] for row in rows]
        assert lines[:-8] + lines[-4:] == source[:-8] + source[-4:]


def test_floats_stay_floats(tmp_path: Path) -> None:
    body = struct.pack("<9f", *range(9)) + struct.pack("<B3i", 3, 0, 1, 2)
    data = PLY.split(b"end_header\n")[0].replace(b"ascii", b"binary_little_endian")
    mesh = load(tmp_path, "a.ply", data + b"end_header\n" + body)
    mesh.save(tmp_path / "b.ply", mesh.vertices + 0.1)
    again = load_mesh(tmp_path / "b.ply").vertices
    np.testing.assert_array_equal(again, (mesh.vertices + 0.1).astype(np.float32))


def test_positions_stored_as_whole_numbers_are_written_as_float64(tmp_path: Path) -> None:
    data = PLY.replace(b"float", b"int")
    mesh = load(tmp_path, "a.ply", data)
    X = mesh.vertices + 0.25
    assert b"property double x" in saved(tmp_path, data, X)
    assert load_mesh(tmp_path / "b.ply").vertices.tobytes() == X.tobytes()


WHOLE_HEAD = b"""ply
format %b 1.0
comment scanned
element other 2
property list uchar short some
element vertex 4
property uchar red
property short x
property short y
property list uchar int links
property short z
property char nx
property char ny
property char nz
element face 1
property list uchar uint vertex_indices
property char nx
property char ny
property char nz
end_header
"""


def whole_ply(kind: str) -> bytes:
    """Positions, and normals of vertices and of a face, in whole numbers; lists all about."""
    corners = [(0, 0, 0), (7, 0, 0), (7, 7, 0), (0, 7, 0)]
    rows: list[tuple[str, tuple[int, ...]]] = [("B2h", (2, -1, -2)), ("B3h", (3, -3, -4, -5))]
    for number, (x, y, z) in enumerate(corners):
        links = (number, *range(number))
        rows.append((f"B2hB{number}ih3b", (50 + number, x, y, *links, z, 0, 0, 127)))
    rows.append(("B4I3b", (4, 0, 1, 2, 3, 0, 0, 100)))
    if kind == "ascii":
        return (
            WHOLE_HEAD % b"ascii"
            + b"".join(b" ".join(b"%d" % number for number in row) + b"\r\n" for _, row in rows)
            + b"behind the end"
        )
    order = "<" if kind == "binary_little_endian" else ">"
    body = b"".join(struct.pack(order + form, *row) for form, row in rows)
    return WHOLE_HEAD % kind.encode() + body + b"behind the end"


@pytest.mark.parametrize("kind", ["ascii", "binary_little_endian", "binary_big_endian"])
def test_whole_numbers_get_room_for_a_bend_and_all_else_stays(tmp_path: Path, kind: str) -> None:
    data = whole_ply(kind)
    mesh = load(tmp_path, "a.ply", data)
    assert saved(tmp_path, data, mesh.vertices) == data
    X = mesh.vertices[:, [2, 1, 0]] * [1, 1, -1] + [0.25, 0, 0]
    out = saved(tmp_path, data, X)
    again = load_mesh(tmp_path / "b.ply")
    assert again.vertices.tobytes() == X.tobytes()
    assert b"comment scanned\n" in out
    assert out.count(b"property double") == 9
    assert out.endswith(data[-14:])
    # Back at rest, the numbers are those of the source.
    again.save(tmp_path / "c.ply", mesh.vertices)
    values = (tmp_path / "c.ply").read_bytes().split(b"end_header\n")[1]
    if kind == "ascii":
        before = data.split(b"end_header\n")[1].split()
        assert [float(word) for word in values.split()[:-3]] == [float(x) for x in before[:-3]]
    else:
        assert len(values) == len(data.split(b"end_header\n")[1]) + 4 * 3 * (6 + 7) + 3 * 7


def test_normals_of_faces_turn_with_the_surface(tmp_path: Path) -> None:
    data = whole_ply("ascii").replace(b"property char", b"property float")
    mesh = load(tmp_path, "a.ply", data)
    assert mesh.extras == {
        "normals": 4,
        "face normals": 1,
        "further properties": 2,
        "further elements": 1,
    }
    out = saved(tmp_path, data, mesh.vertices[:, [2, 1, 0]] * [1, 1, -1])
    assert out.splitlines()[-2] == b"4 0 1 2 3 100.0 0.0 0.0"
    assert {line.split()[-3:][0] for line in out.splitlines()[-6:-2]} == {b"127.0"}
