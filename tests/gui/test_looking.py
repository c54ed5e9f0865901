"""Shading, the rest shape, pictures and films of what is on screen."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from app.demo import DRAG

from .person import Person, wait_until
from .scene import PARKED, Scene

Image = pytest.importorskip("PIL.Image")
av = pytest.importorskip("av")

GHOST = (0.7, 1.425, 0.03)  # on the arm at rest, beside the one that is dragged


def changed(scene: Scene, widget: str) -> float:
    """The share of the scene that looks otherwise once something of the panel was clicked."""
    person = scene.person
    person.move(*PARKED)
    person.wait_still()
    before = scene.view()[:-100].copy()
    person.choose(widget)
    person.move(*PARKED)
    person.wait_still()
    return float((scene.view()[:-100] != before).any(axis=2).mean())


def color(scene: Scene, point: tuple[float, float, float]) -> np.ndarray:
    (place,) = scene.pixels([point])
    x, y = map(round, place)
    return np.asarray(scene.person.picture()[y, x].astype(int))


def saved(person: Person, path: Path, widget: str) -> Path:
    person.choose(widget)
    wait_until(path.exists, what=path.name)
    return path


def frames(path: Path) -> list[np.ndarray]:
    with av.open(str(path)) as container:
        return [frame.to_ndarray(format="rgb24").astype(int) for frame in container.decode(video=0)]


def test_flat_shading_and_the_ghost_of_the_rest_shape(ready: Scene) -> None:
    scene = ready
    scene.person.open_section("View", "flat")
    assert changed(scene, "flat") > 0.02
    assert changed(scene, "smooth") > 0.02
    assert changed(scene, "rest shape") < 0.005, "at rest it is hidden by the surface"
    scene.stroke(*DRAG)
    scene.save_mesh()
    scene.person.move(*PARKED)
    scene.person.wait_still()
    background, ghost = scene.view()[0, -1].astype(int), color(scene, GHOST)
    assert (ghost < background - 20).all()
    assert np.ptp(ghost) < 15, "grey"
    assert changed(scene, "rest shape") > 0.005
    assert np.abs(color(scene, GHOST) - background).max() < 3


def test_pictures_and_films_are_saved_beside_the_mesh_and_replace_nothing(
    ready: Scene, tmp_path: Path
) -> None:
    scene, person = ready, ready.person
    width, height = person.size()
    person.key("1")  # without the gizmo
    person.open_section("View", "Picture")
    person.move(*PARKED)
    person.wait_still()
    shown = scene.view()[:-100].copy()
    with Image.open(saved(person, tmp_path / "mannequin-picture.png", "Picture")) as image:
        assert image.size == (width - scene.panel, height)
        pixels = np.asarray(image).astype(int)
    assert np.abs(pixels[:-100] - shown).max() < 3
    saved(person, tmp_path / "mannequin-picture-2.png", "Picture")

    person.choose("Record")
    person.key("5")
    scene.stroke(*DRAG)
    person.key("1")
    first, *_, last = frames(saved(person, tmp_path / "mannequin-film.mp4", "Record"))
    assert first.shape == (height // 2 * 2, (width - scene.panel) // 2 * 2, 3)
    assert (np.abs(last - first).max(axis=2) > 40).mean() > 0.005, "the arm has moved"

    path = saved(person, tmp_path / "mannequin-before-after.png", "Before, after")
    with Image.open(path) as image:
        before, after = np.hsplit(np.asarray(image.convert("RGB")).astype(int), 2)
    lines = (np.abs(before[:-100] - shown).max(axis=2) > 20).mean()
    assert lines < 0.002, "as at first, but for the lines of what is held"
    assert (np.abs(after - before).max(axis=2) > 40).mean() > 0.005

    person.choose("film")
    person.key("ctrl+a")
    person.type("turn.gif")
    person.key("Return")
    still = scene.silhouette()
    with Image.open(saved(person, tmp_path / "turn.gif", "Turntable")) as film:
        assert film.n_frames == 72
    assert np.array_equal(scene.silhouette(), still), "the camera is where it was"
    assert person.quit() == 0


def test_before_and_after_stand_beside_each_other(ready: Scene) -> None:
    scene = ready
    scene.person.key("1")  # without the gizmo
    scene.person.open_section("View", "beside")
    scene.stroke((0.3, 1.0, 0.0))
    assert changed(scene, "beside") > 0.02
    columns = np.flatnonzero(scene.silhouette().any(axis=0))
    gaps = np.diff(columns)
    assert (gaps > 20).sum() == 1, "two shapes with room between them"
    left, right = np.split(columns, np.flatnonzero(gaps > 20) + 1)
    assert abs(np.ptp(left) - np.ptp(right)) < 12
    assert changed(scene, "beside") > 0.02
    assert (np.diff(np.flatnonzero(scene.silhouette().any(axis=0))) == 1).all(), "one alone"
