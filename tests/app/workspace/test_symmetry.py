"""What happens on one side of the mirror happens on the other."""

from __future__ import annotations

import numpy as np
import pytest

from app.editor import commands as c
from app.model.handles import FIXED, FREE
from app.workspace.symmetry import mirrored_name
from tests.app.person import Person, slab, state

CENTRE = 10.0  # of the bar, 20 x 4 x 2, along x


@pytest.fixture
def mirrored(bar: Person) -> Person:
    bar.do(c.SetSymmetry("x"))
    assert bar.editor.symmetry is not None
    return bar


def image(person: Person, vertices: np.ndarray) -> np.ndarray:
    """The vertices at the mirror images of others, found by their places."""
    V = person.editor.document.mesh.vertices
    goal = V[vertices] * [-1, 1, 1] + [2 * CENTRE, 0, 0]
    return np.array(sorted(int(np.linalg.norm(V - point, axis=1).argmin()) for point in goal))


@pytest.mark.parametrize("shift", [False, True])
def test_a_fixed_stroke_paints_and_erases_both_sides_as_one_entry(
    mirrored: Person, shift: bool
) -> None:
    document, history = mirrored.editor.document, mirrored.editor.history
    mirrored.use("fixed", 2)
    if shift:
        document.change("role", FIXED, np.arange(len(document.role)))
    mirrored.stroke([3, 2, 0], [5, 2, 0], shift=shift)
    changed = np.flatnonzero(document.role == (FREE if shift else FIXED))
    x = document.mesh.vertices[changed, 0]
    assert x.min() < 5
    assert x.max() > 15
    np.testing.assert_array_equal(image(mirrored, changed), changed)
    assert len(history.done) == 1


def test_softness_is_mirrored_with_its_pins(mirrored: Person) -> None:
    mirrored.use("softness", 2)
    mirrored.stroke([4, 2, 0])
    document = mirrored.editor.document
    soft = np.flatnonzero(document.softness)
    np.testing.assert_array_equal(image(mirrored, soft), soft)
    order = [int(image(mirrored, np.array([v]))[0]) for v in soft]
    np.testing.assert_allclose(document.softness[order], document.softness[soft], atol=1e-9)
    np.testing.assert_array_equal(document.pinned[order], document.pinned[soft])


def test_a_handle_gets_one_on_the_other_side_and_both_are_dragged(mirrored: Person) -> None:
    editor = mirrored.editor
    middle = np.abs(editor.document.mesh.vertices[:, 0] - CENTRE) < 2
    with editor.edit("Fix the middle") as gesture:
        gesture.change("role", FIXED, np.flatnonzero(middle))
    mirrored.do(c.AddHandle("wing.L"))
    mirrored.use("handle", 1.5)
    mirrored.stroke([19, 2, 0])
    mirrored.stroke([19, 0, 0])
    document = editor.document
    assert [handle.name for handle in document.handles] == ["wing.L", "wing.R"]
    left, right = (document.vertices_of(handle.key) for handle in document.handles)
    np.testing.assert_array_equal(image(mirrored, left), right)
    mirrored.use("drag")
    mirrored.stroke([19, 2, 0], [18, 6, 0])
    editor.settle()
    S = np.diag([-1.0, 1, 1, 1])
    S[0, 3] = 2 * CENTRE
    one, two = (document.pose.of(handle.key) for handle in document.handles)
    np.testing.assert_allclose(two, S @ one @ S, atol=1e-12)
    assert np.abs(one - np.eye(4)).max() > 0.1
    entries = len(editor.history.done)
    mirrored.do(c.Undo())
    assert editor.document.pose.at_rest
    assert len(editor.history.done) == entries - 1


def painted(mirrored: Person) -> Person:
    """The middle fixed, the right end a handle that is dragged, all without the mirror."""
    mirrored.do(c.SetSymmetry("off"))
    mirrored.use("fixed", 1.5)
    mirrored.stroke([10, 0, 0], [10, 4, 0])
    mirrored.do(c.AddHandle("hand right"))
    mirrored.use("handle", 1.5)
    mirrored.stroke([19, 2, 0])
    mirrored.use("drag")
    mirrored.stroke([19, 2, 0], [18, 6, 0])
    mirrored.do(c.SetSymmetry("x"))
    return mirrored


def test_regions_are_mirrored_at_once(mirrored: Person) -> None:
    person = painted(mirrored)
    entries = len(person.editor.history.done)
    person.do(c.MirrorRegions())
    document = person.editor.document
    assert [handle.name for handle in document.handles] == ["hand right", "hand left"]
    right, left = (document.vertices_of(handle.key) for handle in document.handles)
    np.testing.assert_array_equal(image(person, right), left)
    assert len(person.editor.history.done) == entries + 1
    before = state(document)
    person.do(c.MirrorRegions())
    assert state(document) == before, "nothing is left to mirror"


def test_a_pose_is_mirrored_and_mirrored_back(mirrored: Person) -> None:
    person = painted(mirrored)
    person.do(c.MirrorPose())
    assert person.editor.message is not None
    assert "nothing mirrors hand right" in person.editor.message.text
    with person.editor.edit("only here") as gesture:
        gesture.change("pose", person.editor.document.pose)
    person.do(c.MirrorRegions())
    document = person.editor.document
    right, left = (handle.key for handle in document.handles)
    with person.editor.edit("Left at rest") as gesture:
        gesture.change("pose", document.pose.without(left))
    before = document.pose
    person.do(c.MirrorPose())
    S = person.editor.symmetry.plane.matrix if person.editor.symmetry else np.eye(4)
    np.testing.assert_allclose(document.pose.of(left), S @ before.of(right) @ S, atol=1e-12)
    np.testing.assert_array_equal(document.pose.of(right), np.eye(4))
    person.do(c.MirrorPose())
    np.testing.assert_allclose(document.pose.of(right), before.of(right), atol=1e-12)


def test_what_has_no_partner_is_said() -> None:
    mesh = slab(20, 4, 2.0)
    V = np.array(mesh.vertices)
    V[V[:, 0] > 15, 1] *= 1.6
    person = Person(type(mesh).from_arrays(V, mesh.faces))
    person.do(c.SetSymmetry("x"))
    assert person.editor.message is not None
    assert "vertices have no partner" in person.editor.message.text


def test_a_mesh_without_symmetry_says_so_and_one_key_turns_it_on_and_off(bar: Person) -> None:
    bar.do(c.ToggleSymmetry())
    assert bar.editor.symmetry is not None
    bar.do(c.ToggleSymmetry())
    assert bar.editor.symmetry is None
    rng = np.random.default_rng(2)
    V = np.cumsum(rng.normal(size=(300, 3)), axis=0)
    lump = Person(type(bar.editor.document.mesh).from_arrays(V, rng.integers(0, 300, (400, 3))))
    lump.do(c.ToggleSymmetry())
    assert lump.editor.symmetry is None
    assert lump.editor.message is not None
    assert "not symmetric" in lump.editor.message.text


@pytest.mark.parametrize(
    ("name", "other"),
    [
        ("hand.L", "hand.R"),
        ("left arm", "right arm"),
        ("Arm_Right", "Arm_Left"),
        ("hand", "hand mirrored"),
        ("lever", "lever mirrored"),
    ],
)
def test_names_tell_the_sides(name: str, other: str) -> None:
    assert mirrored_name(name) == other
