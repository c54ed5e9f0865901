"""A double click takes a part, another one its group."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from app.editor import commands as c
from app.model.handles import FIXED, FREE
from solver import load_mesh
from tests.app.person import Person, error_of, sheet, state

# Three squares side by side: the first two are one object of the file.
PLACES = ([1.3, 1.2, 0.0], [5.3, 1.2, 0.0], [9.3, 1.2, 0.0])


@pytest.fixture
def person(tmp_path: Path) -> Person:
    V, F = sheet(3, 3)
    lines = []
    for number, name in enumerate(("o pair", "", "o single")):
        lines += [name, *(f"v {x + 4 * number} {y} {z}" for x, y, z in V)]
        corners = F + 1 + number * len(V)
        lines += [f"f {a} {b} {c}" for a, b, c in corners]
    path = tmp_path / "squares.obj"
    path.write_text("\n".join(lines) + "\n")
    made = Person(load_mesh(path), path, eye=(0, 0, 20))
    made.use("fixed", 0.6)
    return made


def taken(person: Person, role: int = FIXED) -> list[int]:
    """The numbers of the squares that have a role, whole; any other is untouched."""
    roles = person.editor.document.role.reshape(3, -1) == role
    assert (roles.all(axis=1) == roles.any(axis=1)).all()
    return np.flatnonzero(roles.all(axis=1)).tolist()


def test_two_clicks_take_the_part_as_one_entry_and_leave_no_dab(person: Person) -> None:
    person.click(PLACES[0], 2)
    assert taken(person) == [0]
    assert len(person.editor.history.done) == 1
    person.do(c.Undo())
    assert (person.editor.document.role == FREE).all()
    assert person.editor.history.undone


def test_four_clicks_or_two_on_a_part_that_is_taken_take_the_group(person: Person) -> None:
    person.click(PLACES[0], 4)
    assert taken(person) == [0, 1]
    person.click(PLACES[2], 2)
    person.click(PLACES[2], 2)
    assert taken(person) == [0, 1, 2]
    person.do(c.Undo(), c.Undo(), c.Undo())
    person.click(PLACES[1], 2)
    person.click(PLACES[1], 2)
    assert taken(person) == [0, 1]


def test_shift_gives_back_the_part_and_then_the_group(person: Person) -> None:
    person.click(PLACES[0], 4)
    person.click(PLACES[2], 2)
    person.click(PLACES[0], 2, shift=True)
    assert taken(person) == [1, 2]
    person.click(PLACES[0], 2, shift=True)
    assert taken(person) == [2]


def test_the_dab_of_the_first_click_takes_nothing_from_another_region(person: Person) -> None:
    person.click(PLACES[1], 2)
    person.use("handle")
    person.click(PLACES[1], 1)
    person.do(c.Undo())
    person.click(PLACES[0], 2)
    assert taken(person) == [1]
    assert taken(person, person.editor.document.handles[0].key) == [0]
    assert [handle.name for handle in person.editor.document.handles] == ["handle 1"]
    assert len(person.editor.history.done) == 2


@pytest.mark.parametrize("shape", ["brush", "lasso", "box", "limb"])
def test_a_double_click_is_one_whatever_a_press_marks_with(person: Person, shape: str) -> None:
    person.do(c.SetMarking(shape=shape))
    person.click(PLACES[2], 2)
    assert taken(person) == [2]


def test_the_softness_brush_sets_a_whole_part_and_pins_it(person: Person) -> None:
    person.use("softness")
    person.do(c.SetBrush(mode="add", value=0.3))
    person.click(PLACES[1], 2)
    document = person.editor.document
    middle = np.repeat([False, True, False], len(document.softness) // 3)
    np.testing.assert_allclose(document.softness, np.where(middle, 0.3, 0.0))
    np.testing.assert_array_equal(document.pinned, document.softness > 0)


def test_what_was_done_before_a_double_click_stays(person: Person) -> None:
    person.stroke(PLACES[2])
    before = state(person.editor.document)
    person.click(PLACES[0], 2)
    person.do(c.Undo())
    assert state(person.editor.document) == before
    person.click(PLACES[0])
    person.do(c.Undo())
    person.frame(PLACES[0], "pd", clicks=2)
    person.frame(PLACES[0], "r")
    assert len(person.editor.history.done) == 2
    person.do(c.Undo())
    assert state(person.editor.document) == before


def test_a_hidden_part_of_a_group_stays_as_it_is(person: Person) -> None:
    person.do(c.ShowPart(1, False))
    person.click(PLACES[0], 4)
    assert taken(person) == [0]


def test_a_double_click_beside_the_surface_is_left_to_the_camera(person: Person) -> None:
    person.click([-4, 1, 0], 2)
    assert (person.editor.document.role == FREE).all()
    person.do(c.ShowPart(7, True))
    assert "no piece 7" in error_of(person)


def test_a_press_that_marked_nothing_is_no_first_click(person: Person) -> None:
    """What was made before it stays."""
    for place in PLACES[:2]:
        person.stroke(place)
    before = person.editor.document.role.copy()
    person.frame(PLACES[2], "pd", alt=True)
    person.frame(PLACES[2], "r", alt=True)
    person.frame(PLACES[2], "pd", clicks=2)
    person.frame(PLACES[2], "r", clicks=2)
    kept = before == FIXED
    assert (person.editor.document.role[kept] == FIXED).all()
    assert len(person.editor.history.done) == 3


def test_two_clicks_beside_a_pin_make_one_handle_of_the_part(person: Person) -> None:
    """The first click made a handle, which is taken back: the part is not another's."""
    person.use("handle", 0.6)
    person.stroke(PLACES[0])
    pin = person.editor.document.new_handle(pin=True)
    person.editor.document.change("handles", (*person.editor.document.handles, pin))
    person.editor.document.change("role", pin.key, np.array([20]))
    person.editor.chosen.activate(pin.key)
    first = person.editor.document.handles[0].key
    count = (person.editor.document.role == first).sum()
    person.click(PLACES[2], 2)
    assert (person.editor.document.role == first).sum() == count
    assert taken(person, person.editor.document.handles[-1].key) == [2]
    assert len(person.editor.document.handles) == 3
