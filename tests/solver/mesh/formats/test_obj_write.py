"""Writing OBJ files: what has not changed stays to the byte, and normals turn with the surface."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from solver.mesh.mesh import Mesh, load_mesh
from solver.types import FloatArray
from tests.solver.mesh.formats.files import MESHES

# A cube with hard edges: one normal a side, lengths that are not one, every oddity of the format.
CUBE = b"""\xef\xbb\xbf# caf\xe9 \xff
mtllib a.mtl\r
v -1 -1 -1.000
v  1 -1\t-1 # corner
  v 1 1 -1 0.5
v -1 1 -1 0.1 0.2 0.3
v -1 -1 1 1 0.1 0.2 0.3#end\r
v 1 \\
  -1 \\\r
  1 0.5 # continued
v 1.0e0 +1 1
v -1 1 1
v 7 7 7
vt 0 0\r
vn 0 0 -2
vn 0  0 1 # up
vn\t0 -1 0
vn 0 1 0
vn 0.5 0 0
vn -1 0 0
vn 0 0 0
vn nan 0 0
vn 1 1 1
g bottom\r\no x
usemtl red
f 1/1/1 4/1/1 3/1/1 2/1/1
f -5//2 -4//2 -3//2 -2//2
f 1//3 2//3 6//3 5//3
s 1
f 3//4 4//4 8//4 7//4
f 2//5 3//5 7//5 6//5
f 1//6 5//6 8//6 4//6
f 1//7 2//8 3
l 1 2
p 3"""


def cube(folder: Path, data: bytes = CUBE) -> Mesh:
    path = folder / "cube.obj"
    path.write_bytes(data)
    return load_mesh(path)


def saved(mesh: Mesh, X: FloatArray, folder: Path) -> bytes:
    mesh.save(folder / "out.obj", X)
    return (folder / "out.obj").read_bytes()


def numbers(data: bytes, key: bytes) -> FloatArray:
    """The three numbers of every line with this keyword."""
    joined = data.replace(b"\\\r\n", b" ").replace(b"\\\n", b" ").removeprefix(b"\xef\xbb\xbf")
    rows = [line.split(b"#")[0].split() for line in joined.splitlines()]
    return np.array([[float(x) for x in row[1:4]] for row in rows if row[:1] == [key]])


def rotation(seed: int = 0) -> FloatArray:
    q, _ = np.linalg.qr(np.random.default_rng(seed).normal(size=(3, 3)))
    return np.asarray(q * np.linalg.det(q))


@pytest.mark.parametrize("ending", [b"\n", b"\r\n", b"\r"])
@pytest.mark.parametrize("last", [b"", b"\n", b"\n\n  "])
def test_saving_the_rest_positions_gives_the_source(
    tmp_path: Path, ending: bytes, last: bytes
) -> None:
    data = CUBE.replace(b"\r\n", b"\n").replace(b"\n", ending) + last
    mesh = cube(tmp_path, data)
    assert saved(mesh, mesh.vertices, tmp_path) == data


def test_positions_read_back_bit_for_bit(tmp_path: Path) -> None:
    mesh = cube(tmp_path)
    rng = np.random.default_rng(1)
    X = rng.normal(size=(9, 3)) * 10.0 ** rng.integers(-200, 200, size=(9, 3))
    X[0] = [-0.0, 5e-324, 1.7976931348623157e307]
    mesh.save(tmp_path / "out.obj", X)
    again = load_mesh(tmp_path / "out.obj").vertices
    assert again.tobytes() == X.tobytes()


def test_the_sign_of_zero_moves_nothing(tmp_path: Path) -> None:
    data = b"v 0 -0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3"
    mesh = cube(tmp_path, data)
    X = mesh.vertices.copy()
    X[0] = -X[0]
    assert saved(mesh, X, tmp_path) == data


def test_only_the_coordinates_of_moved_lines_change(tmp_path: Path) -> None:
    data = b"\n".join(
        [
            b"# v 0 0 0",
            b"v 0 0 0 0.25 0.5 0.75 # keep",
            b"  v\t1  0 \\",
            b"  0 1\r",
            b"v 0 1 0#tight",
            b"v 5 5 5.000",
            b"vn 0 0 1 # n",
            b"vt 0 0",
            b"f 1//1 2//1 3//1",
            b"f 1 2 4",
        ]
    )
    mesh = cube(tmp_path, data)
    X = mesh.vertices.copy()
    X[:3] = [[0.5, 0, 0], [0.5, 1, 0], [0.5, 0, 1 / 3]]
    assert saved(mesh, X, tmp_path).split(b"\n") == [
        b"# v 0 0 0",
        b"v 0.5 0.0 0.0 0.25 0.5 0.75 # keep",
        b"  v\t0.5  1.0 \\",
        b"  0.0 1\r",
        b"v 0.5 0.0 0.3333333333333333#tight",
        b"v 5 5 5.000",
        b"vn 1.0 0.0 0.0 # n",
        b"vt 0 0",
        b"f 1//1 2//1 3//1",
        b"f 1 2 4",
    ]


def test_hard_edges_stay_hard_when_everything_turns(tmp_path: Path) -> None:
    mesh = cube(tmp_path)
    R = rotation()
    out = saved(mesh, mesh.vertices @ R.T + [3, -2, 1], tmp_path)
    before, after = numbers(CUBE, b"vn"), numbers(out, b"vn")
    # Six sides turn and keep their lengths; zero, unreadable and unused normals stay.
    np.testing.assert_allclose(after[:6], before[:6] @ R.T, atol=1e-12)
    for line in (b"\nvn 0 0 0\n", b"\nvn nan 0 0\n", b"\nvn 1 1 1\n"):
        assert line in out
    np.testing.assert_allclose(numbers(out, b"v"), mesh.vertices @ R.T + [3, -2, 1], atol=1e-12)
    kept = [line for line in CUBE.splitlines(True) if not line.startswith((b"v ", b"vn", b" "))]
    assert all(line in out.splitlines(keepends=True) for line in kept)


def test_a_translation_keeps_every_normal_line(tmp_path: Path) -> None:
    mesh = cube(tmp_path)
    out = saved(mesh, mesh.vertices + np.array([0.1, 0.2, 0.3]), tmp_path)
    lines = [line for line in CUBE.splitlines(keepends=True) if line.startswith(b"vn")]
    assert [line for line in out.splitlines(keepends=True) if line.startswith(b"vn")] == lines


TWO = (
    b"v 0 0 0\nv 1 0 0\nv 0 1 0\nv 10 0 0\nv 12 0 0\nv 10 2 0\n"
    b"vn 0 0 1\nvn 0 0 1.0\nvn 0 0 3\nf 1//1 2//1 3//3\nf 4//2 5//2 6//3\n"
)


def turn_second_triangle(V: FloatArray, angle: float) -> FloatArray:
    """The second triangle of TWO, turned about its first edge (the x axis)."""
    X = V.copy()
    X[5] = [10, 2 * np.cos(angle), 2 * np.sin(angle)]
    return X


def test_a_normal_whose_corners_did_not_turn_keeps_its_line(tmp_path: Path) -> None:
    mesh = cube(tmp_path, TWO)
    out = saved(mesh, turn_second_triangle(mesh.vertices, np.pi / 2), tmp_path)
    changed = [
        i for i, (a, b) in enumerate(zip(TWO.split(b"\n"), out.split(b"\n"), strict=True)) if a != b
    ]
    assert changed == [5, 7, 8]


def test_a_shared_normal_is_the_mean_weighted_by_area_at_its_own_length(tmp_path: Path) -> None:
    mesh = cube(tmp_path, TWO)
    out = saved(mesh, turn_second_triangle(mesh.vertices, np.pi / 2), tmp_path)
    # Areas 1/2 and 2; the second triangle's normal turns from z to -y.
    expected = np.array([0, -2.0, 0.5]) / np.hypot(2, 0.5) * 3
    np.testing.assert_allclose(numbers(out, b"vn")[2], expected, atol=1e-12)


@pytest.mark.parametrize("collapse", ["rest", "deformed"])
def test_corners_of_triangles_without_area_have_no_vote(tmp_path: Path, collapse: str) -> None:
    flat = TWO.replace(b"v 10 2 0", b"v 14 0 0") if collapse == "rest" else TWO
    mesh = cube(tmp_path, flat)
    X = mesh.vertices.copy()
    X[5] = [14, 0, 0] if collapse == "deformed" else [10, 0, 2]
    out = saved(mesh, X, tmp_path)
    assert out.split(b"\n")[6:] == flat.split(b"\n")[6:]


def test_opposite_votes_leave_the_normal_alone(tmp_path: Path) -> None:
    data = TWO.replace(b"v 12 0 0", b"v 11 0 0").replace(b"v 10 2 0", b"v 10 1 0")
    mesh = cube(tmp_path, data)
    X = mesh.vertices.copy()
    X[5] = [10, -1, 0]
    assert b"vn 0 0 3\n" in saved(mesh, X, tmp_path)


def test_saving_needs_no_source_file_and_may_replace_it(tmp_path: Path) -> None:
    mesh = cube(tmp_path)
    R = rotation(2)
    source = tmp_path / "cube.obj"
    mesh.save(source, mesh.vertices @ R.T)
    source.unlink()
    mesh.save(source, mesh.vertices)
    assert source.read_bytes() == CUBE


def test_faces_are_the_same_after_a_round_trip(tmp_path: Path) -> None:
    mesh = cube(tmp_path)
    mesh.save(tmp_path / "out.obj", mesh.vertices @ rotation(3).T)
    again = load_mesh(tmp_path / "out.obj")
    np.testing.assert_array_equal(again.outlines.corners, mesh.outlines.corners)
    assert again.polygons == mesh.polygons


@pytest.mark.parametrize("name", ["arm.obj", "spot.obj", "quadknot.obj"])
def test_real_meshes_keep_everything_and_turn_their_normals(tmp_path: Path, name: str) -> None:
    if not (MESHES / name).is_file():
        pytest.skip(f"{name} is not there")
    mesh = load_mesh(MESHES / name)
    source = (MESHES / name).read_bytes()
    assert saved(mesh, mesh.vertices, tmp_path) == source
    R = rotation(4)
    out = saved(mesh, mesh.vertices @ R.T, tmp_path)
    pairs = zip(source.split(b"\n"), out.split(b"\n"), strict=True)
    assert all(a == b or a[:2] in (b"v ", b"vn") for a, b in pairs)
    if numbers(source, b"vn").size:
        np.testing.assert_allclose(numbers(out, b"vn"), numbers(source, b"vn") @ R.T, atol=1e-9)
