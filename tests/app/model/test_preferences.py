"""Preferences: kept between runs, never in the way, never written over what may be mended."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any

import pytest

from app.model.preferences import PLACE, Preferences, PreferencesFile, preferences_path


@pytest.fixture
def path(tmp_path: Path) -> Path:
    return tmp_path / "folder that is not there yet" / "preferences.json"


def test_what_is_changed_is_there_again(path: Path) -> None:
    file = PreferencesFile(path)
    assert file.values == Preferences()
    assert not path.exists(), "nothing is written before something changes"
    file.change(interface_scale=2.0, window=(1000, 650))
    file.change(recent=("/a/b.obj", "/ä.json"), dialogs=False, autosave=20)
    again = PreferencesFile(path)
    assert again.values == Preferences(2.0, (1000, 650), False, ("/a/b.obj", "/ä.json"), 20)
    assert again.fault == file.fault == ""


def test_two_windows_do_not_undo_each_other(path: Path) -> None:
    one, other = PreferencesFile(path), PreferencesFile(path)
    one.change(interface_scale=1.5)
    other.change(window=(800, 600))
    assert PreferencesFile(path).values == Preferences(1.5, (800, 600))


BROKEN: dict[str, tuple[Any, str]] = {
    "no json": ("{", "line 1, column 2: expected JSON"),
    "empty": ("", "line 1, column 1: expected JSON"),
    "a list": ([], "the file: expected an object"),
    "unknown": ({"colour": 1}, "colour: unknown key, expected one of interface_scale"),
    "scale": ({"interface_scale": 9}, "interface_scale: expected a number from 0.5 to 4.0, got 9"),
    "no number": ({"interface_scale": True}, "interface_scale: expected a number"),
    "window": ({"window": [800]}, "window: expected a width and a height"),
    "no window": ({"window": [800, -1]}, "window: expected a width and a height"),
    "dialogs": ({"dialogs": "yes"}, "dialogs: expected true or false"),
    "autosave": ({"autosave": 0}, "autosave: expected a number of seconds, above 0 and up to 3600"),
    "recent": ({"recent": [1]}, "recent[0]: expected a text"),
}


@pytest.mark.parametrize(("content", "expected"), BROKEN.values(), ids=list(BROKEN))
def test_what_cannot_be_understood_is_ignored_and_left_as_it_is(
    content: Any, expected: str, tmp_path: Path
) -> None:
    path = tmp_path / "preferences.json"
    path.write_text(content if isinstance(content, str) else json.dumps(content))
    before = path.read_bytes()
    file = PreferencesFile(path)
    assert file.values == Preferences()
    assert expected in file.fault
    assert str(path) in file.fault
    assert "\n" not in file.fault
    file.change(interface_scale=2.0)
    assert file.values.interface_scale == 2.0, "for this run"
    assert path.read_bytes() == before


def test_a_file_that_breaks_while_the_program_runs_is_left_alone(path: Path) -> None:
    file = PreferencesFile(path)
    file.change(window=(800, 600))
    path.write_text("{")
    file.change(interface_scale=2.0)
    assert path.read_text() == "{"
    assert "expected JSON" in file.fault
    assert file.values == Preferences(2.0, (800, 600))


def test_where_nothing_can_be_written_it_says_so_once_and_goes_on(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    file = PreferencesFile(tmp_path / "file" / "preferences.json")
    file.change(interface_scale=2.0)
    assert file.fault.startswith("preferences are not kept: ")
    assert file.values.interface_scale == 2.0


def test_they_lie_where_the_platform_keeps_them(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv(PLACE, raising=False)
    if sys.platform == "linux":
        monkeypatch.setenv("XDG_CONFIG_HOME", "/x")
        assert preferences_path() == Path("/x/surface-deformation/preferences.json")
    assert preferences_path().name == "preferences.json"
    monkeypatch.setenv(PLACE, "elsewhere.json")
    assert preferences_path() == Path("elsewhere.json")
