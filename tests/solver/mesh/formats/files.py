"""Small files and surfaces for the tests of formats, and what every format promises."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from solver.errors import MeshError
from solver.mesh.mesh import Mesh, load_mesh
from solver.types import FloatArray, IntArray

MESHES = Path(__file__).resolve().parents[4] / ".." / "shared" / "meshes"
SQUARE = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 1 / 3]])


def load(folder: Path, name: str, data: bytes) -> Mesh:
    (folder / name).write_bytes(data)
    return load_mesh(folder / name)


def surface(seed: int = 0) -> tuple[FloatArray, IntArray]:
    """A bumpy grid of triangles with float64 noise."""
    i = np.arange(42).reshape(6, 7)
    a, b, c, d = (s.ravel() for s in (i[:-1, :-1], i[:-1, 1:], i[1:, 1:], i[1:, :-1]))
    x, y = np.meshgrid(np.arange(7.0), np.arange(6.0))
    V = np.stack([x.ravel(), y.ravel(), np.zeros(42)], axis=1)
    V += 0.1 * np.random.default_rng(seed).normal(size=V.shape)
    return V, np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])


def check_refusal(path: Path, data: bytes, words: str) -> None:
    """The file is refused in one line that starts with its path and holds `words`."""
    with pytest.raises(MeshError) as caught:
        load(path.parent, path.name, data)
    message = str(caught.value)
    assert words in message
    assert message.startswith(str(path))
    assert len(message.splitlines()) == 1


def check_damage(path: Path, whole: bytes) -> None:
    """A file cut or damaged anywhere loads or is refused in one line."""
    rng = np.random.default_rng(0)
    assert len(load(path.parent, path.name, whole).faces) > 0
    for i in range(len(whole)):
        for data in (whole[:i], whole[:i] + rng.bytes(1) + whole[i + 1 :]):
            message = ""
            try:
                mesh = load(path.parent, path.name, data)
                assert mesh.faces.max() < len(mesh.vertices)
            except MeshError as error:
                message = str(error)
            assert len(message.splitlines()) <= 1
