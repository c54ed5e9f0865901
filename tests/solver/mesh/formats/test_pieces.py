"""Text is made piece by piece: where one ends does not show."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from solver import load_mesh
from solver.mesh.formats.text import listing, splice

SOURCE = """v 0 0 0
v 1 0 0
v 2 0 0.5
v 0 1 0
v 1 1 0
v 2 1 0.25
v 3 0.5 1e-3
f 1 2 5 4
f 2 3 6 5
f 3 7 6
"""


@pytest.mark.parametrize("name", ["out.obj", "out.off", "other.obj"])
@pytest.mark.parametrize("piece", [1, 2, 3, 7])
def test_how_much_is_made_at_a_time_does_not_change_a_file(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str, piece: int
) -> None:
    (tmp_path / "in.obj").write_text(SOURCE)
    mesh = load_mesh(tmp_path / "in.obj")
    if name == "other.obj":  # written anew, not spliced into what was read
        mesh.save(tmp_path / "in.off", mesh.vertices)
        mesh = load_mesh(tmp_path / "in.off")
    X = mesh.vertices * np.pi
    mesh.save(tmp_path / name, X)
    whole = (tmp_path / name).read_bytes()
    np.testing.assert_array_equal(load_mesh(tmp_path / name).vertices, X)
    for module in (listing, splice):
        monkeypatch.setattr(module, "PIECE", piece)
    mesh.save(tmp_path / name, X)
    assert (tmp_path / name).read_bytes() == whole
