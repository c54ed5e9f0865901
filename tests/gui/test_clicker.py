"""Whatever is done with mouse and keys, the window answers, and no file beside it is harmed."""

from __future__ import annotations

from pathlib import Path

from .clicker import plate, survives
from .conftest import Opener

EVENTS = 1500


def test_some_thousand_events_leave_a_window_that_saves(
    open_window: Opener, tmp_path: Path
) -> None:
    beside = {tmp_path / "notes.json.txt": b"of mine", tmp_path / "other.obj": b"v 0 0 0\n"}
    for path, data in beside.items():
        path.write_bytes(data)
    mesh = plate(tmp_path)
    person = open_window(mesh.name, "--export", "out.obj")
    document = survives(person, mesh, EVENTS, seed=1)
    assert len(document.mesh.vertices)
    assert {path: path.read_bytes() for path in beside} == beside
    assert person.quit() == 0
