"""Opening: what cannot be read, and what was not saved before."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from pathlib import Path

import numpy as np

from tests.app.person import slab

from .conftest import Opener
from .display import VirtualDisplay
from .person import ROOT, wait_until
from .scene import Scene


def test_what_cannot_be_opened_is_a_message(plate: Scene, tmp_path: Path) -> None:
    scene, person = plate, plate.person
    person.key("2")
    scene.stroke((4, 4, 0), (6, 4, 0))
    before = scene.save_session()
    assert not scene.error_shown().any()
    (tmp_path / "bad.json").write_text(json.dumps({"x" * 120: 1}))  # a message of several lines
    person.key("ctrl+o")
    person.type("bad.json")
    person.key("Return")
    wait_until(lambda: bool(scene.error_shown().any()), what="the message")
    person.wait_still()
    columns = np.flatnonzero(scene.error_shown().any(axis=0))
    assert scene.panel < columns.min() < columns.max() < person.size()[0] - 10
    assert scene.save_session() == before

    other = slab(3, 3, 1.0)
    other.save(tmp_path / "b.obj", other.vertices)
    scene.stroke((14, 4, 0))
    person.key("ctrl+o")
    person.wait_still()  # the field has the keyboard
    person.type("b.obj")  # in place of the name that is there
    person.key("Return")
    kept = tmp_path / "state"
    wait_until(lambda: bool([*kept.glob("plate-*.json")]), what="the unsaved stroke to be kept")
    person.wait_still()  # what is pressed while it opens is not heard
    scene.session = tmp_path / "b.json"
    assert scene.save_session()["mesh"]["vertices"] == len(other.vertices)
    assert person.quit() == 0


def test_the_row_of_a_path_unfolds_when_its_key_is_pressed(plate: Scene) -> None:
    plate.person.choose("Files", 0.3)
    wait_until(lambda: not plate.person.shows("Export mesh"), what="it is folded")
    assert plate.save_session()["mesh"]["path"] == "plate.obj"
    plate.person.widget("Export mesh")


def test_preferences_that_cannot_be_read_are_in_nobodys_way(
    open_window: Opener, tmp_path: Path
) -> None:
    (tmp_path / "preferences").write_text("{ window:")
    person = open_window()
    assert person.quit() == 0
    (line,) = person.output().splitlines()
    assert re.search(
        r"preferences are ignored, .*preferences: line 1, column 3: expected JSON", line
    )
    assert (tmp_path / "preferences").read_text() == "{ window:"


def test_nothing_is_left_behind_where_nothing_was_done(plate: Scene, tmp_path: Path) -> None:
    assert plate.person.quit() == 0
    assert sorted(tmp_path.rglob("*.json")) == []


def test_a_wrong_file_on_the_command_line_ends_the_window(
    display: VirtualDisplay, tmp_path: Path
) -> None:
    (tmp_path / "m.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n")
    done = subprocess.run(
        [sys.executable, "-P", "-m", "app", "m.obj"],
        cwd=tmp_path,
        env=os.environ | {"DISPLAY": display.name, "PYTHONPATH": str(ROOT)},
        capture_output=True,
        text=True,
        check=False,
        timeout=60,
    )
    assert (done.returncode, done.stdout) == (2, "")
    assert re.fullmatch(r"python -m app: m.obj, line 4: [^\n]*vertex 4[^\n]*\n", done.stderr)
