"""Commands that change what is marked."""

from __future__ import annotations

import numpy as np
import pytest

from app.editor import commands as c
from app.editor.actions.marks import CHANGES
from app.model.handles import FIRST_HANDLE, FIXED, FREE
from solver import Mesh
from solver.types import BoolArray
from tests.app.person import Person, error_of, sheet, state


@pytest.fixture
def person() -> Person:
    """A sheet with a fixed disc in the middle, and a handle that touches it."""
    made = Person(Mesh.from_arrays(*sheet(30, 20)), eye=(0, 0, 40))
    made.use("handle", 3.2)
    made.stroke([21, 10, 0])
    made.use("fixed", 3.2)
    made.stroke([15, 10, 0])
    return made


def has(person: Person, role: int) -> BoolArray:
    return np.asarray(person.editor.document.role == role)


def test_growing_takes_a_ring_of_what_is_free_and_shrinking_gives_it_back(person: Person) -> None:
    document = person.editor.document
    fixed, handle = has(person, FIXED), has(person, FIRST_HANDLE)
    a, b = person.editor.neighbours.edges.T
    ring = np.zeros_like(fixed)
    ring[a[fixed[b]]] = ring[b[fixed[a]]] = True
    assert (ring & handle).any()
    person.do(c.ChangeMarks("grow"))
    np.testing.assert_array_equal(has(person, FIXED), fixed | (ring & ~handle))
    np.testing.assert_array_equal(has(person, FIRST_HANDLE), handle)
    person.do(c.Undo(), c.ChangeMarks("shrink"))
    inner = fixed.copy()
    inner[a[~fixed[b]]] = inner[b[~fixed[a]]] = False
    np.testing.assert_array_equal(has(person, FIXED), inner)
    assert len(document.role) == len(inner)


def test_invert_and_everything_else_take_what_is_free(person: Person) -> None:
    fixed, handle = has(person, FIXED), has(person, FIRST_HANDLE)
    person.do(c.ChangeMarks("invert"))
    np.testing.assert_array_equal(has(person, FIXED), ~fixed & ~handle)
    np.testing.assert_array_equal(has(person, FREE), fixed)
    np.testing.assert_array_equal(has(person, FIRST_HANDLE), handle)
    person.do(c.Undo())
    person.use("handle")
    person.do(c.ChangeMarks("everything else"))
    np.testing.assert_array_equal(has(person, FIXED), fixed)
    np.testing.assert_array_equal(has(person, FIRST_HANDLE), ~fixed)


def test_clear_and_smooth_leave_other_regions_alone(person: Person) -> None:
    fixed, handle = has(person, FIXED), has(person, FIRST_HANDLE)
    person.use("fixed", 1.1)
    person.stroke([15, 14, 0])
    ragged = has(person, FIXED).sum()
    person.do(c.ChangeMarks("smooth"))
    assert abs(has(person, FIXED).sum() - ragged) <= 3
    assert not has(person, FIXED)[np.flatnonzero(handle)].any()
    person.do(c.ChangeMarks("clear"))
    assert not has(person, FIXED).any()
    np.testing.assert_array_equal(has(person, FIRST_HANDLE), handle)
    assert fixed.any()


def test_only_the_active_handle_is_changed(person: Person) -> None:
    first = has(person, FIRST_HANDLE)
    person.use("handle", 2)
    person.do(c.AddHandle("other"))
    person.stroke([6, 10, 0])
    person.do(c.ChangeMarks("clear"))
    assert not has(person, FIRST_HANDLE + 1).any()
    np.testing.assert_array_equal(has(person, FIRST_HANDLE), first)


def test_softness_is_marked_as_a_stroke_would(person: Person) -> None:
    document = person.editor.document
    person.use("softness", 3.2)
    person.do(c.SetBrush(value=0.5))
    person.stroke([8, 10, 0])
    before = document.softness.copy()
    person.do(c.ChangeMarks("grow"))
    ring = (document.softness > 0) & (before == 0)
    assert ring.any()
    np.testing.assert_array_equal(document.softness[ring], 0.5)
    assert document.pinned[ring].all()
    np.testing.assert_array_equal(document.softness[before > 0], before[before > 0])
    person.do(c.ChangeMarks("clear"))
    assert not document.softness.any()
    assert not document.pinned.any()


@pytest.mark.parametrize("name", list(CHANGES))
def test_each_is_one_entry_and_undone_as_one(person: Person, name: str) -> None:
    before, entries = state(person.editor.document), len(person.editor.history.done)
    person.do(c.ChangeMarks(name))
    assert len(person.editor.history.done) - entries == (state(person.editor.document) != before)
    person.do(*[c.Undo()] * (len(person.editor.history.done) - entries))
    assert state(person.editor.document) == before


def test_hidden_parts_stay_as_they_are() -> None:
    V, F = sheet(6, 6)
    mesh = Mesh.from_arrays(np.vstack([V, V + [8, 0, 0]]), np.vstack([F, F + len(V)]))
    person = Person(mesh)
    person.use("fixed")
    person.do(c.ShowPart(1, False), c.ChangeMarks("invert"))
    np.testing.assert_array_equal(has(person, FIXED), np.arange(len(mesh.vertices)) < len(V))
    person.do(c.ShowPart(1, True), c.ShowPart(0, False), c.ChangeMarks("invert"))
    assert has(person, FIXED).all()
    person.do(c.ChangeMarks("clear"))
    np.testing.assert_array_equal(has(person, FIXED), np.arange(len(mesh.vertices)) < len(V))


def test_nothing_marked_leaves_no_handle_behind() -> None:
    person = Person(Mesh.from_arrays(*sheet(4, 4)))
    person.use("handle")
    person.do(c.ChangeMarks("grow"), c.ChangeMarks("shrink"), c.ChangeMarks("clear"))
    assert person.editor.document.handles == ()
    assert person.editor.history.done == []


def test_what_cannot_be_done_is_said(person: Person) -> None:
    person.do(c.ChangeMarks("explode"))
    assert "unknown change 'explode'" in error_of(person)
    person.do(c.SetTool("drag"), c.ChangeMarks("grow"))
    assert "the tool Drag marks nothing" in error_of(person)
