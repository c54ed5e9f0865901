"""Writing an OFF that was read: all stays but positions that moved and normals that turned."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from solver.mesh.mesh import load_mesh
from tests.solver.mesh.formats.files import load

COLOURED = b"""# made by hand
COFF # colours
4 2 5

0 0 0  255 0 0 255 # red
1 0 0\t0 255 0 255
1 1 0 0 0 255 255
0 1.000 0 9 9 9 9
3 0 1 2 0.5 0.5 0.5 # grey
3 0 2 3

# the end
"""


@pytest.mark.parametrize("data", [COLOURED, COLOURED.replace(b"\n", b"\r\n")])
def test_colours_and_comments_stay(tmp_path: Path, data: bytes) -> None:
    mesh = load(tmp_path, "a.off", data)
    assert mesh.extras == {"colours": 4, "face colours": 1}
    mesh.save(tmp_path / "b.off", mesh.vertices)
    assert (tmp_path / "b.off").read_bytes() == data
    X = mesh.vertices.copy()
    X[1] = [1 / 3, -1e-7, 2]
    mesh.save(tmp_path / "b.off", X)
    expected = data.replace(b"1 0 0\t", b"0.3333333333333333 -1e-07 2.0\t")
    assert (tmp_path / "b.off").read_bytes() == expected


def test_normals_turn_with_the_surface(tmp_path: Path) -> None:
    rows = b"0 0 0 0 0 2 7\n1 0 0 0 0 2 7\n1 1 0 0 0 2 7\n0 1 0 nan 0 x 7\n"
    mesh = load(tmp_path, "a.off", b"NOFF 4 1 0\n" + rows + b"4 0 1 2 3")
    assert mesh.extras == {"normals": 4}
    mesh.save(tmp_path / "b.off", mesh.vertices[:, [2, 1, 0]] * [1, 1, -1])
    lines = (tmp_path / "b.off").read_bytes().splitlines()
    np.testing.assert_array_equal(
        [[float(word) for word in line.split()] for line in lines[1:4]],
        [[0, 0, 0, 2, 0, 0, 7], [0, 0, -1, 2, 0, 0, 7], [0, 1, -1, 2, 0, 0, 7]],
    )
    assert lines[4].endswith(b" nan 0 x 7")


def test_a_byte_order_mark_is_no_part_of_the_text(tmp_path: Path) -> None:
    data = b"\xef\xbb\xbfOFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"
    mesh = load(tmp_path, "a.off", data)
    mesh.save(tmp_path / "b.off", mesh.vertices + 1)
    assert (tmp_path / "b.off").read_bytes().startswith(b"\xef\xbb\xbfOFF\n3 1 0\n1.0 1.0 1.0\n")
    assert load_mesh(tmp_path / "b.off").vertices.tolist() == (mesh.vertices + 1).tolist()
