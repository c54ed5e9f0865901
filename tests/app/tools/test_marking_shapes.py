"""Lasso, box and limb: what they take of what is seen, and who has the mouse."""

from __future__ import annotations

import numpy as np
import pytest

from app.bundled import DEFAULT_MESH
from app.editor import commands as c
from app.model.handles import FIRST_HANDLE, FIXED, FREE
from app.scene.overlay import ERASING, NOTHING, PAINTING
from app.selection import piece_limbs
from solver import Mesh, load_mesh
from solver.types import FloatArray
from tests.app.person import Person, sheet, slab, state

BESIDE = [-3.0, 7.0, 0.0]  # of a slab that begins at the origin
LEFT_HALF: list[list[float]] = [[-1, -1, 0], [4.5, -1, 0], [4.5, 9, 0], [-1, 9, 0]]


@pytest.fixture
def person() -> Person:
    """A slab of 10 x 8, 2 thick, seen from above; the upper side comes first."""
    made = Person(slab(10, 8, 2.0), eye=(0, 0, 30))
    made.use("fixed")
    return made


def marked(person: Person, role: int = FIXED) -> FloatArray:
    """(k, 3) rest positions of the vertices with a role."""
    document = person.editor.document
    return document.mesh.vertices[document.role == role]


def upper(person: Person) -> FloatArray:
    V = person.editor.document.mesh.vertices
    return V[: len(V) // 2]


def same(one: FloatArray, other: FloatArray) -> None:
    np.testing.assert_array_equal(one[np.lexsort(one.T)], other[np.lexsort(other.T)])


def test_a_lasso_takes_what_is_seen_inside_it_as_one_entry(person: Person) -> None:
    person.do(c.SetMarking(shape="lasso"))
    person.stroke(*LEFT_HALF)
    top = upper(person)
    same(marked(person), top[top[:, 0] < 4.5])
    assert [entry.label for entry in person.editor.history.done] == ["Paint fixed"]
    person.do(c.Undo())
    assert not person.editor.document.role.any()


def test_a_box_goes_through_where_it_is_told_to(person: Person) -> None:
    person.do(c.SetMarking(shape="box", through=True))
    person.stroke([4.5, -3, 0], [-4, 4, 0], [-4, 14, 0])
    assert (marked(person)[:, 0] < 4.5).all()
    V = person.editor.document.mesh.vertices
    assert len(marked(person)) == (V[:, 0] < 4.5).sum()


@pytest.mark.parametrize("shape", ["lasso", "box"])
def test_shift_erases_only_what_the_tool_marks(person: Person, shape: str) -> None:
    person.do(c.SetMarking(shape=shape))
    around = [[-3, -3, 0], [13, -3, 0], [13, 11, 0], [-3, 11, 0]]
    corners = around if shape == "lasso" else [around[0], around[2]]
    person.stroke(*corners)
    same(marked(person), upper(person))
    person.use("handle")
    person.stroke(*corners, shift=True)
    same(marked(person), upper(person))
    person.use("fixed")
    person.stroke(*corners, shift=True)
    assert not person.editor.document.role.any()


def test_a_lasso_of_the_handle_tool_makes_the_first_handle_only_where_it_takes_something(
    person: Person,
) -> None:
    person.use("handle")
    person.do(c.SetMarking(shape="lasso"))
    person.stroke([-4, 12, 0], [-3, 12, 0], [-3, 13, 0])
    assert person.editor.document.handles == ()
    assert person.editor.history.done == []
    person.stroke(*LEFT_HALF)
    assert len(marked(person, FIRST_HANDLE)) > 0
    person.do(c.Undo())
    assert person.editor.document.handles == ()


@pytest.mark.parametrize(("mode", "expected"), [("set", 0.4), ("add", 0.6), ("subtract", 0.0)])
def test_softness_so_marked_follows_the_brush_and_is_pinned(
    person: Person, mode: str, expected: float
) -> None:
    document = person.editor.document
    person.use("softness")
    person.do(c.SetMarking(shape="box"), c.SetBrush(value=0.2))
    person.stroke([-3, -3, 0], [13, 11, 0])
    person.do(c.SetBrush(mode=mode, value=0.4))
    person.stroke([-3, -3, 0], [4.5, 11, 0])
    left = np.flatnonzero(document.pinned & (document.mesh.vertices[:, 0] < 4.5))
    np.testing.assert_allclose(document.softness[left], expected, atol=1e-12)
    same(document.mesh.vertices[document.pinned], upper(person))
    person.stroke([-3, -3, 0], [4.5, 11, 0], shift=True)
    assert not document.pinned[left].any()
    assert not document.softness[left].any()


def test_hidden_parts_are_never_taken() -> None:
    V, F = sheet(6, 6)
    two = Mesh.from_arrays(np.vstack([V, V - [0, 0, 3]]), np.vstack([F, F + len(V)]))
    person = Person(two, eye=(0, 0, 30))
    person.use("fixed")
    person.do(c.ShowPart(0, False), c.SetMarking(shape="box"))
    for through in (False, True):
        person.do(c.SetMarking(through=through))
        person.stroke([-3, -3, 0], [9, 9, 0])
        same(marked(person), V - [0, 0, 3])


@pytest.mark.parametrize("shape", ["lasso", "box"])
def test_a_press_beside_the_surface_begins_a_loop_and_alt_orbits(
    person: Person, shape: str
) -> None:
    person.do(c.SetMarking(shape=shape))
    for _ in person.hold([BESIDE, [5, 7, 0], [5, 1, 0]]):
        assert person.editor.captures
    person.frame([5, 1, 0], "r")
    assert len(marked(person)) > 0
    person.frame(BESIDE, "pd", alt=True)
    assert not person.editor.captures
    before = person.editor.viewpoint.camera
    person.frame([0, 5, 0], "d", alt=True)
    assert person.editor.viewpoint.camera is not before


def test_a_loop_is_seen_while_it_is_drawn_and_where_the_mouse_was(person: Person) -> None:
    person.do(c.SetMarking(shape="lasso"))
    person.frame([5, 4, 0])
    assert person.editor.cursor is NOTHING
    for shift, color in ((False, PAINTING), (True, ERASING)):
        for number in person.hold(LEFT_HALF, shift=shift):
            (outline,) = person.editor.cursor.outlines
            assert outline.color == color
            assert len(outline.segments) == number + 1
        assert person.editor.last_input is not None
        camera = person.editor.last_input.camera
        drawn = camera.project(outline.segments[:, 0])
        np.testing.assert_allclose(drawn, camera.project(np.array(LEFT_HALF)), atol=0.01)
        person.frame(LEFT_HALF[-1], "r", shift)
        assert person.editor.cursor is NOTHING


def test_a_click_and_a_cancelled_loop_take_nothing(person: Person) -> None:
    before = state(person.editor.document)
    for shape in ("lasso", "box"):
        person.do(c.SetMarking(shape=shape))
        person.click([5, 4, 0])
        for _ in person.hold(LEFT_HALF):
            pass
        person.do(c.CancelGesture())
        person.frame(LEFT_HALF[-1], "r")
    assert state(person.editor.document) == before
    assert person.editor.history.done == []


def test_a_loop_counts_where_the_deformed_surface_is_seen(ready: Person) -> None:
    ready.stroke([20, 2, 0], [14, 10, 0])
    document, X = ready.editor.document, ready.editor.positions
    ready.use("softness")
    ready.do(c.SetMarking(shape="box", through=True))
    ready.stroke([0, 5, 0], [30, 20, 0])
    soft = document.softness > 0
    assert soft.any()
    assert (document.mesh.vertices[soft, 1] < 5).all()
    np.testing.assert_array_equal(X[soft, 1] > 4, True)


def test_an_unknown_shape_is_refused(person: Person) -> None:
    person.do(c.SetMarking(shape="star"))
    assert person.editor.message is not None
    assert "unknown shape 'star', expected one of brush, lasso" in person.editor.message.text


@pytest.fixture
def figure() -> Person:
    made = Person(load_mesh(DEFAULT_MESH), eye=(0, 0, 3.5))
    made.do(c.SetMarking(shape="limb"))
    made.use("handle")
    return made


def test_a_click_takes_a_limb_and_the_next_one_the_larger(figure: Person) -> None:
    hand, arm = np.array([0.8, 1.425, 0.06]), np.array([0.3, 1.42, 0.05])
    figure.click(hand)
    x = marked(figure, FIRST_HANDLE)[:, 0]
    assert 0.66 < x.min() < 0.76
    figure.click(hand)
    assert 0.40 < marked(figure, FIRST_HANDLE)[:, 0].min() < 0.5
    figure.click(arm)
    assert 0.16 < marked(figure, FIRST_HANDLE)[:, 0].min() < 0.27
    assert len(figure.editor.history.done) == 3
    figure.click(arm, shift=True)
    assert len(marked(figure, FIRST_HANDLE)) == 0


def test_limbs_are_found_once_and_beforehand(
    figure: Person, monkeypatch: pytest.MonkeyPatch
) -> None:
    figure.do(c.FindLimbs())
    monkeypatch.setattr(piece_limbs, "Limbs", None)
    figure.click([0.3, 1.42, 0.05])
    assert len(marked(figure, FIRST_HANDLE)) > 0


def test_where_there_is_no_limb_a_click_says_so_and_does_not_orbit(figure: Person) -> None:
    for _ in figure.hold([[0, 1.1, 0.1], [0.1, 1.2, 0.1]]):
        assert figure.editor.captures
    figure.frame([0.1, 1.2, 0.1], "r")
    assert (figure.editor.document.role == FREE).all()
    assert figure.editor.document.handles == ()
    assert figure.editor.message is not None
    assert "no limb to take here" in figure.editor.message.text
    figure.frame([0.6, 1.7, 0], "pd")
    assert not figure.editor.captures


def test_everything_but_an_arm_is_fixed_in_two_actions(figure: Person) -> None:
    figure.use("fixed")
    figure.click([0.3, 1.42, 0.05])
    figure.do(c.ChangeMarks("invert"))
    document = figure.editor.document
    x = document.mesh.vertices[:, 0]
    assert (document.role[x < 0.15] == FIXED).all()
    assert (document.role[x > 0.3] == FREE).all()
    assert len(figure.editor.history.done) == 2


def test_an_arm_is_a_handle_and_everything_else_fixed_in_three_actions(figure: Person) -> None:
    figure.click([0.3, 1.42, 0.05])
    figure.use("fixed")
    figure.do(c.ChangeMarks("everything else"))
    document = figure.editor.document
    x = document.mesh.vertices[:, 0]
    assert (document.role[x < 0.15] == FIXED).all()
    assert (document.role[x > 0.3] == FIRST_HANDLE).all()
    assert (document.role != FREE).all()
