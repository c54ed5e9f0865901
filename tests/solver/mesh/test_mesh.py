"""Meshes from arrays and files, and what is refused."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from solver.errors import FileError, MeshError
from solver.mesh.mesh import Mesh, load_mesh

V = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0.0]])


@pytest.mark.parametrize("dtype", [np.int32, np.uint8, np.int64])
def test_arrays_make_a_mesh(dtype: type) -> None:
    mesh = Mesh.from_arrays(V.tolist(), np.array([[0, 1, 2], [0, 2, 3]], dtype=dtype))
    assert mesh.vertices.dtype == np.float64
    assert mesh.faces.dtype == np.int64
    assert mesh.faces.tolist() == [[0, 1, 2], [0, 2, 3]]


def test_quads_are_split_and_kept_for_display() -> None:
    mesh = Mesh.from_arrays(V, [[0, 1, 2, 3]])
    assert mesh.faces.tolist() == [[0, 1, 2], [0, 2, 3]]
    assert np.asarray(mesh.polygons).tolist() == [[0, 1, 2, 3]]
    np.testing.assert_array_equal(mesh.outlines.corners[mesh.triangle_corners], mesh.faces)


def test_a_mesh_cannot_change_and_does_not_follow_its_arrays() -> None:
    W, F = V.copy(), np.array([[0, 1, 2], [0, 2, 3]])
    mesh = Mesh.from_arrays(W, F)
    W[:], F[:] = 7, 0
    assert mesh.vertices.tolist() == V.tolist()
    assert mesh.faces.tolist() == [[0, 1, 2], [0, 2, 3]]
    for array in (mesh.vertices, mesh.faces, mesh.polygons):
        with pytest.raises(ValueError, match="read-only"):
            np.asarray(array)[0] = 1


@pytest.mark.parametrize(
    ("positions", "faces", "words"),
    [
        (V[:, :2], [[0, 1, 2]], r"positions must be \(n, 3\), got \(4, 2\)"),
        ([["a"]], [[0, 1, 2]], r"positions must be \(n, 3\) numbers, got list"),
        (V * [np.nan, 1, 1], [[0, 1, 2]], r"positions must be finite, got \[nan, .*at vertex 0"),
        (V, [[0, 1]], r"faces must be \(m, 3\) or \(m, 4\), got \(1, 2\)"),
        (V, [0, 1, 2], r"faces must be \(m, 3\) or \(m, 4\), got \(3,\)"),
        (V, [[0.0, 1.0, 2.0]], "faces must be whole numbers, got float64"),
        (V, [[0, 1, 2], [0, 1, 4]], "face 1 names vertex 4, but they go from 0 to 3"),
        (V, [[0, 1, -1]], "face 0 names vertex -1, but they go from 0 to 3"),
        (V, np.empty((0, 3), dtype=int), "no faces, expected at least one"),
    ],
)
def test_arrays_that_are_no_mesh_are_refused(positions: Any, faces: Any, words: str) -> None:
    with pytest.raises(MeshError, match=words):
        Mesh.from_arrays(positions, faces)


@pytest.mark.parametrize(
    ("X", "words"),
    [
        (V[:3], r"positions must be \(4, 3\), got \(3, 3\)"),
        (V.ravel(), r"positions must be \(n, 3\), got \(12,\)"),
        (np.where(V > 0, np.inf, V), "positions must be finite"),
        (None, "positions must be"),
    ],
)
def test_positions_that_do_not_fit_are_refused_and_nothing_is_written(
    tmp_path: Path, X: Any, words: str
) -> None:
    with pytest.raises(MeshError, match=words):
        Mesh.from_arrays(V, [[0, 1, 2]]).save(tmp_path / "a.obj", X)
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("name", ["a.fbx", "a", "a.obj.gz", ".obj"])
def test_other_formats_are_refused_by_name(tmp_path: Path, name: str) -> None:
    words = "unknown mesh format .*, expected .obj, .off, .ply, .stl"
    with pytest.raises(MeshError, match=words):
        load_mesh(tmp_path / name)
    with pytest.raises(MeshError, match=words):
        Mesh.from_arrays(V, [[0, 1, 2]]).save(tmp_path / name, V)


@pytest.mark.parametrize("suffix", [".obj", ".off", ".ply", ".stl"])
def test_a_missing_file_and_a_folder_are_named(tmp_path: Path, suffix: str) -> None:
    with pytest.raises(FileError, match="missing"):
        load_mesh(tmp_path / f"missing{suffix}")
    (tmp_path / f"folder{suffix}").mkdir()
    with pytest.raises(FileError, match="is a folder, expected a file"):
        load_mesh(tmp_path / f"folder{suffix}")


def test_a_missing_output_folder_is_named(tmp_path: Path) -> None:
    with pytest.raises(FileError, match="nowhere does not exist"):
        Mesh.from_arrays(V, [[0, 1, 2]]).save(tmp_path / "nowhere" / "a.obj", V)


def test_paths_may_be_strings_with_any_letters_and_case(tmp_path: Path) -> None:
    path = str(tmp_path / "Schädel 頭.OBJ")
    Mesh.from_arrays(V, [[0, 1, 2, 3]]).save(path, V)
    mesh = load_mesh(path)
    assert np.asarray(mesh.polygons).tolist() == [[0, 1, 2, 3]]


@pytest.mark.parametrize("suffix", [".obj", ".off", ".ply", ".stl", ".glb"])
def test_reading_and_saving_tell_how_far_they_are(tmp_path: Path, suffix: str) -> None:
    V = np.random.default_rng(0).normal(size=(30_000, 3))
    i = np.arange(len(V) - 2)
    Mesh.from_arrays(V, np.stack([i, i + 1, i + 2], axis=1)).save(tmp_path / f"a{suffix}", V)
    for task in ("load", "save"):
        told: list[float] = []
        mesh = load_mesh(tmp_path / f"a{suffix}", progress=told.append if task == "load" else None)
        if task == "save":
            mesh.save(tmp_path / f"b{suffix}", mesh.vertices + 1, progress=told.append)
        assert told == sorted(told)
        assert told[-1] == 1
        assert all(0 < fraction <= 1 for fraction in told)
        assert len(told) <= 12


@pytest.mark.parametrize("suffix", [".obj", ".off", ".ply"])
def test_who_is_told_may_stop_it(tmp_path: Path, suffix: str) -> None:
    V = np.random.default_rng(0).normal(size=(30_000, 3))
    i = np.arange(len(V) - 2)
    path = tmp_path / f"a{suffix}"
    Mesh.from_arrays(V, np.stack([i, i + 1, i + 2], axis=1)).save(path, V)
    before = path.read_bytes()

    def stop(fraction: float) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        load_mesh(path, progress=stop)
    with pytest.raises(KeyboardInterrupt):
        load_mesh(path).save(path, V + 1, progress=stop)
    assert path.read_bytes() == before
    assert len(list(tmp_path.iterdir())) == 1
