"""The command `learn`: softness from posed meshes, into a session."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from app.__main__ import main
from app.editor.files.actions import load_document
from solver import Deformer, Mesh, learn_softness, load_mesh
from solver.geometry.motions import motion, moved, rotation
from tests.app.command import FIXED, HANDLE, run, session, write_bar


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The working directory, with bar.obj, bar.json and the bar bent twice."""
    monkeypatch.chdir(tmp_path)
    write_bar()
    mesh = load_mesh("bar.obj")
    V = mesh.vertices
    soft = np.clip(1 - np.abs(V[:, 0] - V[:, 0].mean()) / 3, 0, 1)
    deformer = Deformer(V, mesh.faces, FIXED, [HANDLE], soft)
    for name, degrees in (("up", 40), ("down", -60)):
        T = motion(rotation([0, 1, 0], degrees), centre=V.mean(axis=0))
        away = motion(rotation([1, 1, 0], 70), [5.0, 0.0, 9.0])
        mesh.save(f"{name}.obj", 3 * moved(away, deformer.pose([T], 6)))
    return tmp_path


def test_a_session_gains_softness_and_keeps_the_rest() -> None:
    session(material="clay", settings={"rigid": 2})
    words = ["learn", "bar.obj", "up.obj", "down.obj", "--session", "bar.json", "-o", "soft.json"]
    assert main(words) == 0
    before, after = (json.loads(Path(name).read_text()) for name in ("bar.json", "soft.json"))
    assert after["fixed"] == before["fixed"]
    for handle in after["handles"]:
        handle.pop("turn")  # found of the transform, which the session had alone
    assert after["handles"] == before["handles"]
    assert after["material"] == "clay"
    assert after["settings"]["rigid"] == 2
    mesh = load_mesh("bar.obj")
    poses = [load_mesh(f"{name}.obj").vertices for name in ("up", "down")]
    wanted = learn_softness(mesh.vertices, mesh.faces, poses, FIXED, [HANDLE], "clay")
    np.testing.assert_array_equal(after["softness"], wanted)
    assert max(after["softness"]) > 0.5


def test_without_a_session_what_moves_rigidly_stands_in() -> None:
    mesh = load_mesh("bar.obj")
    V, x = mesh.vertices, mesh.vertices[:, 0]
    soft = np.clip(1 - np.abs(x - 10) / 3, 0, 1)
    ends = np.flatnonzero(x < 7), [np.flatnonzero(x > 13)]
    T = motion(rotation([0, 0, 1], 50), centre=[10.0, 2.0, 0.0])
    mesh.save("bent.obj", Deformer(V, mesh.faces, *ends, soft).pose([T], 6))
    assert main(["learn", "bar.obj", "bent.obj", "-o", "soft.json"]) == 0
    document = load_document(None, Path("soft.json"))
    assert len(document.fixed) == 0
    assert abs(x[document.softness.argmax()] - 10) < 3


def test_nothing_is_printed_where_nobody_watches() -> None:
    done = run("learn", "bar.obj", "up.obj", "--session", "bar.json", "-o", "soft.json")
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")


@pytest.mark.parametrize(
    ("posed", "text"),
    [
        ("none.obj", "none.obj: cannot be read"),
        ("other.obj", "other.obj: 3 vertices, expected 210, as bar.obj has"),
        ("turned.obj", "turned.obj: its faces are not those of bar.obj"),
        ("bar.obj", "pose 0 shows no motion"),
    ],
)
def test_other_meshes_are_refused(
    posed: str, text: str, capsys: pytest.CaptureFixture[str]
) -> None:
    triangle = Mesh.from_arrays(np.eye(3), [[0, 1, 2]])
    triangle.save("other.obj", triangle.vertices)
    mesh = load_mesh("bar.obj")
    turned = Mesh.from_arrays(mesh.vertices, mesh.faces[:, ::-1])
    turned.save("turned.obj", turned.vertices)
    assert main(["learn", "bar.obj", posed, "--session", "bar.json", "-o", "soft.json"]) == 2
    output = capsys.readouterr()
    assert text in output.err
    assert output.err.count("\n") == 1
    assert not Path("soft.json").exists()


def test_no_file_is_replaced_that_nobody_agreed_to_replace(
    capsys: pytest.CaptureFixture[str],
) -> None:
    words = ["learn", "bar.obj", "up.obj", "--session", "bar.json", "-o"]
    Path("soft.json").write_text('{"mine": 1}')
    Path("other.json").write_bytes(Path("bar.json").read_bytes())
    there = {path: path.read_bytes() for path in Path.cwd().iterdir()}
    refused = ["bar.json"], ["bar.json", "--force"], ["up.obj", "--force"], ["other.json"]
    for output in (*refused, ["soft.json"], ["soft.json", "--force"]):
        assert main([*words, *output]) == 2
        assert "expected another name" in capsys.readouterr().err
    assert {path: path.read_bytes() for path in Path.cwd().iterdir()} == there
    assert main([*words, "other.json", "--force"]) == 0
    assert "softness" in json.loads(Path("other.json").read_text())
