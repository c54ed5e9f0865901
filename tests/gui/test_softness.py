"""Softness in the window: dabs, the fill, the dots of pins, and a heat map."""

from __future__ import annotations

import numpy as np

from app.demo import DRAG

from .person import Point, wait_until
from .scene import Scene

LEFT, MIDDLE, RIGHT = (3.0, 4.0, 0.0), (10.0, 4.0, 0.0), (17.0, 4.0, 0.0)


def below(place: Point, rows: int) -> Point:
    """So many rows of an opened list below its field."""
    return place[0], place[1] + 22.6 * rows


def value_to_zero(scene: Scene) -> None:
    """Along the slider for the softness brush's value."""
    person = scene.person
    person.drag([person.widget("##value", at) for at in (0.9, 0.0)])


def shown(scene: Scene, points: list[tuple[float, float, float]]) -> np.ndarray:
    """(k, 3) the colour on screen around points of the surface."""
    picture = scene.person.picture().astype(float)
    places = np.rint(scene.pixels(points)).astype(int)
    return np.array([np.median(picture[y - 2 : y + 3, x - 2 : x + 3], (0, 1)) for x, y in places])


def brightness(colors: np.ndarray) -> np.ndarray:
    return np.asarray(colors @ [0.2126, 0.7152, 0.0722])


def test_dabs_are_filled_in_between_and_the_map_shows_it(plate: Scene) -> None:
    scene, person = plate, plate.person
    person.key("4")
    scene.resize_brush(4)
    scene.stroke(RIGHT)
    value_to_zero(scene)
    scene.stroke(LEFT)
    person.move(1200, 700)
    person.wait_still()
    points = [(x, 4.0, 0.0) for x in (6.0, 8.0, 10.0, 12.0, 14.0)]
    before = brightness(shown(scene, points))
    painted = np.array(scene.save_session()["softness"])
    assert np.ptp(before) < 3

    person.choose("Fill")
    person.move(1200, 700)
    person.wait_still()
    filled = np.array(scene.save_session()["softness"])
    assert ((filled > 0.02) & (filled < 0.98)).mean() > 0.5
    assert filled.max() <= painted.max() + 1e-12
    after = brightness(shown(scene, points))
    assert (np.diff(after) > 0).all()
    assert (after[1:] > before[1:]).all()

    person.key("ctrl+z")
    np.testing.assert_array_equal(scene.save_session()["softness"], painted)


def test_pins_are_dots_in_the_softness_map_only(plate: Scene) -> None:
    scene, person = plate, plate.person
    person.key("4")
    scene.resize_brush(8)
    value_to_zero(scene)  # so that nothing but the pins is to be seen

    def dots() -> int:
        person.move(1200, 700)
        person.wait_still()
        return int((scene.view()[:-100].min(axis=2) > 225).sum()) - background

    background = 0
    background = dots()
    scene.stroke(MIDDLE)
    assert dots() > 20
    person.key("2")
    assert dots() <= 0
    person.key("4")
    assert dots() > 20
    scene.stroke(MIDDLE, hold=("shift",))
    assert dots() <= 0


def test_a_heat_map_colours_the_fold_and_only_that(ready: Scene) -> None:
    scene, person = ready, ready.person
    person.key("5")
    person.open_section("Colours", "##map")
    person.choose("##map")
    person.wait_still()
    person.click(*below(person.widget("##map"), 5))
    person.move(1200, 700)
    person.wait_still()
    (body,) = scene.pixels([(0.0, 1.1, 0.1)])
    grey = person.picture()[round(body[1]), round(body[0])].astype(int)
    assert np.ptp(grey) < 12, "grey at rest"

    def coloured() -> float:
        person.key("1")  # without the gizmo, which is coloured too
        person.move(1200, 700)
        person.wait_still()
        return float((np.ptp(scene.view()[:-100].astype(int), axis=2) > 40).mean())

    at_rest = coloured()
    person.key("5")
    scene.stroke(*DRAG)
    wait_until(lambda: coloured() > at_rest + 0.002, what="a coloured fold")
    now = person.picture()[round(body[1]), round(body[0])].astype(int)
    assert np.abs(now - grey).max() < 5
