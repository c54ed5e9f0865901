"""What the window shows: when the camera moves, and the circle of the brush."""

from __future__ import annotations

import numpy as np

from app.demo import DRAG
from app.pointing.brush import Brush

from .person import wait_until
from .scene import Scene, World

CHEST: World = (0.0, 1.2, 0.1)


def test_the_camera_is_still_while_something_is_painted_or_dragged(ready: Scene) -> None:
    scene, person = ready, ready.person
    person.key("1")  # without the gizmo
    start = scene.silhouette()
    for tool in ("2", "3", "4"):
        person.key(tool)
        scene.stroke((0.0, 1.3, 0.1), (0.0, 1.0, 0.1))
        scene.save_session()
        assert scene.looks_as(start), tool
    for _ in range(3):
        person.key("ctrl+z")
    scene.save_mesh()
    person.key("5")
    scene.stroke(*DRAG[:3])
    wait_until(lambda: (scene.silhouette() != start).any(), what="the arm to move")
    shoulder = int(scene.pixels([(0.1, 1.4, 0.0)])[0][0]) - scene.panel
    assert np.array_equal(scene.silhouette()[:, :shoulder], start[:, :shoulder])
    person.key("ctrl+r")
    person.key("1")  # without the gizmo
    wait_until(lambda: scene.looks_as(start), what="the arm at rest")


def test_the_camera_moves_beside_the_surface_and_while_navigating(plate: Scene) -> None:
    scene, person = plate, plate.person
    start = scene.silhouette()
    (middle,) = scene.pixels([(10, 4, 0)])

    def expect_another_view(what: str) -> None:
        wait_until(lambda: (scene.silhouette() != start).any(), what=what)
        person.key("Home")
        wait_until(lambda: np.array_equal(scene.silhouette(), start), what="the framed view")

    person.key("2")
    person.drag([(800, 650), (850, 600)])
    expect_another_view("an orbit beside the surface")
    person.drag([middle, (800, 500)], button=3)
    expect_another_view("a pan over the surface")
    person.key("1")
    person.drag([middle, (800, 500)])
    expect_another_view("an orbit while navigating")
    person.scroll(*middle, 3)
    expect_another_view("a zoom")
    assert scene.save_session()["fixed"] == []


def test_a_circle_shows_the_brush(mannequin: Scene) -> None:
    scene, person = mannequin, mannequin.person
    (cursor,) = scene.pixels([CHEST])
    person.move(*cursor)
    person.wait_still()
    plain = scene.view()

    def ring() -> np.ndarray:
        """Distances, in pixels, of what the brush changes in the picture from the cursor."""
        person.wait_still()
        y, x = np.nonzero((scene.view() != plain).any(axis=2))
        return np.hypot(x + scene.panel - cursor[0], y - cursor[1])

    assert ring().size == 0, "no circle while navigating"
    person.key("2")
    wait_until(lambda: ring().size > 0, what="the circle")
    diagonal = float(np.linalg.norm(np.ptp(scene.rest, axis=0)))
    scale = scene.camera.units_per_pixel(np.array(CHEST))
    radius = Brush().radius * diagonal / scale
    first = ring()
    assert 0.7 * radius < first.min() < radius < first.max() < 1.2 * radius
    scene.resize_brush(3)
    wait_until(lambda: ring().min() > first.max(), what="the larger circle")
