from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from app.model.document import Document
from app.model.schema import SessionError
from app.model.session.reading import read_session, to_document
from app.model.session.writing import write_session
from solver import FileError, Material, Mesh
from tests.app.person import slab, state

IDENTITY = np.eye(4).tolist()


def painted(path: Path) -> Document:
    random = np.random.default_rng(0)
    document = Document(slab(6, 3, 1.0), path)
    n = len(document.role)
    document.change("role", random.integers(0, 4, n), np.arange(n))
    transform = np.eye(4)
    transform[:3] = random.normal(size=(3, 4)) / 3
    document.change("handles", (document.new_handle("hand"), document.new_handle("läuft \n'\"")))
    document.change("pose", document.pose.moved(document.handles[1].key, transform))
    document.change("softness", random.random(n), np.arange(n))
    document.change("material", Material(0.1 + 0.2, 1 / 3))
    document.change("bending_length", 0.1 / 3)
    document.change("orientation", False)
    document.change("rigid", 0)
    return document


def without_keys(document: Document) -> tuple[object, ...]:
    role, softness, _, *rest = state(document)
    return role, softness, [handle.name for handle in document.handles], *rest


def write(path: Path, **changes: Any) -> Path:
    """A small session file with some keys changed; ... takes a key out."""
    data: dict[str, Any] = {
        "format": "surface-deformation-session",
        "version": 1,
        "mesh": {"path": "arm.obj", "vertices": 56, "faces": 108},
        "fixed": [0, 1, 2],
        "handles": [{"name": "hand", "vertices": [7, 8], "transform": IDENTITY}],
        **changes,
    }
    path.write_text(json.dumps({k: v for k, v in data.items() if v is not ...}))
    return path


def test_a_session_comes_back_bit_for_bit(tmp_path: Path) -> None:
    document = painted(tmp_path / "meshes" / "arm.obj")
    (tmp_path / "sessions").mkdir()
    path = tmp_path / "sessions" / "arm.json"
    write_session(path, document)
    session = read_session(path)
    assert json.loads(path.read_text())["mesh"]["path"] == "../meshes/arm.obj"
    assert session.mesh_path.resolve() == (tmp_path / "meshes" / "arm.obj").resolve()
    again = to_document(session, document.mesh, session.mesh_path)
    assert without_keys(again) == without_keys(document)


def test_absent_keys_take_the_defaults(tmp_path: Path) -> None:
    mesh = slab(6, 3, 1.0)
    path = write(tmp_path / "a.json", fixed=..., handles=[{"vertices": [3]}], mesh={"path": "m"})
    document = to_document(read_session(path), mesh, tmp_path / "m")
    plain = Document(mesh, tmp_path / "m")
    assert [h.name for h in document.handles] == ["handle 1"]
    np.testing.assert_array_equal(document.pose.of(document.handles[0].key), np.eye(4))
    assert state(document)[4:] == state(plain)[4:]
    assert not document.softness.any()


def test_softness_of_nothing_is_left_out(tmp_path: Path) -> None:
    document = Document(slab(2, 2, 1.0), tmp_path / "arm.obj")
    write_session(tmp_path / "a.json", document)
    assert "softness" not in json.loads((tmp_path / "a.json").read_text())


def test_a_preset_is_written_by_name_and_gains_as_numbers(tmp_path: Path) -> None:
    document = Document(slab(2, 2, 1.0), tmp_path / "arm.obj")
    for material, written in (("clay", "clay"), (Material(2, 3), {"bending": 2, "stretching": 3})):
        document.change("material", material)
        write_session(tmp_path / "a.json", document)
        assert json.loads((tmp_path / "a.json").read_text())["material"] == written


HANDLE = {"name": "hand", "vertices": [7], "transform": IDENTITY}
MESH = {"path": "arm.obj", "vertices": 56, "faces": 108}
REFUSED = [
    ({"format": "something"}, r"^format: expected \"surface-deformation-session\""),
    ({"format": ...}, "^format: missing"),
    ({"version": 2}, "^version: expected 1, got 2"),
    ({"version": True}, "^version: expected 1, got true"),
    ({"mesh": ...}, "^mesh: missing"),
    ({"mesh": "arm.obj"}, "^mesh: expected an object"),
    ({"mesh": {"vertices": 3}}, r"^mesh\.path: missing"),
    ({"mesh": {**MESH, "path": ""}}, r"^mesh\.path: expected a text"),
    ({"mesh": {**MESH, "vertices": 56.0}}, r"^mesh\.vertices: expected an integer"),
    ({"mesh": {**MESH, "edges": 4}}, r"^mesh\.edges: unknown key"),
    ({"color": 1}, "^color: unknown key"),
    ({"two\nlines": 1}, r"^two\\nlines: unknown key"),
    ({"fixed": {"0": 1}}, "^fixed: expected a list"),
    ({"fixed": [0, True]}, r"^fixed\[1\]: expected an integer, 0 or more, got true"),
    ({"fixed": [0, -1]}, r"^fixed\[1\]: expected an integer, 0 or more, got -1"),
    ({"fixed": [0.5]}, r"^fixed\[0\]: expected an integer"),
    ({"handles": {}}, "^handles: expected a list"),
    ({"handles": [3]}, r"^handles\[0\]: expected an object"),
    ({"handles": [{**HANDLE, "name": 4}]}, r"^handles\[0\]\.name: expected a text"),
    ({"handles": [{**HANDLE, "pose": 4}]}, r"^handles\[0\]\.pose: unknown key"),
    ({"handles": [{**HANDLE, "vertices": ["7"]}]}, r"^handles\[0\]\.vertices\[0\]: expected"),
    (
        {"handles": [{**HANDLE, "transform": IDENTITY[:3]}]},
        r"^handles\[0\]\.transform: expected 4x",
    ),
    ({"handles": [{**HANDLE, "transform": [[1, 0], 2, 3, 4]}]}, r"\.transform: expected 4x4 num"),
    (
        {"handles": [{**HANDLE, "transform": [*IDENTITY[:3], [0, 0, 0, True]]}]},
        r"\.transform: expected 4x4 numbers",
    ),
    (
        {"handles": [{**HANDLE, "transform": [*IDENTITY[:3], [0, 0, 1, 1]]}]},
        r"^handles\[0\]\.transform\[3\]: expected the last row 0 0 0 1",
    ),
    ({"handles": [{**HANDLE, "turn": [0, 0]}]}, r"^handles\[0\]\.turn: expected three numbers"),
    (
        {"handles": [{**HANDLE, "turn": [0, 0, "1"]}]},
        r"^handles\[0\]\.turn: expected three numbers",
    ),
    ({"handles": [{**HANDLE, "turn": [0, 0, 10**400]}]}, r"\.turn: expected three numbers"),
    ({"handles": [{**HANDLE, "turn": [0, 1e300, 0]}]}, r"\.turn: expected at most 100 whole turns"),
    ({"handles": [{**HANDLE, "turn": [0, 0, 629]}]}, r"\.turn: expected at most 100 whole turns"),
    ({"softness": 0.5}, "^softness: expected a list"),
    ({"softness": [0.5, 1.5]}, r"^softness\[1\]: expected a number from 0 to 1, got 1\.5"),
    ({"softness": [False]}, r"^softness\[0\]: expected a number"),
    ({"softness": [10**400]}, r"^softness\[0\]: expected a number"),
    ({"material": "steel"}, "^material: expected one of hinge, paper, clay or two gains"),
    ({"material": 3}, "^material: expected one of"),
    ({"material": {"bending": 1}}, r"^material\.stretching: missing"),
    (
        {"material": {"bending": 0, "stretching": 1}},
        r"^material\.bending: expected a number from",
    ),
    ({"material": {"bending": 1, "stretching": 1, "x": 1}}, r"^material\.x: unknown key"),
    ({"settings": []}, "^settings: expected an object"),
    ({"settings": {"speed": 1}}, r"^settings\.speed: unknown key"),
    ({"settings": {"rigid": True}}, r"^settings\.rigid: expected an integer from 0 to 1000"),
    ({"settings": {"rigid": 1.0}}, r"^settings\.rigid: expected an integer"),
    ({"settings": {"orientation": 0}}, r"^settings\.orientation: expected true or false"),
    ({"settings": {"attach": 1}}, r"^settings\.attach: expected true, false or a list"),
    ({"settings": {"attach": [0, 1.5]}}, r"^settings\.attach: expected true, false or a list"),
    (
        {"settings": {"bending_length": -1}},
        r"^settings\.bending_length: expected a number from 1e-12",
    ),
]


def refusal(path: Path, mesh: Mesh | None = None) -> str:
    """What reading (and, with a mesh, fitting) says, without the path it starts with."""

    def read() -> None:
        session = read_session(path)
        if mesh is not None:
            to_document(session, mesh, session.mesh_path)

    with pytest.raises(SessionError) as caught:
        read()
    text = str(caught.value)
    assert "\n" not in text
    assert text.startswith(f"{path}: ")
    return text.removeprefix(f"{path}: ")


@pytest.mark.parametrize(("changes", "text"), REFUSED, ids=[text for _, text in REFUSED])
def test_what_is_wrong_is_refused_by_name(
    tmp_path: Path, changes: dict[str, Any], text: str
) -> None:
    message = refusal(write(tmp_path / "a.json", **changes))
    assert re.search(text, message), message


UNFIT = [
    ({"mesh": {**MESH, "vertices": 55}}, "mesh.vertices: expected 56, as the mesh has, got 55"),
    ({"mesh": {**MESH, "faces": 1}}, "mesh.faces: expected 108, as the mesh has, got 1"),
    ({"fixed": [0, 56]}, "fixed[1]: expected 0 to 55, got 56"),
    ({"fixed": [10**30]}, f"fixed[0]: expected 0 to 55, got {10**30}"),
    ({"fixed": [4, 5, 4]}, "fixed[2]: expected each vertex once, got 4 twice"),
    ({"fixed": [7]}, "handles[0].vertices[0]: expected one role a vertex, got 7, which has"),
    ({"handles": [HANDLE, HANDLE]}, "handles[1].vertices[0]: expected one role a vertex, got 7"),
    ({"softness": [0.5, 0.5]}, "softness: expected 56 numbers, one a vertex, got 2"),
]


@pytest.mark.parametrize(("changes", "text"), UNFIT, ids=[text for _, text in UNFIT])
def test_what_does_not_fit_the_mesh_is_refused_by_name(
    tmp_path: Path, changes: dict[str, Any], text: str
) -> None:
    mesh = slab(6, 3, 1.0)
    assert (len(mesh.vertices), len(mesh.faces)) == (56, 108)
    assert refusal(write(tmp_path / "a.json", **changes), mesh).startswith(text)


BYTES = [
    (b"", "line 1, column 1: expected JSON"),
    (b'{"a": 1,\n "b" 2}', "line 2, column 6: expected JSON"),
    (b'{"a": "\xff"}', "expected UTF-8 text, got byte 0xff"),
    (b'{"softness": [NaN]}', "expected finite numbers, got NaN"),
    (b'{"softness": [-Infinity]}', "expected finite numbers, got -Infinity"),
    (b'{"fixed": [], "fixed": []}', "fixed: expected once, got it twice"),
    (b"[" * 100_000, "expected a session, got lists nested too deeply"),
    (b'{"rigid": ' + b"9" * 5000 + b"}", "expected numbers of a usual size"),
    (b"[1]", "the file: expected an object, got [1]"),
]


@pytest.mark.parametrize(("data", "text"), BYTES, ids=[text for _, text in BYTES])
def test_what_is_no_session_is_refused_in_one_line(tmp_path: Path, data: bytes, text: str) -> None:
    path = tmp_path / "a.json"
    path.write_bytes(data)
    assert refusal(path).startswith(text)


def test_numbers_beyond_floats_are_not_finite(tmp_path: Path) -> None:
    path = write(tmp_path / "a.json", softness=["X"])
    path.write_text(path.read_text().replace('"X"', "1e999"))
    assert refusal(path).startswith("softness[0]: expected a number from 0 to 1")


def test_a_file_with_a_byte_order_mark_is_read(tmp_path: Path) -> None:
    path = write(tmp_path / "a.json")
    path.write_bytes(b"\xef\xbb\xbf" + path.read_bytes())
    assert read_session(path).mesh_path == tmp_path / "arm.obj"


def test_a_missing_session_is_a_file_error(tmp_path: Path) -> None:
    with pytest.raises(FileError, match=r"missing\.json"):
        read_session(tmp_path / "missing.json")
