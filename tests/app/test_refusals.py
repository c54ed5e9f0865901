"""Bad input on the command line: exit code 2 and one line that says what and where."""

from __future__ import annotations

import re
import sys
from pathlib import Path
from typing import Any

import pytest

from tests.app.command import HANDLE, WITHOUT_GRAPHICS, refused, run, session, write, write_bar


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The working directory, with bar.obj and bar.json."""
    monkeypatch.chdir(tmp_path)
    write_bar()
    return tmp_path


TRIANGLE = "v 0 0 0\nv 1 0 0\nv 0 1 0\n"
BAD_MESHES = {
    "empty": ("m.obj", "", "m.obj: .*empty"),
    "binary": ("m.obj", bytes(range(256)) * 8, "m.obj.*expected"),
    "not a mesh": ("m.obj", "Dear Sir or Madam,\nhello\n", "m.obj: no vertices, expected"),
    "format": ("m.fbx", "x", r"m.fbx.*\.obj, \.off, \.ply"),
    "cut face": ("m.obj", TRIANGLE + "f 1 2", "m.obj, line 4: .*three corners"),
    "cut vertex": ("m.obj", "v 0 0 0\nv 1 0\nf 1 2 1", "m.obj, line 2: "),
    "cut ply": ("m.ply", "ply\nformat ascii 1.0\nelement vert", "m.ply.*expected"),
    "cut stl": ("m.stl", b"\0" * 80 + b"\x05\0\0\0" + b"\0" * 60, "m.stl.*expected"),
    "cut off": ("m.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n", "m.off.*expected"),
    "face beyond": ("m.obj", TRIANGLE + "f 1 2 4\n", "m.obj, line 4: .* vertex 4, .* has 3"),
    "face zero": ("m.obj", TRIANGLE + "f 0 1 2\n", "m.obj, line 4: .* vertex 0"),
    "nan": ("m.obj", "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3", "m.obj, line 2: .*finite"),
    "infinite": ("m.obj", "v 0 0 0\nv 1 0 inf\nv 0 1 0\nf 1 2 3", "m.obj, line 2: .*finite"),
    "no faces": ("m.obj", TRIANGLE, "m.obj: no faces, expected"),
}


@pytest.mark.parametrize(("name", "data", "expected"), BAD_MESHES.values(), ids=list(BAD_MESHES))
def test_a_bad_mesh_is_one_line(
    name: str, data: str | bytes, expected: str, capsys: pytest.CaptureFixture[str]
) -> None:
    write(name, data)
    assert re.search(expected, refused(capsys, "info", name))
    deform = ("deform", name, "--session", "bar.json", "-o", "out.obj")
    assert re.search(expected, refused(capsys, *deform))
    assert not Path("out.obj").exists()


BAD_SESSIONS = {
    "vertices": ({"mesh": {"path": "bar.obj", "vertices": 9}}, "mesh.vertices: expected 210, .* 9"),
    "faces": ({"mesh": {"path": "bar.obj", "faces": 9}}, "mesh.faces: expected .* got 9"),
    "range": ({"fixed": [0, 210]}, r"fixed\[1\]: expected 0 to 209, got 210"),
    "negative": ({"fixed": [-1]}, r"fixed\[0\]: expected an integer, 0 or more, got -1"),
    "role twice": ({"fixed": HANDLE[:1]}, r"handles\[0\].vertices\[0\]: expected one role"),
    "vertex twice": ({"fixed": [3, 3]}, r"fixed\[1\]: expected each vertex once"),
    "type": ({"fixed": "all"}, 'fixed: expected a list, got "all"'),
    "transform": (
        {"handles": [{"transform": [1, 2]}]},
        r"handles\[0\].transform: expected 4x4 numbers",
    ),
    "softness": ({"softness": [0.5]}, "softness: expected 210 numbers"),
    "share": ({"softness": [1.5] * 210}, r"softness\[0\]: expected a number from 0 to 1, got 1.5"),
    "material": ({"material": "jelly"}, 'material: expected one of .*hinge.* got "jelly"'),
    "rigid": (
        {"settings": {"rigid": -1}},
        "settings.rigid: expected an integer from 0 to 1000",
    ),
    "unknown key": ({"colour": "red"}, "colour: unknown key, expected one of format"),
    "unknown setting": ({"settings": {"speed": 1}}, "settings.speed: unknown key"),
    "version": ({"version": 2}, "version: expected 1, got 2"),
}


@pytest.mark.parametrize(("changes", "expected"), BAD_SESSIONS.values(), ids=list(BAD_SESSIONS))
def test_a_bad_session_is_one_line(
    changes: dict[str, Any], expected: str, capsys: pytest.CaptureFixture[str]
) -> None:
    session(**changes)
    line = refused(capsys, "deform", "bar.obj", "--session", "bar.json", "-o", "out.obj")
    assert re.search(f"bar.json: {expected}", line)
    assert not Path("out.obj").exists()


@pytest.mark.parametrize(
    ("data", "expected"),
    [
        ("", "line 1, column 1: expected JSON"),
        ('{"format": "surface-', "line 1, column 12: expected JSON"),
        (b"\xff\xfe\x00", "expected UTF-8 text"),
        ("[1, 2]", "expected an object"),
        ("{}", "format: missing"),
    ],
)
def test_what_is_no_session_is_one_line(
    data: str | bytes, expected: str, capsys: pytest.CaptureFixture[str]
) -> None:
    write("bar.json", data)
    line = refused(capsys, "deform", "bar.obj", "--session", "bar.json", "-o", "out.obj")
    assert f"bar.json: {expected}" in line or f"bar.json: the file: {expected}" in line


NOT_THERE = "cannot be read"
DEFORM = ("deform", "bar.obj", "--session", "bar.json")


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        (("info", "nowhere.obj"), f"nowhere.obj: {NOT_THERE}"),
        (("info", "."), r"\.: unknown mesh format '', expected \.obj"),
        (("deform", "nowhere.obj", "--session", "bar.json", "-o", "o.obj"), NOT_THERE),
        (("deform", "bar.obj", "--session", "no.json", "-o", "o.obj"), f"no.json: {NOT_THERE}"),
        ((*DEFORM, "-o", "nowhere/out.obj"), "nowhere/out.obj: .* folder .*nowhere does not exist"),
        ((*DEFORM, "-o", "bar.json/out.obj"), "out.obj: cannot be written"),
        ((*DEFORM, "-o", "."), "expected|cannot be written"),
        ((*DEFORM, "-o", "out.fbx"), r"out.fbx.*\.obj"),
        (
            (*DEFORM, "-o", "out.obj", "--rigid", "two"),
            "--rigid.* from 0 to 1000, got 'two'",
        ),
        ((*DEFORM, "-o", "out.obj", "--rigid", "-1"), "--rigid"),
        ((*DEFORM, "-o", "out.obj", "--rigid", "1001"), "--rigid.* from 0 to 1000, got '1001'"),
        ((*DEFORM, "-o", "out.obj", "--rigid", "9" * 5000), "--rigid.* from 0 to 1000, got '99"),
        ((*DEFORM, "-o", "out.obj", "--fast"), "unrecognized arguments: --fast"),
        (("deform",), "required: MESH, --session, -o"),
        (DEFORM, "required: -o"),
        (("deform", "bar.json", "-o", "o.obj"), "bar.json is a session, expected MESH --session"),
        (("deform", "bar.obj", "-o", "o.obj"), "required: --session"),
        (("bar.obj", "bar.json"), "bar.json on bar.obj needs --session before it"),
        (("info",), "required: MESH"),
        (("info", "bar.obj", "bar.obj"), "unrecognized arguments"),
        (("demo",), "required: -o"),
        (("figures",), "required: -o"),
        (("demo", "-o", "nowhere/demo"), "nowhere/demo: no folder can be made there"),
        (("figures", "-o", "bar.obj"), "bar.obj: no folder can be made there"),
        (("--nonsense",), "unrecognized arguments: --nonsense"),
        (("bar.obj", "bar.obj"), "unrecognized arguments"),
        (("--session",), "--session: expected one argument"),
        (
            ("bar.json", "--session", "a.json"),
            "bar.json and a.json are two sessions, expected a mesh",
        ),
    ],
)
def test_a_wrong_command_is_one_line(
    words: tuple[str, ...], expected: str, capsys: pytest.CaptureFixture[str]
) -> None:
    before = sorted(Path().iterdir())
    assert re.search(expected, refused(capsys, *words))
    assert sorted(Path().iterdir()) == before, "nothing is left behind"


@pytest.mark.skipif(not Path("/proc/self").exists(), reason="no folder that refuses every user")
def test_a_folder_that_cannot_be_written_is_one_line(capsys: pytest.CaptureFixture[str]) -> None:
    assert "/proc/out.obj: cannot be written" in refused(capsys, *DEFORM, "-o", "/proc/out.obj")
    assert "no folder can be made" in refused(capsys, "demo", "-o", "/proc/demo")


@pytest.mark.skipif(sys.platform != "linux", reason="other systems have a display without a name")
@pytest.mark.parametrize("code", ["", WITHOUT_GRAPHICS], ids=["display", "library"])
def test_a_window_that_cannot_open_is_one_line(code: str) -> None:
    done = run("bar.obj", code=code)
    assert (done.returncode, done.stdout) == (2, "")
    assert re.fullmatch(
        r"python -m app: nothing can be drawn on this machine [^\n]*\n", done.stderr
    )


def test_a_process_ends_with_the_code_and_the_line() -> None:
    write("m.obj", TRIANGLE + "f 1 2 4\n")
    done = run("info", "m.obj")
    assert (done.returncode, done.stdout) == (2, "")
    assert re.fullmatch(r"python -m app: m.obj, line 4: [^\n]*\n", done.stderr)
    done = run("deform")
    assert done.returncode == 2
    assert done.stderr.count("\n") == 1
