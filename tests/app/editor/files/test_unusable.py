"""Meshes that cannot be deformed are not opened: a message, and what was open stays."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from app.editor import commands as c
from app.model.session.files import session_name
from solver import Mesh
from tests.app.person import Person, error_of


@pytest.mark.parametrize(
    ("factor", "words"),
    [
        (0.0, "all faces lie in one point, expected a size of 1e-18 or more"),
        (1e-200, "the surface is 1e-200 large, expected a size of 1e-18 or more"),
        (1e160, "vertex 1: expected coordinates up to 1e+18, got [1e+160, 0.0, 0.0]"),
    ],
)
def test_a_mesh_of_no_usable_size_is_not_opened(
    ready: Person, tmp_path: Path, factor: float, words: str
) -> None:
    V = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0.0]])
    mesh = Mesh.from_arrays(V, [[0, 1, 2]])
    path = tmp_path / "m.obj"
    mesh.save(path, factor * V)
    before = ready.editor.document
    ready.do(c.OpenMesh(path))
    assert error_of(ready).startswith(str(path))
    assert words in error_of(ready)
    assert ready.editor.document is before


@pytest.mark.parametrize("path", [Path("."), Path("/"), Path("..")], ids=str)
@pytest.mark.parametrize(
    ("command", "words"),
    [
        (c.OpenMesh, "unknown mesh format"),
        (c.OpenSession, "expected a file"),
        (lambda path: c.SaveSession(session_name(path)), "is a folder, expected a file"),
        (c.Export, "is a folder, expected a file"),
        (c.ExportPoses, "unknown mesh format"),
    ],
    ids=["open", "open session", "save", "export", "export poses"],
)
def test_a_folder_that_is_typed_in_place_of_a_file_is_a_message(
    ready: Person, command: Callable[[Path], c.Command], words: str, path: Path
) -> None:
    ready.do(c.KeepPose())
    before = ready.editor.document
    ready.do(command(path))
    assert words in error_of(ready)
    assert ready.editor.document is before
