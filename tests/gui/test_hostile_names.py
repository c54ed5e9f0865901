"""Names of files, handles and poses that no screen can show: the window goes on, and shows them."""

from __future__ import annotations

import json
import os
from pathlib import Path

import pytest

from solver import load_mesh
from tests.app.person import slab

from .conftest import Opener
from .person import wait_until
from .scene import Scene

HOSTILE = "a\n\x1b[2J\u202e\ud800 %s%n##b" + "c" * 2000


@pytest.mark.skipif(os.name == "nt", reason="its files have no such names")
def test_names_that_cannot_be_shown_do_no_harm(open_window: Opener, tmp_path: Path) -> None:
    mesh = slab(20, 8, 0.2)
    name = os.fsdecode(b"caf\xe9 \x1b[2J\n%s%n.obj")
    mesh.save(tmp_path / name, mesh.vertices)
    transform = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]
    handle = {"name": HOSTILE, "vertices": [0, 1, 2], "transform": transform}
    pose = {"name": HOSTILE, "transforms": {HOSTILE: transform}}
    session = {
        "format": "surface-deformation-session",
        "version": 1,
        "mesh": {"path": name},
        "handles": [handle],
        "poses": [pose],
    }
    (tmp_path / "bar.json").write_text(json.dumps(session))
    person = open_window("bar.json", "--export", name.replace(".obj", "-out.glb"))
    scene = Scene(person, tmp_path / name, tmp_path / "bar.json", tmp_path / "out.obj")
    person.key("2")
    scene.stroke((14, 4, 0), (16, 4, 0))
    person.key("ctrl+s")
    wait_until(lambda: "fixed" in json.loads((tmp_path / "bar.json").read_text()), what="saving")
    person.screenshot(tmp_path / "window.png")
    saved = json.loads((tmp_path / "bar.json").read_text())
    assert saved["handles"][0]["name"] == saved["poses"][0]["name"] == HOSTILE
    assert saved["fixed"]
    person.key("ctrl+e")
    out = tmp_path / name.replace(".obj", "-out.glb")
    wait_until(out.exists, what="exporting")
    assert load_mesh(out).vertices.shape == mesh.vertices.shape
    assert person.quit() == 0
    assert person.output() == ""
