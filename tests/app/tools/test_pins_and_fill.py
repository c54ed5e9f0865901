"""Pins, the fill between them, and what is done to the whole softness at once."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from app.editor import commands as c
from app.model.handles import FIXED
from app.model.session.reading import read_session, to_document
from app.model.session.writing import write_session
from solver import Mesh
from solver.geometry.laplacian import cotangent_laplacian
from tests.app.person import Person, sheet, state
from tests.app.tools.softness import MIDDLE, at, dab, dirichlet, pins, softness


def test_a_dab_pins_its_middle_and_shift_takes_pins_away(person: Person) -> None:
    dab(person, 1.0, MIDDLE)
    away = np.linalg.norm(person.editor.document.mesh.vertices[pins(person)] - MIDDLE, axis=1)
    assert 0 in away
    assert 1 <= away.max() < 4 * 0.6
    assert softness(person)[pins(person)].min() >= 0.5
    person.use("softness", 1.2)
    person.stroke(MIDDLE, shift=True)
    assert at(person, MIDDLE) not in pins(person)
    assert len(pins(person))
    person.do(c.ClearPins())
    assert not len(pins(person))
    assert softness(person).any()


def test_smoothing_pins_nothing(person: Person) -> None:
    dab(person, 1.0, MIDDLE)
    before = pins(person)
    person.do(c.SetBrush(mode="smooth"))
    person.stroke([12, 10, 0], [22, 10, 0])
    np.testing.assert_array_equal(pins(person), before)


def test_a_fill_keeps_the_pins_and_lies_between_them(person: Person) -> None:
    dab(person, 0.9, [5, 10, 0])
    dab(person, 0.0, [25, 10, 0], [15, 3, 0])
    kept, painted = pins(person), softness(person)
    person.do(c.FillSoftness())
    filled = softness(person)
    np.testing.assert_allclose(filled[kept], painted[kept], atol=1e-12)
    assert filled.min() >= painted[kept].min()
    assert filled.max() <= painted[kept].max()
    mesh = person.editor.document.mesh
    x, y, _ = mesh.vertices.T
    among = np.flatnonzero((x > 4) & (x < 26) & (y > 2) & (y < 11))
    free = np.setdiff1d(among, kept)
    residual = (cotangent_laplacian(mesh.vertices, mesh.faces) @ filled)[free]
    np.testing.assert_allclose(residual, 0, atol=1e-9)
    row = [filled[at(person, [x, 10.0, 0.0])] for x in range(6, 24)]
    assert (np.diff(row) < 0).all()


def test_pins_stay_editable_and_a_second_fill_follows_them(person: Person) -> None:
    dab(person, 1.0, [5, 10, 0])
    dab(person, 0.0, [25, 10, 0])
    person.do(c.FillSoftness())
    first = softness(person)[at(person, MIDDLE)]
    dab(person, 1.0, [25, 10, 0])
    person.do(c.FillSoftness())
    assert softness(person)[at(person, MIDDLE)] > first + 0.2
    person.use("softness", 9)
    person.stroke([25, 10, 0], shift=True)
    assert at(person, [25, 10, 0]) not in pins(person)
    person.do(c.FillSoftness())
    assert softness(person)[at(person, [25, 10, 0])] < 0.2, "nothing asks for it any more"
    assert softness(person)[at(person, [8, 10, 0])] > 0.5


def test_a_fill_leaves_what_is_held_and_what_lies_behind_it(person: Person) -> None:
    """A row of fixed vertices across the sheet at x = 12, dabs on its left."""
    fixed = np.flatnonzero(np.isin(person.editor.document.mesh.vertices[:, 0], (12, 13)))
    with person.editor.edit("Fix a row") as gesture:
        gesture.change("role", FIXED, fixed)
    dab(person, 1.0, [3, 10, 0])
    dab(person, 0.5, [9, 10, 0])
    x, before = person.editor.document.mesh.vertices[:, 0], softness(person)
    person.do(c.FillSoftness())
    np.testing.assert_array_equal(softness(person)[x >= 12], before[x >= 12])
    assert softness(person)[at(person, [6, 10, 0])] > 0.4


def test_a_component_without_pins_keeps_its_softness() -> None:
    V, F = sheet(10, 10)
    mesh = Mesh.from_arrays(np.vstack([V, V + [20, 0, 0]]), np.vstack([F, F + len(V)]))
    person = Person(mesh)
    person.use("softness", 3)
    dab(person, 0.6, [25, 5, 0])
    person.do(c.ClearPins())
    other = softness(person)[len(V) :]
    dab(person, 0.8, [5, 5, 0])
    person.do(c.FillSoftness())
    np.testing.assert_array_equal(softness(person)[len(V) :], other)
    assert softness(person)[: len(V)].max() > 0.7


def test_there_must_be_something_to_fill_from(person: Person) -> None:
    person.do(c.FillSoftness())
    assert person.editor.message is not None
    assert "dab a few soft and a few stiff spots first" in person.editor.message.text
    assert not person.editor.history.done


@pytest.mark.parametrize("command", [c.FillSoftness(), c.SmoothSoftness(), c.ClearPins()])
def test_undo_and_redo_are_exact(person: Person, command: c.Command) -> None:
    dab(person, 0.9, [5, 10, 0])
    dab(person, 0.0, [25, 10, 0])
    before = state(person.editor.document)
    person.do(command)
    after = state(person.editor.document)
    assert after != before
    person.do(c.Undo())
    assert state(person.editor.document) == before
    person.do(c.Redo())
    assert state(person.editor.document) == after


def test_a_session_holds_the_filled_softness_but_no_pins(person: Person, tmp_path: Path) -> None:
    dab(person, 0.9, [5, 10, 0])
    dab(person, 0.0, [25, 10, 0])
    person.do(c.FillSoftness())
    document = person.editor.document
    write_session(tmp_path / "s.json", document)
    again = to_document(read_session(tmp_path / "s.json"), document.mesh, document.path)
    np.testing.assert_array_equal(again.softness, document.softness)
    assert not again.pinned.any()


def test_smoothing_the_whole_field_keeps_bounds_and_lowers_the_energy(person: Person) -> None:
    dab(person, 0.9, [5, 10, 0], [20, 5, 0])
    before, energy = softness(person), dirichlet(person)
    person.do(c.SmoothSoftness())
    assert before.min() <= softness(person).min()
    assert softness(person).max() <= before.max()
    assert dirichlet(person) < energy
