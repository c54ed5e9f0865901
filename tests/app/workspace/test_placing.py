"""The pivot that handles turn about, and the axes they move along."""

from __future__ import annotations

import numpy as np
import pytest

from app.editor.commands import AddHandle, SetPlacing
from app.model.handles import FREE
from app.viewpoint.camera import FIELD_OF_VIEW, Camera
from app.workspace.placing import axes_of
from solver.geometry.motions import motion, moved, rotation
from solver.types import FloatArray, IntArray
from tests.app.person import Person


def pose(person: Person, transform: FloatArray) -> None:
    document = person.editor.document
    document.change("pose", document.pose.moved(document.handles[0].key, transform))


def border(person: Person) -> IntArray:
    """The vertices of the first handle with a free neighbour, the slow way."""
    document = person.editor.document
    key = document.handles[0].key
    pairs = person.editor.neighbours.edges.tolist()
    role = document.role
    found = {a for a, b in pairs if role[a] == key and role[b] == FREE}
    return np.array(sorted(found | {b for a, b in pairs if role[b] == key and role[a] == FREE}))


def pivot(person: Person) -> FloatArray:
    found = person.editor.pivot
    assert found is not None
    return found


T = motion(rotation([1, 2, 3], 40), [1.0, -2, 3])


def test_the_centre_and_the_joint_move_with_the_handle(ready: Person) -> None:
    ready.use("handle", 4.2)
    ready.stroke([20, 0, 0], [20, 4, 0])
    document = ready.editor.document
    rest = document.mesh.vertices
    own = document.vertices_of(document.handles[0].key)
    pose(ready, T)
    np.testing.assert_allclose(pivot(ready), moved(T, rest[own]).mean(axis=0))
    ready.do(SetPlacing(pivot="joint"))
    joint = border(ready)
    assert 0 < len(joint) < len(own)
    np.testing.assert_allclose(pivot(ready), moved(T, rest[joint]).mean(axis=0))


def test_what_has_no_joint_turns_about_its_centre(bar: Person) -> None:
    bar.use("handle", 100)
    bar.stroke([0, 2, 0], [20, 2, 0])
    bar.do(SetPlacing(pivot="joint"))
    document = bar.editor.document
    own = document.vertices_of(document.handles[0].key)
    np.testing.assert_allclose(pivot(bar), document.mesh.vertices[own].mean(axis=0))


def test_nothing_to_place_has_no_pivot(bar: Person) -> None:
    assert bar.editor.pivot is None
    bar.do(AddHandle("empty"))
    assert bar.editor.pivot is None


def test_painting_more_moves_the_pivot(ready: Person) -> None:
    before = pivot(ready)
    ready.use("handle", 1.6)
    ready.stroke([17, 0, 0], [17, 4, 0])
    assert pivot(ready)[0] < before[0] - 0.5


@pytest.mark.parametrize("name", ["world", "local", "view"])
def test_axes_are_orthonormal_and_right_handed(name: str) -> None:
    camera = Camera.look_at([3, 4, 5], [0, 0, 0], FIELD_OF_VIEW, (1280, 800))
    axes = axes_of(name, T, camera)
    np.testing.assert_allclose(axes @ axes.T, np.eye(3), atol=1e-12)
    assert np.linalg.det(axes) > 0
    expected: dict[str, FloatArray] = {
        "world": np.eye(3),
        "local": T[:3, :3].T,  # where the handle's own axes are by now
        "view": np.stack([camera.right, camera.up, -camera.forward]),
    }
    np.testing.assert_allclose(axes, expected[name], atol=1e-12)


def test_a_flattened_handle_still_has_axes() -> None:
    camera = Camera.look_at([3, 4, 5], [0, 0, 0], FIELD_OF_VIEW, (1280, 800))
    axes = axes_of("local", np.diag([1.0, 1, 0, 1]), camera)
    np.testing.assert_allclose(axes, np.eye(3), atol=1e-12)
