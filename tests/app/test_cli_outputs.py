"""What commands without a window replace: nothing that they were not told to."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from app.__main__ import main
from app.editor.files.actions import load_document
from app.model.session.writing import write_session
from solver import Mesh, load_mesh
from tests.app.command import session, write_bar

DEFORM = ("deform", "bar.obj", "--session", "bar.json", "-o")


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The working directory, with bar.obj and bar.json."""
    monkeypatch.chdir(tmp_path)
    write_bar()
    return tmp_path


def refused(capsys: pytest.CaptureFixture[str], *words: str) -> str:
    """The one line on stderr of a command that ends with exit code 2, and that changes nothing."""
    before = {path: path.read_bytes() for path in Path().rglob("*") if path.is_file()}
    assert main(words) == 2
    output = capsys.readouterr()
    assert output.err.count("\n") == 1
    assert {path: path.read_bytes() for path in Path().rglob("*") if path.is_file()} == before
    return output.err


@pytest.mark.parametrize("force", [[], ["--force"]])
@pytest.mark.parametrize("name", ["bar.obj", "bar.json", "./bar.obj"])
def test_deform_never_replaces_what_it_is_made_from(
    name: str, force: list[str], capsys: pytest.CaptureFixture[str]
) -> None:
    assert "is what the result is made from" in refused(capsys, *DEFORM, name, *force)


def test_what_is_there_is_replaced_by_force_alone(capsys: pytest.CaptureFixture[str]) -> None:
    Path("out.obj").write_text("mine")
    line = refused(capsys, *DEFORM, "out.obj")
    assert "out.obj is there already; expected another name, or --force to replace it" in line
    assert main([*DEFORM, "out.obj", "--force"]) == 0
    assert len(load_mesh("out.obj").vertices) == 210


def test_a_mesh_never_replaces_a_session(capsys: pytest.CaptureFixture[str]) -> None:
    session("other.obj")
    assert "other.obj is a session" in refused(capsys, *DEFORM, "other.obj", "--force")


@pytest.mark.parametrize("words", [("bar.obj",), ("--session", "bar.json")])
def test_a_window_is_not_opened_to_export_over_what_it_opens(
    words: tuple[str, ...], capsys: pytest.CaptureFixture[str]
) -> None:
    line = refused(capsys, *words, "--export", words[-1])
    assert f"{words[-1]} is what the result is made from; expected another name" in line


@pytest.mark.parametrize(
    ("command", "name", "text"),
    [
        ("demo", "demo.json", "no session of this program"),
        ("demo", "after.png", "there already"),
        ("figures", "figures.md", "there already"),
    ],
)
def test_a_folder_that_has_such_files_is_left_alone(
    command: str, name: str, text: str, capsys: pytest.CaptureFixture[str]
) -> None:
    Path("out").mkdir()
    (Path("out") / name).write_text("mine")
    assert f"{name} is {text}" in refused(capsys, command, "-o", "out")


def test_a_mesh_that_has_changed_is_told_and_not_used_where_its_numbers_do_not_hold(
    capsys: pytest.CaptureFixture[str],
) -> None:
    write_session(Path("bar.json"), load_document(None, Path("bar.json")))
    mesh = load_mesh("bar.obj")
    mesh.save("bar.obj", mesh.vertices * 2.0)
    assert main([*DEFORM, "out.obj"]) == 0
    note = "note: bar.obj: has changed since bar.json was saved of it; its vertices are told by"
    assert note in capsys.readouterr().err
    np.testing.assert_allclose(load_mesh("out.obj").vertices[0], mesh.vertices[0] * 2.0)
    Mesh.from_arrays(mesh.vertices[::-1], mesh.faces).save("bar.obj", mesh.vertices[::-1])
    mesh = load_mesh("bar.obj")
    Mesh.from_arrays(mesh.vertices, mesh.faces[::-1]).save("bar.obj", mesh.vertices)
    line = refused(capsys, *DEFORM, "new.obj")
    assert "and its vertices are others; open bar.json in the window to carry it over" in line
