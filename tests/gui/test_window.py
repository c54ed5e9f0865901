"""The window as a person uses it: real mouse, real keys, and the files that come out."""

from __future__ import annotations

import numpy as np

from app.demo import BODY, DRAG, ELBOW, HAND
from tests.app.person import sheet

from .scene import Scene, kinds_of_change, positions, vertex_lines


def bend(scene: Scene, X: np.ndarray) -> float:
    """Degrees between the upper arm and the forearm of the figure's left arm."""

    def middle(x: float) -> np.ndarray:
        return np.asarray(X[np.abs(scene.rest[:, 0] - x) < 0.02].mean(axis=0))

    upper, fore = middle(0.38) - middle(0.28), middle(0.66) - middle(0.56)
    cosine = upper @ fore / np.linalg.norm(upper) / np.linalg.norm(fore)
    return float(np.degrees(np.arccos(np.clip(cosine, -1, 1))))


def test_paint_drag_and_export(mannequin: Scene) -> None:
    scene, person = mannequin, mannequin.person
    person.key("2")
    scene.resize_brush(7)
    for path in BODY:
        scene.stroke(*path)
    person.key("3")
    scene.resize_brush(-3)
    scene.stroke(*HAND)
    person.key("4")
    scene.resize_brush(3)
    scene.stroke(*ELBOW)
    assert scene.save_mesh() == scene.source, "painting moves nothing"
    person.key("5")
    scene.stroke(*DRAG)
    saved, session = scene.save_mesh(), scene.save_session()
    X = positions(saved)

    assert kinds_of_change(scene.source, saved) == {b"v"}
    fixed, (handle,) = session["fixed"], session["handles"]
    before, after = vertex_lines(scene.source), vertex_lines(saved)
    assert [after[i] for i in fixed] == [before[i] for i in fixed]
    x = scene.rest[:, 0]
    assert set(np.flatnonzero(x < -0.2)) <= set(fixed), "the other arm"
    A, t = np.split(np.array(handle["transform"])[:3], [3], axis=1)
    hand = handle["vertices"]
    assert np.isin(np.flatnonzero(x > 0.85), hand).mean() > 0.98
    np.testing.assert_allclose(X[hand], scene.rest[hand] @ A.T + t.T, rtol=0, atol=1e-9)
    softness = np.array(session["softness"])
    assert softness[np.abs(x - 0.465) < 0.02].min() > 0.5
    assert softness[x < 0.2].max() == 0
    assert bend(scene, scene.rest) < 5
    assert bend(scene, X) > 60
    assert person.quit() == 0


def test_undo_and_redo_go_back_and_forth(ready: Scene) -> None:
    scene, person = ready, ready.person

    def state() -> tuple[object, bytes]:
        return scene.save_session(), scene.save_mesh()

    states = [state()]
    person.key("4")
    scene.stroke((0.6, 1.425, 0.03))
    states.append(state())
    person.key("5")
    scene.stroke(*DRAG[:3])
    states.append(state())
    assert states[0][1] == states[1][1] == scene.source
    assert states[0][0] != states[1][0]
    assert states[1][1] != states[2][1]
    for key, expected in (
        ("ctrl+z", states[1]),
        ("ctrl+z", states[0]),
        ("ctrl+y", states[1]),
        ("ctrl+shift+z", states[2]),
    ):
        person.key(key)
        assert state() == expected, key
    person.key("ctrl+r")
    assert scene.save_mesh() == scene.source


def test_paint_stays_on_its_side_and_shift_erases(plate: Scene) -> None:
    scene, person = plate, plate.person
    upper, _ = sheet(20, 8)
    person.key("2")
    scene.resize_brush(4)  # more than a unit: five times the thickness
    scene.stroke((4, 4, 0), (16, 4, 0))
    fixed = scene.save_session()["fixed"]
    along_the_middle = np.flatnonzero((upper[:, 1] == 4) & (abs(upper[:, 0] - 10) <= 6))
    assert set(along_the_middle) <= set(fixed)
    assert max(fixed) < len(upper), "nothing on the far side"
    scene.stroke((12, 4, 0), (18, 4, 0), hold=["shift"])
    left = scene.save_session()["fixed"]
    assert 0 < len(left) < len(fixed)
    row = set(along_the_middle.tolist())
    assert row & set(left) == {i for i in row if upper[i, 0] <= 10}
    scene.stroke((3, 4, 0), (13, 4, 0), hold=["shift"])
    assert scene.save_session()["fixed"] == []


def test_quads_with_normals_keep_everything_else(dog: Scene) -> None:
    scene, person = dog, dog.person
    person.key("2")
    scene.resize_brush(3)
    for x in (-0.2, 0.2):
        scene.stroke((x, 0.1, 0.75), (x, 0.35, 0.75))
    person.key("3")
    scene.stroke((0.0, 1.0, 1.3))
    assert scene.save_mesh() == scene.source
    person.key("5")
    scene.stroke((0.0, 1.0, 1.3), (0.3, 1.2, 1.3))
    saved, session = scene.save_mesh(), scene.save_session()
    assert kinds_of_change(scene.source, saved) == {b"v", b"vn"}
    assert session["fixed"]
    before, after = vertex_lines(scene.source), vertex_lines(saved)
    assert [after[i] for i in session["fixed"]] == [before[i] for i in session["fixed"]]
    assert person.quit() == 0
