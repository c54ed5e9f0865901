"""Kept poses in the window: an arm is bent, kept, blended and exported; the rest shape is seen."""

from __future__ import annotations

import numpy as np
from scipy.spatial import cKDTree

from app.demo import DRAG
from solver import Deformer, load_mesh
from solver.geometry.screws import screw

from .person import wait_until
from .scene import Scene, positions
from .test_acts import CHEST, LEFT_HAND, RIGHT_HAND


def keep(scene: Scene, name: str) -> None:
    """Bend the arm with the drag tool, keep the pose and give it a name."""
    person = scene.person
    person.key("5")
    scene.stroke(*DRAG)
    person.open_section("Kept poses", "Keep pose")
    person.choose("Keep pose")
    person.wait_still()
    person.choose("##pose")
    person.key("ctrl+a")
    person.type(name)
    person.key("Return")


def test_an_arm_is_kept_and_blended_halfway(ready: Scene) -> None:
    scene, person = ready, ready.person
    keep(scene, "fist")
    session = scene.save_session()
    assert [pose["name"] for pose in session["poses"]] == ["fist"]
    fist = np.array(session["poses"][0]["transforms"]["hand"])
    np.testing.assert_array_equal(fist, session["handles"][0]["transform"])

    person.drag([person.widget("##share", at) for at in (0.02, 0.5)])
    half = scene.transform()
    angle, whole = (np.arccos((np.trace(T[:3, :3]) - 1) / 2) for T in (half, fist))
    assert 0.4 < angle / whole < 0.6
    np.testing.assert_allclose(half, screw(fist, angle / whole), atol=1e-6)

    mesh = load_mesh(scene.session.with_name("mannequin.obj"))
    setup = scene.save_session()
    deformer = Deformer(
        mesh.vertices,
        mesh.faces,
        setup["fixed"],
        [setup["handles"][0]["vertices"]],
        np.array(setup["softness"]),
        setup["material"],
    )
    solved = deformer.pose([half], rigid=setup["settings"]["rigid"])
    np.testing.assert_allclose(positions(scene.save_mesh()), solved, atol=1e-6)

    person.drag([person.widget("##share", at) for at in (0.5, 1.1)])
    np.testing.assert_array_equal(scene.transform(), fist)
    person.key("ctrl+z")
    np.testing.assert_array_equal(scene.transform(), half)
    person.key("ctrl+z")
    np.testing.assert_array_equal(scene.transform(), fist)


def test_all_poses_are_exported_while_the_one_on_screen_stays(ready: Scene) -> None:
    scene, person = ready, ready.person
    keep(scene, "fist")
    person.choose("...")
    person.wait_still()
    person.choose("Duplicate")
    bent = positions(scene.save_mesh())
    person.key("ctrl+r")
    person.move(1200, 700)
    person.wait_still()
    person.choose("Export poses")
    files = [scene.export.with_name(f"out-{name}.obj") for name in ("fist", "fist_2")]
    wait_until(lambda: all(file.exists() for file in files), what="the poses")
    for file in files:
        np.testing.assert_allclose(load_mesh(file).vertices, bent, atol=1e-6)
    np.testing.assert_array_equal(scene.transform(), np.eye(4))


def test_an_arm_is_posed_and_the_button_poses_the_other_as_its_mirror_image(
    mannequin: Scene,
) -> None:
    scene, person = mannequin, mannequin.person
    person.key("5")
    for place in (CHEST, LEFT_HAND, RIGHT_HAND):
        scene.stroke(place)  # a click each puts a pin
    scene.save_mesh()  # which waits for the bind
    scene.stroke(LEFT_HAND, (0.65, 1.75, 0.02))
    left, before = positions(scene.save_mesh()), scene.save_session()
    person.open_section("Mirror", "Mirror pose")
    person.choose("Mirror pose")
    right, after = positions(scene.save_mesh()), scene.save_session()

    _, raised, other = (np.array(pin["transform"]) for pin in before["pins"])
    _, lowered, image = (np.array(pin["transform"]) for pin in after["pins"])
    np.testing.assert_array_equal(other, np.eye(4))
    np.testing.assert_array_equal(lowered, np.eye(4))
    across = np.diag([-1.0, 1.0, 1.0, 1.0])
    np.testing.assert_allclose(image, across @ raised @ across, atol=0.01)
    turn, mirrored = before["pins"][1]["turn"], after["pins"][2]["turn"]
    np.testing.assert_allclose(mirrored, np.multiply(turn, [1, -1, -1]), atol=0.01)

    partner = cKDTree(scene.rest).query(scene.rest * [-1, 1, 1])[1]
    went = (left - scene.rest) * [-1, 1, 1]
    assert np.linalg.norm(went, axis=1).max() > 0.3
    off = np.linalg.norm((right - scene.rest)[partner] - went, axis=1)
    assert np.sqrt((off**2).mean()) < 0.01
    assert off.max() < 0.05
    person.key("ctrl+z")
    np.testing.assert_array_equal(positions(scene.save_mesh()), left)


def test_the_rest_shape_is_seen_while_its_key_is_held_and_nothing_changes(ready: Scene) -> None:
    scene, person = ready, ready.person
    person.key("1")
    at_rest = scene.silhouette()
    person.key("5")
    scene.stroke(*DRAG)
    session = scene.save_session()
    person.key("1")
    bent = scene.silhouette()
    assert (bent != at_rest).mean() > 0.01
    person.hold("grave")
    assert (scene.silhouette() != at_rest).mean() < 0.0005
    scene.stroke(DRAG[-1], DRAG[0])  # the hand that is there now is not seen, nor grabbed
    person.release_key("grave")
    assert scene.save_session() == session
