"""Questions in the real window: nothing that was made before is lost to Ctrl+S."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np

from .conftest import Opener, opened
from .person import wait_until
from .scene import Scene


def test_a_reopened_mesh_goes_on_where_it_was_left_and_spares_what_it_did_not_open(
    plate: Scene, open_window: Opener, tmp_path: Path
) -> None:
    plate.person.key("2")
    plate.stroke((4, 4, 0), (6, 4, 0))
    fixed = plate.save_session()["fixed"]
    assert fixed
    assert plate.person.quit() == 0
    saved = plate.session.read_bytes()

    fresh = opened(open_window, tmp_path / "plate.obj")
    person = fresh.person
    fresh.stroke((10, 4, 0))  # nothing is heard while it asks
    person.key("2")
    person.choose("Start fresh")
    before = person.picture().copy()
    person.key("ctrl+s")
    wait_until(lambda: not np.array_equal(before, person.picture()), what="the question")
    person.choose("Cancel")
    person.wait_still()
    assert plate.session.read_bytes() == saved
    person.key("ctrl+s")
    person.widget("Replace")
    person.key("Escape")
    person.wait_still()
    assert plate.session.read_bytes() == saved
    person.key("ctrl+s")
    person.widget("Replace")
    person.key("Return")  # the first answer saves beside it
    aside = tmp_path / "plate-2.json"
    wait_until(aside.exists, what="the other file")
    assert json.loads(aside.read_text())["fixed"] == []
    assert plate.session.read_bytes() == saved
    assert person.quit() == 0
    aside.unlink()

    again = opened(open_window, tmp_path / "plate.obj")
    again.person.choose("Continue where you left off")
    again.person.wait_still()
    again.person.key("2")
    again.stroke((14, 4, 0), (16, 4, 0))
    assert set(again.save_session()["fixed"]) > set(fixed)
    assert again.person.quit() == 0
