"""The command line: what its commands do, and what they need."""

from __future__ import annotations

import re
import sys
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from app.__main__ import main
from app.bundled import DEFAULT_SESSION
from solver import Deformer, Material, load_mesh
from tests.app.command import (
    FIXED,
    HANDLE,
    WITHOUT_GRAPHICS,
    run,
    session,
    turn,
    write,
    write_bar,
)


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The working directory, with bar.obj and bar.json."""
    monkeypatch.chdir(tmp_path)
    write_bar()
    return tmp_path


@pytest.mark.parametrize("rigid", [None, "0", "2"])
def test_deform_does_what_the_interface_in_python_does(rigid: str | None) -> None:
    softness = np.linspace(0, 1, len(load_mesh("bar.obj").vertices))
    session(
        softness=softness.tolist(),
        material={"bending": 0.3, "stretching": 0.6},
        settings={"bending_length": 0.05, "orientation": False, "rigid": 1},
    )
    level = [] if rigid is None else ["--rigid", rigid]
    assert main(["deform", "bar.obj", "--session", "bar.json", "-o", "out.obj", *level]) == 0
    mesh = load_mesh("bar.obj")
    deformer = Deformer(
        mesh.vertices,
        mesh.faces,
        fixed=FIXED,
        handles=[HANDLE],
        softness=softness,
        material=Material(bending=0.3, stretching=0.6),
        bending_length=0.05,
        orientation=False,
    )
    X = deformer.pose([turn()], rigid=int(rigid or 1))
    np.testing.assert_allclose(load_mesh("out.obj").vertices, X, rtol=0, atol=1e-8)


def test_deform_keeps_what_is_fixed_and_moves_what_is_held() -> None:
    assert main(["deform", "bar.obj", "--session", "bar.json", "-o", "out.ply"]) == 0
    X, rest = load_mesh("out.ply").vertices, load_mesh("bar.obj").vertices
    np.testing.assert_array_equal(X[FIXED], rest[FIXED])
    T = turn()
    expected = rest[HANDLE] @ T[:3, :3].T + T[:3, 3]
    np.testing.assert_allclose(X[HANDLE], expected, rtol=0, atol=1e-9)


def test_what_the_output_does_not_keep_is_one_line(capsys: pytest.CaptureFixture[str]) -> None:
    """Nothing is wrong: the exit code is 0."""
    deform = ["deform", "bar.obj", "--session", "bar.json", "-o"]
    assert main([*deform, "out.ply"]) == 0
    assert capsys.readouterr() == ("", "")
    write("bar.obj", Path("bar.obj").read_text() + "vt 0 0\nl 1 2\n")
    assert main([*deform, "out.obj"]) == 0
    assert capsys.readouterr() == ("", "")
    assert main([*deform, "out.stl"]) == 0
    told = capsys.readouterr()
    assert told == ("", "saved out.stl; STL keeps no texture coordinates, lines\n")


def test_a_session_without_a_handle_deforms_nothing() -> None:
    session(handles=[])
    assert main(["deform", "bar.obj", "--session", "bar.json", "-o", "out.obj"]) == 0
    assert Path("out.obj").read_bytes() == Path("bar.obj").read_bytes()


def test_the_commands_without_a_window_need_no_graphics(folder: Path) -> None:
    """And the paths on the command line win over the one in the session."""
    (folder / "sessions").mkdir()
    session("sessions/bar.json", mesh={"path": "../bar.obj"})
    words = ["deform", "bar.obj", "--session", "sessions/bar.json", "-o", "out.obj"]
    for code in ("", WITHOUT_GRAPHICS):
        done = run(*words, code=code)
        assert (done.returncode, done.stderr) == (0, "")
        assert (folder / "out.obj").exists()
        (folder / "out.obj").unlink()
        done = run("info", "bar.obj", code=code)
        assert (done.returncode, done.stderr) == (0, "")
        assert "vertices" in done.stdout


MESSY = """\
v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 0
v 9 9 9
v 5 0 0\nv 6 0 0\nv 5 1 0\nv 6 1 0
f 1 2 3\nf 1 2 4\nf 1 2 5
f 1 2 3
f 7 7 10
f 7 8 9\nf 8 10 9
"""


def test_an_odd_mesh_is_counted_and_deformed(capsys: pytest.CaptureFixture[str]) -> None:
    write("odd.obj", MESSY)
    assert main(["info", "odd.obj"]) == 0
    lines = capsys.readouterr().out.splitlines()
    # Names and values stand in two columns.
    counts = dict(re.split(r"\s{2,}", line.strip(), maxsplit=1) for line in lines[1:])
    assert counts["vertices"] == "10"
    assert counts["faces"] == "7 triangles"
    assert counts["components"] == "2"
    assert counts["pieces, seams welded"] == "2"
    assert counts["non-manifold edges"] == "1"
    assert counts["degenerate triangles"] == "1"
    assert counts["duplicate faces"] == "1"
    assert counts["isolated vertices"] == "1"
    handle = {"vertices": [1, 2], "transform": turn().tolist()}
    session("odd.json", mesh={"path": "odd.obj"}, fixed=[0], handles=[handle])
    assert main(["deform", "odd.obj", "--session", "odd.json", "-o", "out.obj"]) == 0
    assert np.isfinite(load_mesh("out.obj").vertices).all()


def test_help_is_no_error(capsys: pytest.CaptureFixture[str]) -> None:
    for words in (
        ["--help"],
        *([name, "--help"] for name in ("deform", "learn", "info", "demo", "figures")),
    ):
        with pytest.raises(SystemExit) as end:
            main(words)
        assert end.value.code == 0
        assert capsys.readouterr().out.startswith("usage: python -m app")


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        ([], (None, DEFAULT_SESSION, None)),
        (["bar.obj"], (Path("bar.obj"), None, None)),
        (["bar.JSON"], (None, Path("bar.JSON"), None)),
        (["--session", "bar.json"], (None, Path("bar.json"), None)),
        (["a.obj", "--session", "bar.json"], (Path("a.obj"), Path("bar.json"), None)),
        (["bar.json", "--export", "a.obj"], (None, Path("bar.json"), Path("a.obj"))),
    ],
)
def test_a_window_opens_a_mesh_or_a_session(
    words: list[str], expected: tuple[object, ...], monkeypatch: pytest.MonkeyPatch
) -> None:
    opened: list[tuple[object, ...]] = []
    window = SimpleNamespace(run_window=lambda *arguments: opened.append(arguments))
    monkeypatch.setitem(sys.modules, "app.window.main", window)
    assert main(words) == 0
    assert opened == [expected]


@pytest.mark.parametrize("exact", [False, True])
def test_frames_on_a_coarse_mesh_are_what_a_session_says_unless_exact(exact: bool) -> None:
    session(settings={"coarse": 60, "rigid": 1})
    words = ["--exact"] if exact else []
    assert main(["deform", "bar.obj", "--session", "bar.json", "-o", "out.obj", *words]) == 0
    mesh = load_mesh("bar.obj")
    coarse = None if exact else 60
    deformer = Deformer(mesh.vertices, mesh.faces, FIXED, [HANDLE], coarse=coarse)
    expected = deformer.pose([turn()], rigid=1)
    np.testing.assert_allclose(load_mesh("out.obj").vertices, expected, atol=1e-9)
