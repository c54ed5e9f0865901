"""Whole acts of a person, with real mouse and keys, judged by what was saved or shown."""

from __future__ import annotations

import numpy as np

from .scene import Scene, World, positions

CHEST: World = (0.0, 1.25, 0.13)
LEFT_HAND, RIGHT_HAND = (0.85, 1.425, 0.02), (-0.85, 1.425, 0.02)
LEFT_FOOT, RIGHT_FOOT = (0.13, 0.05, 0.12), (-0.13, 0.05, 0.12)
HEAD: World = (0.0, 1.70, 0.1)


def moved(scene: Scene, at: World, X: np.ndarray) -> np.ndarray:
    """How far the vertex nearest to a place has gone, (3,)."""
    vertex = int(np.linalg.norm(scene.rest - at, axis=1).argmin())
    return np.asarray(X[vertex] - scene.rest[vertex])


def test_both_arms_a_leg_and_the_head_are_posed_with_nothing_painted(mannequin: Scene) -> None:
    scene, person = mannequin, mannequin.person
    person.key("5")
    for place in (CHEST, LEFT_HAND, RIGHT_HAND, LEFT_FOOT, RIGHT_FOOT, HEAD):
        scene.stroke(place)  # a click each
    assert scene.save_mesh() == scene.source  # which waits for the bind
    goals = {
        LEFT_HAND: (0.65, 1.75, 0.02),
        RIGHT_HAND: (-0.6, 1.1, 0.02),
        LEFT_FOOT: (0.4, 0.3, 0.12),
        HEAD: (0.12, 1.66, 0.1),
    }
    for start, goal in goals.items():
        scene.stroke(start, goal)
    X, session = positions(scene.save_mesh()), scene.save_session()
    assert [pin["name"] for pin in session["pins"]] == [f"pin {k}" for k in range(1, 7)]
    for start, goal in goals.items():
        wanted = np.subtract(goal, start)
        np.testing.assert_allclose(moved(scene, start, X), wanted, atol=0.06)
    for place in (CHEST, RIGHT_FOOT):
        np.testing.assert_allclose(moved(scene, place, X), 0, atol=1e-3)


def test_an_unpainted_limb_is_dragged_and_springs_back_or_stays(mannequin: Scene) -> None:
    scene, person = mannequin, mannequin.person
    person.key("5")
    scene.stroke(CHEST)
    scene.save_mesh()
    at_rest = scene.silhouette()
    forearm, up = (0.7, 1.425, 0.03), (0.6, 1.65, 0.03)
    person.drag(scene.pixels([forearm, up]), steps=12)
    assert np.array_equal(scene.silhouette(), at_rest), "let go of"
    assert len(scene.save_session()["pins"]) == 1
    person.key("k")
    person.drag(scene.pixels([forearm, up]), steps=12)
    X, session = positions(scene.save_mesh()), scene.save_session()
    assert len(session["pins"]) == 2
    np.testing.assert_allclose(moved(scene, forearm, X), np.subtract(up, forearm), atol=0.05)


def test_what_happens_to_one_arm_happens_to_the_other_across_the_mirror(mannequin: Scene) -> None:
    scene, person = mannequin, mannequin.person
    person.key("5")
    scene.stroke(CHEST)
    person.key("x")
    person.key("3")
    scene.resize_brush(5)
    scene.stroke((0.8, 1.425, 0.02), (0.95, 1.425, 0.02))
    person.key("5")
    scene.save_mesh()
    scene.stroke(LEFT_HAND, (0.6, 1.75, 0.02))
    X, session = positions(scene.save_mesh()), scene.save_session()
    assert len(session["handles"]) == 2
    left, right = moved(scene, LEFT_HAND, X), moved(scene, RIGHT_HAND, X)
    assert left[1] > 0.2
    np.testing.assert_allclose(right, left * [-1, 1, 1], atol=0.03)


def test_a_hand_that_was_zoomed_in_on_stays_in_view_while_the_view_turns(ready: Scene) -> None:
    scene, person = ready, ready.person
    (hand,) = scene.pixels([LEFT_HAND])
    person.scroll(*hand, 8)
    person.wait_still()
    person.key("f")
    person.wait_still()
    for step in ((300, 0), (-500, 120), (200, -200)):
        start = (800.0, 720.0)
        person.drag([start, (start[0] + step[0], start[1] + step[1])], button=2)
        seen = scene.silhouette()
        middle = seen[250:550, 300:650]
        assert middle.mean() > 0.1, "the hand is in the middle of the scene"
        assert seen[:, -20:].mean() < 0.9
