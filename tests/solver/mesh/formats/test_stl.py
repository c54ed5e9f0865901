"""STL files: triangles that become a surface, and what is refused."""

from __future__ import annotations

import re
import struct
from pathlib import Path

import numpy as np
import pytest

from solver.errors import MeshError
from solver.mesh.mesh import Mesh, load_mesh
from tests.solver.mesh.formats.files import check_damage, check_refusal, load, surface

STL = (
    b"solid a\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 1 0 0\n"
    b"   vertex 0 1 0\n  endloop\n endfacet\nendsolid a\n"
)
STL_BYTES = bytes(80) + struct.pack("<I12fH", 1, *[0.0] * 3, *range(9), 0)


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


@pytest.mark.parametrize(
    ("data", "words"),
    [
        (b"", "empty, expected an STL mesh"),
        (b"hello", "not an STL mesh, or cut short: 5 bytes, expected 134 or more"),
        (bytes(84), "not an STL mesh"),
        (STL_BYTES[:-1], "cut short: 133 bytes, expected 134"),
        (bytes(80) + b"\xff\xff\xff\xff" + bytes(500), "cut short"),
        (STL_BYTES[:100] + b"\xff" * 34, "triangle 1: expected finite coordinates"),
        (STL[:-12], "ends early, got 3 vertices for 1 facets"),
        (STL[:80], "ends early, got 2 vertices for 1 facets"),
        (STL.replace(b"1 0 0", b"1 x 0"), "line 5: expected three numbers x y z"),
        (STL.replace(b"1 0 0", b"1 inf 0"), "line 5: expected finite coordinates"),
        (b"solid facet\nendsolid", "no faces, expected at least one"),
        (STL + b"\0", "binary data, expected an STL mesh"),
    ],
)
def test_bad_files_give_one_line_that_says_what_was_expected(
    tmp_path: Path, capfd: pytest.CaptureFixture[str], data: bytes, words: str
) -> None:
    check_refusal(tmp_path / "a.stl", data, words)
    assert capfd.readouterr() == ("", "")


@pytest.mark.parametrize("whole", [STL, STL_BYTES])
def test_a_file_cut_or_damaged_anywhere_loads_or_gives_one_line(
    tmp_path: Path, whole: bytes
) -> None:
    check_damage(tmp_path / "a.stl", whole)


def test_vertices_that_would_become_one_are_counted_and_refused(tmp_path: Path) -> None:
    V, F = surface()
    mesh = Mesh.from_arrays(V, F)
    path = tmp_path / "out.stl"
    mesh.save(path, 0.01 * V)
    before = path.read_bytes()
    with pytest.raises(MeshError) as caught:
        mesh.save(path, 0.01 * V + 1e6)
    assert re.fullmatch(
        rf"{path}: {len(np.unique(F))} vertices would become one with a neighbour in float32, "
        r"so far from the origin; expected a format of more digits \(\.obj, \.off, \.ply\)",
        str(caught.value),
    )
    assert path.read_bytes() == before
    mesh.save(path, 0.01 * V + 1e3)  # as coarse as the numbers are, but nothing vanishes


def test_an_edge_that_nobody_sees_may_vanish(tmp_path: Path) -> None:
    V = np.array([[0, 0, 0], [1, 0, 0], [1 + 1e-9, 0, 0], [0, 1, 0.0]])
    mesh = Mesh.from_arrays(V, [[0, 1, 3], [1, 2, 3]])
    mesh.save(tmp_path / "out.stl", V)
    assert len(load_mesh(tmp_path / "out.stl").vertices) == 3
