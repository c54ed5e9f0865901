"""Fixtures: one virtual display a run, and windows that end with their test."""

from __future__ import annotations

import shutil
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from tests.app.person import slab

from .display import VirtualDisplay
from .person import ROOT, Person
from .scene import Scene

Opener = Callable[..., Person]
SCREENS = ROOT / "build" / "screens"


@pytest.fixture(scope="session")
def display(tmp_path_factory: pytest.TempPathFactory) -> Iterator[VirtualDisplay]:
    """A virtual screen; skips where Xvfb or xdotool is missing."""
    missing = [name for name in ("Xvfb", "xdotool") if shutil.which(name) is None]
    if missing:
        pytest.skip(f"not installed: {', '.join(missing)}; the window cannot be tested")
    display = VirtualDisplay(tmp_path_factory.mktemp("display"))
    yield display
    display.stop()


@pytest.fixture
def see_out(request: pytest.FixtureRequest) -> Callable[[Person], None]:
    """Ends a window; what it shows then is kept in build/screens, to be looked at."""

    def see_out(person: Person) -> None:
        if person.process.poll() is None:
            SCREENS.mkdir(parents=True, exist_ok=True)
            person.screenshot(SCREENS / f"{request.node.name}.png")
        person.leave()

    return see_out


@pytest.fixture
def open_window(
    display: VirtualDisplay, tmp_path: Path, see_out: Callable[[Person], None]
) -> Iterator[Opener]:
    """`open_window(*arguments)` starts `python -m app ARGUMENTS` in `tmp_path`."""
    people: list[Person] = []

    def open_window(*arguments: str | Path) -> Person:
        people.append(Person(display, [str(word) for word in arguments], tmp_path))
        return people[-1]

    yield open_window
    for person in people:
        see_out(person)
        assert "Traceback" not in person.output()


@pytest.fixture
def mannequin(open_window: Opener, tmp_path: Path) -> Scene:
    """The default mesh, nothing painted."""
    return opened(open_window, asset("mannequin.obj", tmp_path))


@pytest.fixture
def dog(open_window: Opener, tmp_path: Path) -> Scene:
    """Quads with texture coordinates, normals and groups, nothing painted."""
    return opened(open_window, asset("dog.obj", tmp_path))


@pytest.fixture
def ready(open_window: Opener, tmp_path: Path) -> Scene:
    """The default session: the body fixed, the hand a handle, the elbow soft; bound."""
    mesh, session = (asset(f"mannequin{end}", tmp_path) for end in (".obj", "-elbow.json"))
    person = open_window("--session", session.name, "--export", "out.obj")
    scene = Scene(person, mesh, session, tmp_path / "out.obj")
    scene.save_mesh()
    return scene


@pytest.fixture
def plate(open_window: Opener, tmp_path: Path) -> Scene:
    """A thin slab seen from above; the vertices of its upper side come first."""
    mesh = slab(20, 8, 0.2)
    mesh.save(tmp_path / "plate.obj", mesh.vertices)
    return opened(open_window, tmp_path / "plate.obj")


def asset(name: str, folder: Path) -> Path:
    return Path(shutil.copy(ROOT / "assets" / name, folder))


def opened(open_window: Opener, mesh: Path) -> Scene:
    person = open_window(mesh.name, "--export", "out.obj")
    return Scene(person, mesh, mesh.with_suffix(".json"), mesh.with_name("out.obj"))
