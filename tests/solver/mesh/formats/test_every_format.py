"""What all formats promise: surfaces survive, and libigl agrees."""

from __future__ import annotations

from pathlib import Path

import igl
import numpy as np
import pytest

from solver.errors import MeshError
from solver.mesh.mesh import Mesh, load_mesh
from tests.solver.mesh.formats.files import load, surface

END = b"end_header\n"


@pytest.mark.parametrize("suffix", [".off", ".ply", ".obj", ".OFF", ".Ply"])
def test_positions_and_polygons_survive_bit_for_bit(tmp_path: Path, suffix: str) -> None:
    rng = np.random.default_rng(0)
    hexagon = b"f 1 2 3 4 5 6\nf 1 2 7\nf 3 2 7 4\n"
    lines = b"".join(b"v %a %a %a\n" % tuple(p) for p in rng.normal(size=(7, 3)).tolist())
    mesh = load(tmp_path, "source.obj", lines + hexagon)
    X = rng.normal(size=(7, 3)) * 1e5
    mesh.save(tmp_path / f"out{suffix}", X)
    again = load_mesh(tmp_path / f"out{suffix}")
    assert again.vertices.tobytes() == X.tobytes()
    assert again.polygons == mesh.polygons


@pytest.mark.parametrize("suffix", [".off", ".ply", ".stl"])
@pytest.mark.parametrize("encoding", [igl.FileEncoding.Ascii, igl.FileEncoding.Binary])
def test_files_written_by_libigl_are_read(
    tmp_path: Path, suffix: str, encoding: igl.FileEncoding
) -> None:
    V, F = surface()
    igl.write_triangle_mesh(str(tmp_path / f"a{suffix}"), V, F, encoding)
    mesh = load_mesh(tmp_path / f"a{suffix}")
    assert mesh.vertices.shape == V.shape
    np.testing.assert_allclose(mesh.vertices[mesh.faces], V[F], atol=1e-5)


@pytest.mark.parametrize("suffix", [".off", ".ply", ".stl", ".obj"])
def test_libigl_reads_what_is_written(tmp_path: Path, suffix: str) -> None:
    V, F = surface()
    Mesh.from_arrays(V, F).save(tmp_path / f"a{suffix}", V)
    W, G = igl.read_triangle_mesh(str(tmp_path / f"a{suffix}"))
    np.testing.assert_allclose(W[G], V[F], rtol=1e-6, atol=1e-6)


@pytest.mark.parametrize("suffix", [".stl", ".ply", ".glb"])
def test_what_a_file_cannot_hold_is_refused_and_the_file_stays(tmp_path: Path, suffix: str) -> None:
    """A finite coordinate that became infinite could not be read again."""
    V, F = surface()
    Mesh.from_arrays(V, F).save(tmp_path / f"a{suffix}", V)
    path = tmp_path / f"a{suffix}"
    if suffix == ".ply":  # ours is in float64
        head, whole = path.read_bytes().replace(b"property double", b"property float").split(END)
        path.write_bytes(head + END + V.astype("<f4").tobytes() + whole[V.nbytes :])
    mesh, before = load_mesh(path), path.read_bytes()
    huge = mesh.vertices.copy()
    huge[0, 0] = 1e39
    with pytest.raises(MeshError, match=r"coordinates up to 1e\+39 do not fit float32"):
        mesh.save(path, huge)
    assert path.read_bytes() == before
