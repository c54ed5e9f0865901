"""OFF files: every way to write one, and what is refused."""

from __future__ import annotations

from pathlib import Path

import igl
import numpy as np
import pytest

from solver.mesh.mesh import load_mesh
from tests.solver.mesh.formats.files import MESHES, SQUARE, check_damage, check_refusal, load

OFF_ROWS = b"0 0 0\n1 0 0\n1 1 0\n0 1 0\n"


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


@pytest.mark.parametrize(
    ("data", "words"),
    [
        (b"", "empty, expected an OFF mesh"),
        (b"\0\1\2", "binary data, expected an OFF mesh"),
        (b"hello", "line 1: expected an OFF file that starts with 'OFF', got 'hello'"),
        (b"# only this\n", "line 1: expected an OFF file"),
        (b"4OFF\n1 1 1\n", "line 1: expected an OFF file"),
        (b"OFF BINARY\n", "line 1: expected the numbers of vertices and faces"),
        (b"OFF\n", "line 1: expected the numbers of vertices and faces"),
        (b"OFF\n-4 1 0\n", "line 2: expected the numbers of vertices and faces"),
        (b"OFF\n4\n", "line 2: expected the numbers of vertices and faces"),
        (b"OFF\n4 1 0\n" + OFF_ROWS, "ends early, expected 4 vertices and 1 faces"),
        (b"OFF\n99999999999 1 0\n" + OFF_ROWS, "ends early"),
        (b"OFF\n4 0 0\n" + OFF_ROWS, "no faces, expected at least one"),
        (b"OFF\n0 0 0\n", "no faces, expected at least one"),
        (b"OFF\n4 1 0\n" + OFF_ROWS + b"3 0 1 4\n", "line 7: the face names vertex 4"),
        (b"OFF\n4 1 0\n" + OFF_ROWS + b"3 0 1 -1\n", "line 7: the face names vertex -1"),
        (b"OFF\n4 1 0\n" + OFF_ROWS + b"2 0 1\n", "line 7: expected a count of at least"),
        (b"OFF\n4 1 0\n" + OFF_ROWS + b"3 0 1\n", "line 7: expected a count of at least"),
        (
            b"OFF\n4 1 0\n" + OFF_ROWS + b"3 0 1 b\n",
            "line 7: expected a count of at least",
        ),
        (b"OFF\n4 1 0\n0 0\n" + OFF_ROWS, "line 3: expected three numbers"),
        (b"OFF\n4 1 0\n0 x 0\n" + OFF_ROWS, "line 3: expected three numbers"),
        (b"OFF\n4 1 0\n0 nan 0\n" + OFF_ROWS, "line 3: expected finite coordinates"),
    ],
)
def test_bad_files_give_one_line_that_says_what_was_expected(
    tmp_path: Path, capfd: pytest.CaptureFixture[str], data: bytes, words: str
) -> None:
    check_refusal(tmp_path / "a.off", data, words)
    assert capfd.readouterr() == ("", "")


def test_a_file_cut_or_damaged_anywhere_loads_or_gives_one_line(tmp_path: Path) -> None:
    check_damage(tmp_path / "a.off", b"COFF\n4 2 0\n" + OFF_ROWS + b"3 0 1 2\n4 0 1 2 3\n")


def test_the_shared_off_meshes_match_libigl() -> None:
    paths = sorted(MESHES.rglob("*.off"))
    if not paths:
        pytest.skip("the shared meshes are not there")
    for path in paths:
        mesh = load_mesh(path)
        V, F = igl.read_triangle_mesh(str(path))
        np.testing.assert_allclose(mesh.vertices, V, rtol=1e-15)
        np.testing.assert_array_equal(mesh.faces, F)
