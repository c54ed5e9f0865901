"""OBJ files of several megabytes, which are read and written in blocks."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from solver.mesh.mesh import Mesh, load_mesh
from solver.types import FloatArray, IntArray
from tests.solver.mesh.formats.files import check_refusal, load

COUNT = 30_000


def strip() -> tuple[FloatArray, IntArray]:
    """A long strip of quads, (n, 3) and (m, 4)."""
    V = np.random.default_rng(0).normal(size=(COUNT, 3))
    i = np.arange(0, COUNT - 2, 2)
    return V, np.stack([i, i + 1, i + 3, i + 2], axis=1)


def text(V: FloatArray, F: IntArray) -> bytes:
    """Comments, normals and groups among the lines; every other face counts back."""
    lines = [b"# corner\nv %a %a %a 1 # x\nvn 0 0 1\n" % tuple(p) for p in V.tolist()]
    for k, face in enumerate((F - COUNT * (np.arange(len(F)) % 2)[:, None]).tolist()):
        corners = [v if v < 0 else v + 1 for v in face]
        lines.append(b"g %d\nf %d//1 %d//1 %d//1 %d//1\r\n" % (k, *corners))
    return b"".join(lines)


@pytest.fixture(scope="module")
def large(tmp_path_factory: pytest.TempPathFactory) -> tuple[Mesh, bytes]:
    data = text(*strip())
    return load(tmp_path_factory.mktemp("large"), "a.obj", data), data


def test_every_line_is_read(large: tuple[Mesh, bytes]) -> None:
    V, F = strip()
    assert large[0].vertices.tobytes() == V.tobytes()
    np.testing.assert_array_equal(large[0].polygons, F)
    assert large[0].extras == {
        "texture coordinates": 0,
        "normals": COUNT,
        "objects": 0,
        "groups": len(F),
    }


def test_every_moved_line_is_written(large: tuple[Mesh, bytes], tmp_path: Path) -> None:
    mesh, data = large
    X = mesh.vertices.copy()
    X[::3] += 100
    mesh.save(tmp_path / "out.obj", X)
    lines, written = data.split(b"\n"), (tmp_path / "out.obj").read_bytes().split(b"\n")
    expected = [
        b"v %a %a %a 1 # x" % tuple(X[i // 3].tolist()) if line[:2] == b"v " else line
        for i, line in enumerate(lines)
    ]
    unchanged = [line[:2] != b"vn" for line in lines]
    assert [a for a, same in zip(written, unchanged, strict=True) if same] == [
        b for b, same in zip(expected, unchanged, strict=True) if same
    ]


def test_without_a_source_everything_is_written(tmp_path: Path) -> None:
    V, F = strip()
    Mesh.from_arrays(V, F).save(tmp_path / "a.obj", V)
    again = load_mesh(tmp_path / "a.obj")
    assert again.vertices.tobytes() == V.tobytes()
    np.testing.assert_array_equal(again.polygons, F)


def test_what_is_wrong_late_in_the_file_is_named(tmp_path: Path) -> None:
    data = text(*strip())
    number = len(data.splitlines()) + 1
    for line in (b"f 1 2 99999", b"f 1 2 x", b"f 1 2", b"v 1 2", b"v 1 2 inf"):
        check_refusal(tmp_path / "a.obj", data + line, f"line {number}: ")
    # Vertices are told before faces, wherever they are.
    check_refusal(tmp_path / "a.obj", b"f 1 2\n" + data + b"v 1 2", f"line {number + 1}: ")
