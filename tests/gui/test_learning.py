"""Softness learned in the window, and a pose added, from a mesh that was exported before."""

from __future__ import annotations

import numpy as np

from app.demo import DRAG

from .person import wait_until
from .scene import Scene


def ask(scene: Scene, button: str, path: str) -> None:
    """Press the button, which leads to a field, and type into it."""
    scene.person.choose(button)
    scene.person.wait_still()
    scene.person.type(path)
    scene.person.key("Return")


def test_a_bent_arm_teaches_its_elbow_and_becomes_a_pose(ready: Scene) -> None:
    scene, person = ready, ready.person
    person.key("5")
    scene.stroke(*DRAG)
    scene.save_mesh()
    bent = scene.save_session()
    person.key("ctrl+r")

    person.open_section("Soft parts", "Learn from a pose ...")
    ask(scene, "Learn from a pose ...", "out.obj")
    painted = np.array(bent["softness"])
    wait_until(lambda: scene.save_session()["softness"] != bent["softness"], what="what it learns")
    learned = np.array(scene.save_session()["softness"])
    assert np.corrcoef(painted, learned)[0, 1] > 0.5
    person.wait_still()

    person.open_section("Kept poses", "Add ...")
    ask(scene, "Add ...", "out.obj")
    wait_until(lambda: bool(scene.save_session().get("poses")), what="the pose")
    (pose,) = scene.save_session()["poses"]
    assert pose["name"] == "out"
    np.testing.assert_allclose(
        pose["transforms"]["hand"], bent["handles"][0]["transform"], atol=1e-4
    )
