"""Handles turned and moved exactly in the window, with real mouse and keys."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from app.tools.gizmo.shape import RADIUS
from solver.geometry.motions import rotation

from .scene import PARKED, Scene

FOREARM = (0.62, 1.425, 0.03)  # free


def pivot(scene: Scene) -> NDArray[np.float64]:
    """The centre of the handle at rest."""
    (handle,) = scene.save_session()["handles"]
    return np.asarray(scene.rest[handle["vertices"]].mean(axis=0))


def check_turned(scene: Scene, degrees: float, axis: tuple[float, float, float]) -> None:
    """About its centre, exactly."""
    T, centre = scene.transform(), pivot(scene)
    np.testing.assert_allclose(T[:3, :3], rotation(axis, degrees), rtol=0, atol=1e-9)
    np.testing.assert_allclose(T[:3, :3] @ centre + T[:3, 3], centre, rtol=0, atol=1e-9)


def test_a_handle_is_turned_by_exactly_a_quarter(ready: Scene) -> None:
    scene, person = ready, ready.person
    person.key("2")
    person.move(*PARKED)
    for keys in (("r", "z", "4", "5"), ("r", "z", "4", "6", "BackSpace", "5")):
        for key in keys:
            person.key(key)
        person.key("Return")
    check_turned(scene, 90, (0, 0, 1))

    for _ in range(2):
        person.key("ctrl+z")
    np.testing.assert_array_equal(scene.transform(), np.eye(4))
    painted = scene.save_session()["fixed"]
    scene.stroke(FOREARM)
    assert len(scene.save_session()["fixed"]) > len(painted), "digits took no other tool"


def test_the_gizmo_turns_and_moves_and_escape_takes_back(ready: Scene) -> None:
    scene, person = ready, ready.person
    person.key("5")
    (middle,) = scene.pixels([tuple(pivot(scene))])
    ring = [
        (middle[0] + RADIUS * np.cos(a), middle[1] - RADIUS * np.sin(a))
        for a in np.radians([150, 170, 200])
    ]
    person.move(*ring[0])
    person.press()
    person.move(*ring[1])
    for key in ("9", "0"):
        person.key(key)
    person.release()
    R = scene.transform()[:3, :3]
    np.testing.assert_allclose(R, rotation([0, 0, 1], 90), rtol=0, atol=1e-9)

    turned = scene.transform()
    person.move(*ring[0])
    person.press()
    person.move(*ring[2])
    person.key("Escape")
    person.release()
    np.testing.assert_array_equal(scene.transform(), turned)

    arrow = middle[0], middle[1] - 1.3 * RADIUS
    person.drag([arrow, (arrow[0] + 7, arrow[1] - 60)])
    shift = scene.transform()[:3, 3] - turned[:3, 3]
    assert shift[1] > 0.05
    np.testing.assert_allclose(shift[[0, 2]], 0, atol=1e-12)


def test_numbers_are_typed_in_the_panel(ready: Scene) -> None:
    scene, person = ready, ready.person
    person.key("5")
    person.drag([person.widget("##rx")], hold=["ctrl"])
    person.type("90")
    person.key("Return")
    check_turned(scene, 90, (1, 0, 0))
    person.key("ctrl+z")
    np.testing.assert_array_equal(scene.transform(), np.eye(4))
