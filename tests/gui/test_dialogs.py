"""Dialogs beside the real window: it goes on drawing, takes the answer, and ends what is open."""

from __future__ import annotations

import json
import os
import sys
from pathlib import Path

import numpy as np
import pytest

from tests.app.person import slab

from .conftest import Opener
from .person import Person, wait_until

# Stands in for the desktop's own: writes down that it was asked, waits until it is told an answer.
ZENITY = f"""#!{sys.executable}
import os, pathlib, sys, time
pathlib.Path("asked").write_text(f"{{os.getpid()}}\\n" + "\\n".join(sys.argv[1:]))
answer = pathlib.Path("answer")
while not answer.exists():
    time.sleep(0.02)
print(answer.read_text())
answer.unlink()
"""


@pytest.fixture
def person(open_window: Opener, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Person:
    mesh = slab(20, 8, 0.2)
    mesh.save(tmp_path / "plate.obj", mesh.vertices)
    (tmp_path / "preferences").write_text(json.dumps({"dialogs": True}))
    program = tmp_path / "bin" / "zenity"
    program.parent.mkdir()
    program.write_text(ZENITY)
    program.chmod(0o755)
    monkeypatch.setenv("PATH", f"{program.parent}{os.pathsep}{os.environ['PATH']}")
    monkeypatch.delenv("XDG_CURRENT_DESKTOP", raising=False)
    return open_window("plate.obj")


def asked(folder: Path) -> tuple[int, list[str]]:
    """The number of the process that asks, and what it was told."""
    question = folder / "asked"
    wait_until(lambda: question.exists() and "\n" in question.read_text(), what="a dialog")
    number, *words = question.read_text().splitlines()
    question.unlink()
    return int(number), words


def test_a_session_is_saved_where_the_dialog_says_and_then_without_one(
    person: Person, tmp_path: Path
) -> None:
    person.key("ctrl+s")
    _, words = asked(tmp_path)
    assert {"--save", f"--filename={tmp_path / 'plate.json'}"} <= set(words)
    before = person.picture().copy()
    person.key("2")
    wait_until(lambda: not np.array_equal(before, person.picture()), what="the other tool")
    assert not list(tmp_path.glob("*.json"))
    saved = tmp_path / "mine.json"
    (tmp_path / "answer").write_text(str(saved))
    wait_until(saved.exists, what="the session")
    saved.unlink()
    person.key("ctrl+s")
    wait_until(saved.exists, what="the session again")
    assert not (tmp_path / "asked").exists()
    assert person.quit() == 0
    recent = json.loads((tmp_path / "preferences").read_text())["recent"]
    assert recent == [str(saved), str(tmp_path / "plate.obj")]


def test_cancelling_does_nothing_and_closing_the_window_ends_the_dialog(
    person: Person, tmp_path: Path
) -> None:
    person.key("ctrl+o")
    _, words = asked(tmp_path)
    assert f"--filename={tmp_path}{os.sep}" in words
    (tmp_path / "answer").write_text("")
    wait_until(lambda: not (tmp_path / "answer").exists(), what="the end of the dialog")
    person.wait_still()
    person.key("ctrl+o")
    number, _ = asked(tmp_path)
    assert person.quit() == 0
    with pytest.raises(ProcessLookupError):
        os.kill(number, 0)
    assert not list(tmp_path.glob("*.json"))
