"""Writing an STL that was read: all stays but corners that moved and normals that turned."""

from __future__ import annotations

import struct
from pathlib import Path

import numpy as np
import pytest

from solver.mesh.mesh import load_mesh
from tests.solver.mesh.formats.files import load

TRIANGLES = np.array(
    [
        [[0, 0, 0], [1, 0, 0], [0, 1, 0]],
        [[1, 0, 0], [1, 1, 0], [0, 1, 0]],
        [[1, 1, 0], [1, 1, 0], [5, 5, 0]],
    ],
    dtype=float,
)
# The last has none, as some programs write it.
NORMALS = [(0.0, 0.0, 1.0), (0.0, 0.0, 1.0), (0.0, 0.0, 0.0)]


def text_stl(triangles: np.ndarray[tuple[int, int, int], np.dtype[np.float64]]) -> bytes:
    text = "solid Bracket  v2\n"
    for normal, corners in zip(NORMALS, triangles.tolist(), strict=True):
        text += "  FACET Normal {} {} {} \n outer loop\n".format(*normal)
        text += "".join("\tvertex {!r} {!r} {!r}\n".format(*p) for p in corners)
        text += "endloop \n  endfacet\n"
    return (text + "endsolid Bracket  v2\n\n").encode()


def binary_stl(triangles: np.ndarray[tuple[int, int, int], np.dtype[np.float64]]) -> bytes:
    head = b"COLOR=\x10\x20\x30\xff, scanned by hand".ljust(80, b"!")
    rows = zip(NORMALS, triangles.reshape(-1, 9).tolist(), (0x8001, 0, 0x7FFF), strict=True)
    body = b"".join(struct.pack("<12fH", *normal, *corners, a) for normal, corners, a in rows)
    return head + struct.pack("<I", len(triangles)) + body + b"a tail"


@pytest.mark.parametrize("write", [text_stl, binary_stl])
def test_saving_the_rest_positions_gives_the_source(tmp_path: Path, write: object) -> None:
    assert callable(write)
    for data in (write(TRIANGLES), write(TRIANGLES).replace(b"\n", b"\r\n")):
        mesh = load(tmp_path, "a.stl", data)
        mesh.save(tmp_path / "b.stl", mesh.vertices)
        assert (tmp_path / "b.stl").read_bytes() == data


@pytest.mark.parametrize("write", [text_stl, binary_stl])
def test_only_what_moved_changes(tmp_path: Path, write: object) -> None:
    assert callable(write)
    mesh = load(tmp_path, "a.stl", write(TRIANGLES))
    X, after = mesh.vertices.copy(), TRIANGLES.copy()
    X[(mesh.vertices == [1, 0, 0]).all(axis=1)] = [2.5, 0, 0]  # in the plane: no normal turns
    after[(TRIANGLES == [1, 0, 0]).all(axis=2)] = [2.5, 0, 0]
    mesh.save(tmp_path / "b.stl", X)
    assert (tmp_path / "b.stl").read_bytes() == write(after)


@pytest.mark.parametrize("write", [text_stl, binary_stl])
def test_normals_turn_with_their_triangles(tmp_path: Path, write: object) -> None:
    assert callable(write)
    mesh = load(tmp_path, "a.stl", write(TRIANGLES))
    mesh.save(tmp_path / "b.stl", mesh.vertices[:, [2, 1, 0]] * [1, 1, -1] + 0.0)
    data = (tmp_path / "b.stl").read_bytes()
    if write is text_stl:
        lines = [line for line in data.lower().splitlines() if b"facet normal" in line]
        found = [[float(word) for word in line.split()[2:]] for line in lines]
    else:
        found = [list(struct.unpack_from("<3f", data, 84 + 50 * k)) for k in range(3)]
        assert data[:84] == write(TRIANGLES)[:84]
    np.testing.assert_allclose(found, [[1, 0, 0], [1, 0, 0], [0, 0, 0]], atol=1e-7)


def test_attributes_are_counted_and_text_keeps_float64(tmp_path: Path) -> None:
    assert load(tmp_path, "a.stl", binary_stl(TRIANGLES)).extras == {"triangle attributes": 2}
    mesh = load(tmp_path, "a.stl", text_stl(TRIANGLES))
    assert mesh.extras == {}
    mesh.save(tmp_path / "b.stl", mesh.vertices + 1 / 3)
    assert load_mesh(tmp_path / "b.stl").vertices.tobytes() == (mesh.vertices + 1 / 3).tobytes()


@pytest.mark.parametrize("normal", [b"nan nan nan", b"1e300 1e300 0", b"inf 0 0", b"x", b""])
def test_a_normal_that_is_none_stays(
    tmp_path: Path, capfd: pytest.CaptureFixture[str], normal: bytes
) -> None:
    data = text_stl(TRIANGLES).replace(b"0.0 0.0 1.0", normal, 1)
    mesh = load(tmp_path, "a.stl", data)
    mesh.save(tmp_path / "b.stl", mesh.vertices[:, [2, 1, 0]] * [1, 1, -1])
    assert b"Normal %b" % normal in (tmp_path / "b.stl").read_bytes()
    assert capfd.readouterr() == ("", "")
