"""Dialogs are programs of their own: what they are told, what they answer, how they end."""

from __future__ import annotations

import os
import sys
import time
from pathlib import Path

import pytest

from app.dialogs.dialogs import DialogError, Dialogs
from app.dialogs.programs import Program, kdialog, tk, zenity
from app.dialogs.question import Answer, Kind, Question

MESHES, SESSIONS = Kind("Meshes", (".obj", ".ply")), Kind("Sessions", (".json",))
SECONDS = 30.0


def question(path: Path, purpose: str = "open") -> Question:
    assert purpose in ("open", "save")
    return Question("open" if purpose == "open" else "save", "T", path, (MESHES, SESSIONS))


def fake(code: str) -> Program:
    """A dialog that is a Python program."""
    return lambda question: [sys.executable, "-c", code]


def answered(dialogs: Dialogs) -> Answer:
    """Poll as the window does."""
    deadline = time.monotonic() + SECONDS
    while (answer := dialogs.poll()) is None:
        assert time.monotonic() < deadline
        time.sleep(0.01)
    assert dialogs.poll() is None, "once"
    return answer


def ask(dialogs: Dialogs, question: Question) -> Answer:
    dialogs.ask(question)
    return answered(dialogs)


@pytest.mark.parametrize("name", ["a.obj", ' ä b\'s "c".obj'])
def test_what_is_chosen_is_the_answer(name: str, tmp_path: Path) -> None:
    chosen = tmp_path / name
    print_it = f"import os, sys; sys.stdout.buffer.write(os.fsencode({str(chosen)!r}) + b'\\n')"
    dialogs = Dialogs(fake(print_it))
    asked = question(tmp_path)
    dialogs.ask(asked)
    assert answered(dialogs) == Answer(asked, chosen)


def test_cancelling_answers_nothing_and_another_can_be_asked(tmp_path: Path) -> None:
    dialogs = Dialogs(fake("import sys; print('rest of a path'); sys.exit(1)"))
    for _ in range(2):
        dialogs.ask(question(tmp_path))
        assert answered(dialogs).path is None
    assert dialogs.available


def test_one_at_a_time_and_closing_ends_it(tmp_path: Path) -> None:
    pids = tmp_path / "pids"
    code = f"import os, time; open({str(pids)!r}, 'a').write(f'{{os.getpid()}} '); time.sleep(600)"
    dialogs = Dialogs(fake(code))
    for _ in range(3):
        dialogs.ask(question(tmp_path))
        assert dialogs.poll() is None
    deadline = time.monotonic() + SECONDS
    while not (pids.exists() and pids.read_text().endswith(" ")):
        assert time.monotonic() < deadline
        time.sleep(0.01)
    (pid,) = map(int, pids.read_text().split())
    dialogs.close()
    if os.name == "posix":
        with pytest.raises(ProcessLookupError):
            os.kill(pid, 0)
    assert dialogs.poll() is None
    dialogs.close()


@pytest.mark.parametrize(
    "program",
    [lambda question: ["no-such-program-anywhere"], fake("raise SystemExit(2)")],
    ids=["missing", "failing"],
)
def test_where_no_dialog_can_be_shown_there_are_none_from_then_on(
    program: Program, tmp_path: Path
) -> None:
    dialogs = Dialogs(program)
    assert dialogs.available
    with pytest.raises(
        DialogError, match=r"^no dialog can be shown \(.*\); type the path instead$"
    ):
        ask(dialogs, question(tmp_path))
    assert not dialogs.available
    dialogs.ask(question(tmp_path))
    assert dialogs.poll() is None


def test_programs_are_told_folder_name_and_kinds(tmp_path: Path) -> None:
    folder, file = f"{tmp_path}{os.sep}", str(tmp_path / "a b.json")
    asked = zenity(question(tmp_path))
    assert f"--filename={folder}" in asked
    assert "--file-filter=Meshes | *.obj *.OBJ *.ply *.PLY" in asked
    assert "--file-filter=Sessions | *.json *.JSON" in asked
    assert "--save" not in asked
    saving = zenity(question(Path(file), "save"))
    assert {f"--filename={file}", "--save", "--confirm-overwrite"} <= set(saving)
    kinds = "Meshes (*.obj *.OBJ *.ply *.PLY *.json *.JSON)"
    assert kdialog(question(tmp_path))[-3:] == ["--getopenfilename", folder, kinds]
    assert kdialog(question(Path(file), "save"))[-3:] == ["--getsavefilename", file, kinds]


@pytest.mark.skipif(sys.platform != "linux", reason="a screen cannot be taken away")
def test_pythons_own_dialog_is_no_dialog_where_there_is_no_screen(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("DISPLAY", "WAYLAND_DISPLAY"):
        monkeypatch.delenv(name, raising=False)
    dialogs = Dialogs(tk)
    dialogs.ask(question(tmp_path))
    with pytest.raises(DialogError, match="its program ended with 2"):
        answered(dialogs)
