"""However a window ends: at most the last moments are lost, and the next start offers the rest."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from app.unsaved.places import PLACE, kept_work
from tests.app.person import slab

from .conftest import Opener, asset, opened
from .display import VirtualDisplay
from .person import Person, wait_until
from .scene import Scene

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="Windows ends programs otherwise")
SECONDS = 0.3  # between two autosaves
STROKE = (4.0, 4.0, 0.0), (6.0, 4.0, 0.0)


@pytest.fixture
def hasty(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The folder of somebody whose work is kept every moment."""
    preferences = {"dialogs": False, "autosave": SECONDS}
    (tmp_path / "preferences").write_text(json.dumps(preferences))
    (tmp_path / "temporary").mkdir()
    monkeypatch.setenv(PLACE, str(tmp_path / "state"))
    monkeypatch.setenv("TMPDIR", str(tmp_path / "temporary"))
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path / "temporary"))
    return tmp_path


@pytest.fixture
def painted(hasty: Path, plate: Scene) -> Scene:
    """A plate with a stroke that nobody has saved, seen from above; its autosave is there."""
    plate.person.key("2")
    plate.stroke(*STROKE)
    wait_until(lambda: bool(autosaves(hasty)), what="the autosave")
    return plate


def autosaves(folder: Path) -> list[Path]:
    return [*folder.glob("state/*.json"), *folder.glob("temporary/*/*.json")]


def offered() -> dict[str, Any]:
    """What the next start offers, which is one work; it is left where it is."""
    (kept,) = kept_work()
    kept.lock.release()
    return dict(json.loads(kept.path.read_text()))


def ended(person: Person) -> int:
    return person.process.wait(20)


# Closing

ANSWERS = [("Save", True, 0), ("Discard", False, 0)]


@pytest.mark.parametrize(("answer", "saved", "kept"), ANSWERS)
def test_closing_with_changes_asks(
    painted: Scene, hasty: Path, answer: str, saved: bool, kept: int
) -> None:
    painted.person.close()
    painted.person.choose("Cancel")
    painted.person.wait_still()
    assert painted.person.process.poll() is None
    painted.person.close()
    painted.person.choose(answer)
    assert ended(painted.person) == 0
    assert painted.session.exists() == saved
    assert len(autosaves(hasty)) == kept
    if saved:
        assert json.loads(painted.session.read_text())["fixed"]


def test_closing_twice_answers_nothing_and_keeps_all(painted: Scene) -> None:
    assert painted.person.quit() == 0
    assert offered()["fixed"]
    assert "offered at the next start" in painted.person.output()
    assert not painted.session.exists()


def test_the_next_start_goes_on_with_it_without_a_name(
    painted: Scene, hasty: Path, open_window: Opener
) -> None:
    painted.person.process.kill()
    ended(painted.person)
    kept = offered()
    person = open_window()
    person.choose("Later")
    assert person.quit() == 0
    assert offered() == kept
    person = open_window()
    person.choose("Continue")
    person.wait_still()
    person.key("ctrl+s")
    wait_until(painted.session.exists, what="the session")
    wait_until(lambda: not autosaves(hasty), what="what was saved to be kept no more")
    assert json.loads(painted.session.read_text())["fixed"] == kept["fixed"]
    assert person.quit() == 0
    assert list((hasty / "state").iterdir()) == []


def test_another_window_leaves_it_alone(painted: Scene, hasty: Path, open_window: Opener) -> None:
    other = open_window("plate.obj")
    assert "Continue" not in json.loads((hasty / "widgets").read_text())
    assert other.quit() == 0
    assert painted.person.quit() == 0
    assert offered()["fixed"]


# Being ended


@pytest.mark.parametrize(
    ("name", "code"), [("SIGINT", 130), ("SIGTERM", 0), ("SIGHUP", 0), ("SIGQUIT", 0)]
)
def test_signals_end_it_and_lose_nothing(painted: Scene, name: str, code: int) -> None:
    before = offered_by_a_running_window(painted.person)
    painted.stroke((12, 4, 0), (14, 4, 0))
    painted.person.process.send_signal(getattr(signal, name))
    assert ended(painted.person) == code
    assert set(offered()["fixed"]) > set(before["fixed"])


def offered_by_a_running_window(person: Person) -> dict[str, Any]:
    (path,) = autosaves(Path(os.environ[PLACE]).parent)
    assert kept_work() == [], "it is its own"
    return dict(json.loads(path.read_text()))


@pytest.mark.parametrize("name", ["SIGTERM", "SIGKILL"])
def test_a_stroke_in_progress_is_kept(hasty: Path, plate: Scene, name: str) -> None:
    person = plate.person
    person.key("2")
    (start, end) = plate.pixels(STROKE)
    person.move(*start)
    person.press()
    person.move(*end)
    wait_until(lambda: bool(autosaves(hasty)), what="the autosave")
    person.process.send_signal(getattr(signal, name))
    ended(person)
    person.release()
    assert offered()["fixed"]


def test_ending_while_it_binds(hasty: Path, open_window: Opener) -> None:
    scene = opened(open_window, asset("mannequin.obj", hasty))
    scene.person.key("2")
    scene.stroke((0.0, 1.2, 0.1))
    scene.person.key("3")
    for solver in solvers(scene.person.process.pid):
        os.kill(solver, signal.SIGSTOP)  # a bind that takes for ever
    scene.stroke((0.8, 1.42, 0.03))
    wait_until(lambda: bool(painted_handles(hasty)), what="the handle")
    scene.person.process.terminate()
    assert ended(scene.person) == 0
    held = offered()
    assert held["fixed"]
    assert held["handles"][0]["vertices"]


def painted_handles(folder: Path) -> list[Any]:
    """The handles with vertices in what is kept so far."""
    texts = [path.read_text() for path in autosaves(folder)]
    return [h for text in texts for h in json.loads(text)["handles"] if h["vertices"]]


def test_a_lost_display(hasty: Path, tmp_path_factory: pytest.TempPathFactory) -> None:
    mesh = slab(20, 8, 0.2)
    mesh.save(hasty / "plate.obj", mesh.vertices)
    display = VirtualDisplay(tmp_path_factory.mktemp("lost"))
    person = Person(display, ["plate.obj"], hasty)
    try:
        person.key("2")
        Scene(person, hasty / "plate.obj", hasty / "plate.json", hasty / "out.obj").stroke(*STROKE)
        display.stop()
        assert ended(person) == 1
        assert offered()["fixed"]
    finally:
        display.stop()
        person.leave()


def test_a_solver_that_always_dies_takes_no_work_along(hasty: Path, open_window: Opener) -> None:
    scene = opened(open_window, asset("mannequin.obj", hasty))
    person = scene.person
    person.key("2")
    scene.stroke((0.0, 1.2, 0.1))
    person.key("3")
    scene.stroke((0.8, 1.42, 0.03))
    killed = set[int]()

    def kill_another() -> bool:
        found = solvers(person.process.pid)
        for solver in found:
            os.kill(solver, signal.SIGKILL)
        killed.update(found)
        return len(killed) >= 3

    wait_until(kill_another, what="the third solver to die")
    assert scene.save_session()["handles"][0]["vertices"]
    scene.stroke((0.65, 1.42, 0.03))
    wait_until(lambda: bool(painted_handles(hasty)), what="the handle")
    person.process.kill()
    ended(person)
    assert offered()["handles"][0]["vertices"]


def solvers(process: int) -> list[int]:
    """The numbers of the solver's processes of a window."""
    children = Path(f"/proc/{process}/task/{process}/children").read_text().split()
    commands = {int(child): Path(f"/proc/{child}/cmdline").read_bytes() for child in children}
    return [child for child, command in commands.items() if b"spawn_main" in command]


# No room


@pytest.fixture(params=["full", "read-only"])
def no_room(request: pytest.FixtureRequest, hasty: Path) -> Iterator[Path]:
    """A folder with a plate that takes nothing more, where autosaves would go too."""
    folder = hasty / "state"
    folder.mkdir()
    mount = ["mount", "-t", "tmpfs", "-o", "size=256k", "tmpfs", str(folder)]
    if os.getuid() or subprocess.run(mount, check=False, capture_output=True).returncode:
        pytest.skip("only the system's administrator can make a disk that is full")
    try:
        mesh = slab(20, 8, 0.2)
        mesh.save(folder / "plate.obj", mesh.vertices)
        if request.param == "full":
            fill(folder / "rest")
        else:
            subprocess.run(["mount", "-o", "remount,ro", str(folder)], check=True)
        yield folder
    finally:
        subprocess.run(["umount", "-l", str(folder)], check=True)


def fill(path: Path) -> None:
    with path.open("wb", buffering=0) as file:
        try:
            while True:
                file.write(bytes(1024))
        except OSError:
            return


def test_where_there_is_no_room_another_folder_is_used_and_named(
    no_room: Path, hasty: Path, open_window: Opener
) -> None:
    person = open_window(no_room / "plate.obj")
    scene = Scene(person, no_room / "plate.obj", hasty / "plate.json", hasty / "out.obj")
    person.key("2")
    scene.stroke(*STROKE)
    wait_until(lambda: bool(scene.error_shown().any()), what="the place to be named")
    assert offered_by_a_running_window(person)["fixed"]
    person.key("ctrl+s")
    person.choose("Save there")
    wait_until(scene.session.exists, what="the session in another folder")
    assert json.loads(scene.session.read_text())["fixed"]
    wait_until(lambda: not autosaves(hasty), what="what was saved to be kept no more")
    scene.stroke((12, 4, 0), (14, 4, 0))
    person.process.terminate()
    assert ended(person) == 0
    assert len(offered()["fixed"]) > len(json.loads(scene.session.read_text())["fixed"])
