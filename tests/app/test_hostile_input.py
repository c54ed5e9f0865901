"""Input that is extreme or made to harm: exit code 2 and one line, without delay."""

from __future__ import annotations

import json
import os
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from solver.geometry.motions import motion
from tests.app.command import HANDLE, refused, session, write, write_bar

DEFORM = ("deform", "bar.obj", "--session", "bar.json", "-o", "out.obj")


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The working directory, with bar.obj and bar.json."""
    monkeypatch.chdir(tmp_path)
    write_bar()
    return tmp_path


def at(T: Any) -> dict[str, Any]:
    """A handle with a transform."""
    return {"name": "end", "vertices": HANDLE, "transform": np.asarray(T).tolist()}


FAR, WIDE = motion(np.eye(3), [1e308, 0, 0]), np.diag([1e20, 1, 1, 1])
BEYOND = "must move the surface by at most 5000 of its diagonals, got 4.88e"
STRETCH = "expected a linear part of entries up to 1000, got 1e\\+20"
EXTREME: dict[str, tuple[dict[str, Any], str]] = {
    "shift": ({"handles": [at(FAR)]}, rf"handles\[0\].transform {BEYOND}"),
    "stretch": ({"handles": [at(WIDE)]}, rf"handles\[0\].transform: {STRETCH}"),
    "pin": ({"handles": [], "pins": [at(FAR)]}, rf"pins\[0\].transform {BEYOND}"),
    "kept pose": (
        {"poses": [{"name": "a", "transforms": {"end": FAR.tolist()}}]},
        rf"poses\[0\].transforms.end {BEYOND}",
    ),
    "kept stretch": (
        {"poses": [{"name": "a", "transforms": {"end": WIDE.tolist()}}]},
        rf"poses\[0\].transforms.end: {STRETCH}",
    ),
    "rounds": (
        {"settings": {"rigid": 2**64}},
        "settings.rigid: expected an integer from 0 to 1000",
    ),
    "long bend": (
        {"settings": {"bending_length": 1e300}},
        r"settings.bending_length: expected a number from 1e-12 to 1000, got 1e\+300",
    ),
    "no bend": ({"settings": {"bending_length": 1e-320}}, "settings.bending_length: expected"),
    "gain": (
        {"material": {"bending": 1e308, "stretching": 1}},
        r"material.bending: expected a number from 1e-06 to 1e\+06, got 1e\+308",
    ),
    "gains too far apart": (
        {"material": {"bending": 1e-6, "stretching": 1e6}, "softness": [1.0] * 210},
        "^python -m app: the surface is solved to .* of its diagonal only, expected 0.0001",
    ),
    "handles": ({"handles": [{}] * 2001}, "handles: expected at most 2000 entries, got 2001"),
    "poses": (
        {"poses": [{"name": "a", "transforms": {}}] * 10001},
        "poses: expected at most 10000 entries, got 10001",
    ),
    "a long name": (
        {"handles": [{"name": "x" * 5000}]},
        r"handles\[0\].name: expected a text that is not empty, of at most 4096 characters",
    ),
    "a long key": ({"k" * 10**6: 1}, r"bar.json: k{50}\.\.\.: unknown key"),
    "a large count": ({"fixed": [10**4000]}, r"fixed\[0\]: expected an integer, 0 or more, got 1"),
    "rest in a point": (
        {"rest": [[1, 2, 3]] * 210},
        "rest: all faces lie in one point, expected a size of 1e-18 or more",
    ),
    "rest beyond": (
        {"rest": [[1e160, 0, 0]] * 210},
        r"rest, vertex 0: expected coordinates up to 1e\+18, got \[1e\+160",
    ),
}


@pytest.mark.parametrize(("changes", "expected"), EXTREME.values(), ids=list(EXTREME))
def test_an_extreme_number_in_a_session_is_one_line(
    changes: dict[str, Any], expected: str, capsys: pytest.CaptureFixture[str]
) -> None:
    session(**changes)
    line = refused(capsys, *DEFORM)
    assert re.search(expected, line), line
    assert len(line) < 400
    assert not Path("out.obj").exists()


@pytest.mark.parametrize("T", [np.diag([-1, 1, 1, 1]), np.diag([0, 1, 1, 1]), 900 * np.eye(4)])
def test_a_handle_may_mirror_flatten_and_stretch(T: Any) -> None:
    from app.__main__ import main

    session(handles=[at(np.vstack([T[:3], [0, 0, 0, 1]]))])
    assert main(DEFORM) == 0


SESSION = '"format": "surface-deformation-session", "version": 1, "mesh": {"path": "bar.obj"}'
BOMBS = {
    "equal keys": ("{" + ", ".join(['"fixed": []'] * 60_000) + "}", "fixed: expected once"),
    "distinct keys and one twice": (
        "{" + ", ".join([*(f'"k{i}": 1' for i in range(60_000)), '"k59999": 1']) + "}",
        "k59999: expected once, got it twice",
    ),
    "nested lists": ("[" * 1000 + "]" * 1000, "expected a session, got lists nested too deeply"),
    "nested below the limit": (
        "{" + SESSION + ', "fixed": [' + "[" * 700 + "]" * 700 + "]}",
        "expected a session, got lists nested too deeply",
    ),
    "nested a little": (
        "{" + SESSION + ', "fixed": [' + "[" * 90 + "]" * 90 + "]}",
        r"fixed\[0\]: expected an integer",
    ),
    "nested objects": ('{"a":' * 5000 + "1" + "}" * 5000, "expected a session, got lists nested"),
    "digits": ('{"version": ' + "9" * 5000 + "}", "expected numbers of a usual size"),
}


@pytest.mark.parametrize(("text", "expected"), BOMBS.values(), ids=list(BOMBS))
def test_a_session_made_to_harm_is_one_line(
    text: str, expected: str, capsys: pytest.CaptureFixture[str]
) -> None:
    write("bar.json", text)
    assert re.search(f"bar.json: {expected}", refused(capsys, *DEFORM))


CORNERS = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0.2]])
SIZES = {
    "beyond": (
        1e160 * CORNERS,
        r"m.obj, vertex 1: expected coordinates up to 1e\+18, got \[1e\+160",
    ),
    "tiny": (1e-200 * CORNERS, "m.obj: the surface is 1e-200 large, expected a size of 1e-18"),
    "collapsed": (0 * CORNERS + 3, "m.obj: all faces lie in one point, expected a size of"),
}


@pytest.mark.parametrize(("V", "expected"), SIZES.values(), ids=list(SIZES))
def test_a_mesh_beyond_the_arithmetic_is_one_line(
    V: Any, expected: str, capsys: pytest.CaptureFixture[str]
) -> None:
    lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in V.tolist()]
    write("m.obj", "\n".join([*lines, "f 1 2 3", "f 2 4 3"]))
    assert re.search(expected, refused(capsys, "info", "m.obj"))
    session(mesh={"path": "m.obj"}, fixed=[0], handles=[{"vertices": [3]}])
    deform = ("deform", "m.obj", "--session", "bar.json", "-o", "out.obj")
    assert re.search(expected, refused(capsys, *deform))


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="pipes have no names here")
def test_a_pipe_or_a_device_is_no_file(capsys: pytest.CaptureFixture[str]) -> None:
    os.mkfifo("pipe.obj")
    Path("zero.obj").symlink_to("/dev/zero")
    for name in ("pipe.obj", "zero.obj"):
        line = refused(capsys, "info", name)
        assert f"{name}: is a pipe or a device, expected a file" in line
    os.mkfifo("pipe.json")
    line = refused(capsys, "deform", "bar.obj", "--session", "pipe.json", "-o", "out.obj")
    assert "pipe.json: is a pipe or a device, expected a file" in line


def test_a_folder_is_no_file(capsys: pytest.CaptureFixture[str]) -> None:
    Path("folder.obj").mkdir()
    assert "folder.obj: is a folder, expected a file" in refused(capsys, "info", "folder.obj")


SIGNALLING = np.array([0x7FA00000, 0, 0], dtype="<u4").tobytes()
POINTS = SIGNALLING + np.array([[1, 0, 0], [0, 1, 0]], dtype="<f4").tobytes()
PLY = b"""ply
format binary_little_endian 1.0
element vertex %d
property float x
property float y
property float z
element face %d
property list uchar int vertex_indices
end_header
"""
FACE = b"\3" + np.arange(3, dtype="<i4").tobytes()
GLTF = {"asset": {"version": "2.0"}, "nodes": [{"mesh": 0}]}
PRIMITIVES = [{"primitives": [{"attributes": {"POSITION": 0}}]}]
ACCESSOR = {"componentType": 5126, "type": "VEC3"}


def gltf(**changes: Any) -> bytes:
    return json.dumps({**GLTF, "meshes": PRIMITIVES, **changes}).encode()


FILES = {
    "signalling PLY": ("m.ply", PLY % (3, 1) + POINTS + FACE, "vertex 0: expected finite"),
    "signalling STL": (
        "m.stl",
        bytes(80) + np.uint32(1).tobytes() + bytes(12) + POINTS + bytes(2),
        "triangle 1: expected finite",
    ),
    "PLY vertices": (
        "m.ply",
        PLY % (10**12, 1) + POINTS + FACE,
        "ends early .* 1000000000000 rows",
    ),
    "PLY faces": ("m.ply", PLY % (3, 10**30) + bytes(36) + FACE, "ends early .* rows of 'face'"),
    "PLY text": (
        "m.ply",
        (PLY % (10**30, 1)).replace(b"binary_little_endian", b"ascii") + b"0 0 0\n1 0 0\n",
        "ends early",
    ),
    "STL": ("m.stl", bytes(80) + b"\xff\xff\xff\xff" + POINTS, "expected 214748364834 or more"),
    "OFF": ("m.off", b"OFF\n1000000000000 1000000000000 0\n0 0 0\n", "ends early, expected 10"),
    "OFF digits": ("m.off", b"OFF\n" + b"9" * 5000 + b" 1 0\n", "expected the numbers of"),
    "glTF elements": (
        "m.gltf",
        gltf(accessors=[{**ACCESSOR, "count": 10**12}]),
        "1000000000000 vertices and indices, expected",
    ),
    "glTF elements without bytes": (
        "m.gltf",
        gltf(accessors=[{**ACCESSOR, "count": 60_000_000}]),
        "60000000 elements without data, expected",
    ),
    "glTF view": (
        "m.gltf",
        gltf(
            accessors=[{**ACCESSOR, "count": 10**6, "bufferView": 0}],
            bufferViews=[{"buffer": 0, "byteLength": 10**15}],
            buffers=[{"byteLength": 10**15}],
        ),
        "buffer 0, which has 0",
    ),
    "glTF device": (
        "m.gltf",
        gltf(
            accessors=[{**ACCESSOR, "count": 3}],
            buffers=[{"byteLength": 3, "uri": "../" * 20 + "dev/zero"}],
        ),
        "there is no file",
    ),
    "glTF nesting": (
        "m.gltf",
        gltf()[:-1] + b', "extras": ' + b"[" * 1000 + b"]" * 1000 + b"}",
        "its JSON .*(nested|recursion)",
    ),
    "glTF nesting below the limit": (
        "m.gltf",
        gltf()[:-1] + b', "extras": ' + b"[" * 500 + b"]" * 500 + b"}",
        "its JSON is nested too deeply",
    ),
}


@pytest.mark.parametrize(("name", "data", "expected"), FILES.values(), ids=list(FILES))
def test_a_mesh_file_made_to_harm_is_one_line(
    name: str,
    data: bytes,
    expected: str,
    capsys: pytest.CaptureFixture[str],
    recwarn: pytest.WarningsRecorder,
) -> None:
    write(name, data)
    line = refused(capsys, "info", name)
    assert re.search(f"{name}.*{expected}", line), line
    assert not list(recwarn)
