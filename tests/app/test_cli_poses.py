"""`deform` with kept poses: one in place of the current, or all of them."""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np
import pytest

from app.__main__ import main
from solver import Deformer, load_mesh
from solver.geometry.motions import motion, rotation
from solver.types import FloatArray
from tests.app.command import FIXED, HANDLE, refused, session, turn, write_bar

FIST = motion(rotation([0, 1, 0], 40), [1.0, 0, 3])
OPEN = motion(rotation([1, 0, 0], 60), [2.0, 0, 0])
DEFORM = ("deform", "bar.obj", "--session", "bar.json", "-o")


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The working directory, with bar.obj and bar.json, which keeps two poses."""
    monkeypatch.chdir(tmp_path)
    write_bar()
    poses = (("fist", FIST), ("open hand", OPEN))
    session(poses=[{"name": n, "transforms": {"end": T.tolist()}} for n, T in poses])
    return tmp_path


def solved(T: FloatArray, rigid: int = 1) -> FloatArray:
    mesh = load_mesh("bar.obj")
    return Deformer(mesh.vertices, mesh.faces, FIXED, [HANDLE]).pose([T], rigid=rigid)


def test_a_kept_pose_takes_the_place_of_the_current_one() -> None:
    assert main([*DEFORM, "out.obj", "--pose", "open hand", "--rigid", "2"]) == 0
    np.testing.assert_allclose(load_mesh("out.obj").vertices, solved(OPEN, 2), atol=1e-8)
    assert sorted(p.name for p in Path().iterdir()) == ["bar.json", "bar.obj", "out.obj"]


def test_all_poses_are_files_beside_the_mesh_as_it_is_posed() -> None:
    assert main([*DEFORM, "out.obj", "--poses"]) == 0
    for name, T in (("out", turn()), ("out-fist", FIST), ("out-open_hand", OPEN)):
        X = load_mesh(f"{name}.obj").vertices
        np.testing.assert_allclose(X, solved(T), atol=1e-8, err_msg=name)
    assert len(list(Path().iterdir())) == 5


def test_all_poses_are_morph_targets_of_a_glb() -> None:
    assert main([*DEFORM, "out.gltf", "--poses", "--pose", "fist"]) == 0
    out = json.loads(Path("out.gltf").read_text())
    assert out["meshes"][0]["extras"]["targetNames"] == ["fist", "open hand"]
    size = 1e-6 * np.ptp(load_mesh("bar.obj").vertices)
    np.testing.assert_allclose(load_mesh("out.gltf").vertices, solved(FIST), atol=size)
    fist, opened = (targets(out, number) for number in (0, 1))
    np.testing.assert_array_equal(fist, np.zeros_like(fist))
    X = np.abs(solved(OPEN) - solved(FIST)).max(axis=0)
    np.testing.assert_allclose(np.abs(opened).max(axis=0), X, atol=size)


def targets(out: dict, number: int) -> FloatArray:  # type: ignore[type-arg]
    """(2, 3) the bounds of a target's positions, which every accessor of positions states."""
    place = out["meshes"][0]["primitives"][0]["targets"][number]["POSITION"]
    accessor = out["accessors"][place]
    return np.array([accessor["min"], accessor["max"]])


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        (("--pose", "grip"), "unknown pose 'grip', expected one of 'fist', 'open hand'"),
        (("--pose", ""), "unknown pose ''"),
        (("--pose",), "--pose: expected one argument"),
    ],
)
def test_a_wrong_pose_is_one_line(
    words: tuple[str, ...], expected: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert expected in refused(capsys, *DEFORM, "out.obj", *words)
    assert not Path("out.obj").exists()


@pytest.mark.parametrize("words", [("--pose", "fist"), ("--poses",)])
def test_a_session_without_poses_has_none_to_save(
    words: tuple[str, ...], capsys: pytest.CaptureFixture[str]
) -> None:
    session()
    assert re.search("no(ne| pose) is kept", refused(capsys, *DEFORM, "out.obj", *words))
    assert not Path("out.obj").exists()


def test_a_file_that_nobody_named_is_not_replaced(capsys: pytest.CaptureFixture[str]) -> None:
    Path("out-fist.obj").write_text("mine")
    assert "out-fist.obj is there already" in refused(capsys, *DEFORM, "out.obj", "--poses")
    assert Path("out-fist.obj").read_text() == "mine"
    assert not Path("out.obj").exists()
    assert main([*DEFORM, "out.glb", "--poses"]) == 0  # where no file is beside it


def test_poses_whose_files_would_be_one_are_refused(capsys: pytest.CaptureFixture[str]) -> None:
    for names in (("a b", "a_b"), ("fist", "FIST")):
        session(poses=[{"name": name, "transforms": {}} for name in names])
        line = refused(capsys, *DEFORM, "out.obj", "--poses")
        assert "two poses would be saved there" in line
        assert not list(Path().glob("out*"))
