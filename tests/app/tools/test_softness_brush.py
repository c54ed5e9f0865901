"""The softness brush in each of its modes."""

from __future__ import annotations

import numpy as np
import pytest

from app.editor import commands as c
from app.tools.softness_strokes import SOFTNESS_MODES
from solver import Mesh
from tests.app.person import Person, sheet, state
from tests.app.tools.softness import MIDDLE, at, dirichlet, pins, softness


def test_set_add_and_subtract_are_what_they_say(person: Person) -> None:
    middle = at(person, MIDDLE)
    seen = []
    for mode, value in (("set", 0.5), ("add", 0.3), ("add", 0.9), ("subtract", 0.4), ("set", 0.2)):
        person.do(c.SetBrush(mode=mode, value=value))
        person.stroke(MIDDLE)
        seen.append(softness(person)[middle])
    np.testing.assert_allclose(seen, [0.5, 0.8, 1.0, 0.6, 0.2], atol=1e-6)


@pytest.mark.parametrize("mode", ["set", "add", "subtract"])
def test_rubbing_in_one_place_is_the_same_as_touching_it_once(mode: str) -> None:
    fields = []
    for times in (1, 6):
        person = Person(Mesh.from_arrays(*sheet(30, 20)))
        person.use("softness", 6)
        person.do(c.SetBrush(value=0.5))
        person.stroke([12, 10, 0], [18, 10, 0])
        person.do(c.SetBrush(mode=mode, value=0.3, strength=0.7))
        before = softness(person)
        person.stroke(*[MIDDLE] * times)
        assert not np.array_equal(softness(person), before)
        fields.append(softness(person))
    np.testing.assert_array_equal(fields[0], fields[1])


@pytest.mark.parametrize("mode", ["set", "add"])
def test_the_rim_of_a_stroke_has_no_crease(mode: str) -> None:
    """On a fine sheet both the value and its slope go to zero at the rim, and nowhere jump."""
    V, F = sheet(120, 80)
    person = Person(Mesh.from_arrays(V, F), eye=(0, 0, 240))
    person.use("softness", 20)
    person.do(c.SetBrush(mode=mode))
    person.stroke([60, 40, 0])
    row = softness(person)[V[:, 1] == 40]
    slope = np.diff(row)
    assert row.max() > 0.99
    assert row[40] < 1e-3  # at the rim
    assert np.abs(slope).max() < 0.09
    assert np.abs(np.diff(slope)).max() < 0.02


def test_smoothing_strokes_stay_within_bounds_and_lower_the_energy(person: Person) -> None:
    document = person.editor.document
    random = np.random.default_rng(1).uniform(0.2, 0.9, len(document.softness))
    with person.editor.edit("noise") as gesture:
        gesture.change("softness", random, np.arange(len(random)))
    person.do(c.SetBrush(mode="smooth"))
    energies = [dirichlet(person)]
    for _ in range(4):
        person.stroke(MIDDLE)
        energies.append(dirichlet(person))
    assert (np.diff(energies) < 0).all()
    changed = np.flatnonzero(document.softness != random)
    assert document.softness.min() >= random.min()
    assert document.softness.max() <= random.max()
    away = np.linalg.norm(document.mesh.vertices[changed] - MIDDLE, axis=1)
    assert away.max() < 4.001
    assert np.std(document.softness[changed]) < 0.5 * np.std(random[changed])


def test_a_finer_mesh_takes_no_more_strokes_to_become_smooth() -> None:
    left = []
    for fineness in (1, 3):
        V, F = sheet(30 * fineness, 20 * fineness)
        person = Person(Mesh.from_arrays(V / fineness, F))
        person.use("softness", 5.05)  # at 5, vertices lie exactly on the rim
        step = np.flatnonzero(person.editor.document.mesh.vertices[:, 0] < 15)
        with person.editor.edit("step") as gesture:
            gesture.change("softness", 1.0, step)
        person.do(c.SetBrush(mode="smooth"))
        person.stroke(MIDDLE)
        left.append(softness(person)[at(person, [13, 10, 0])])
    assert left[0] < 0.97
    assert left[1] == pytest.approx(left[0], abs=0.06)


def test_isolated_vertices_and_quick_clicks_do_no_harm() -> None:
    V, F = sheet(4, 4)
    person = Person(Mesh.from_arrays(np.vstack([V, [[2.0, 2.2, 0.1]]]), F))
    person.use("softness", 3)
    for mode in SOFTNESS_MODES:
        person.do(c.SetBrush(mode=mode))
        person.stroke([2, 2, 0])
        assert np.isfinite(person.editor.document.softness).all()


def test_a_brush_has_one_of_the_modes(person: Person) -> None:
    person.do(c.SetBrush(mode="scrub", value=0.1))
    assert person.editor.message is not None
    assert "unknown brush mode 'scrub', expected one of set, add" in person.editor.message.text
    assert person.editor.brush.mode == "set"
    assert person.editor.brush.value == 1.0


def test_undo_takes_back_all_that_was_painted(person: Person) -> None:
    states = [state(person.editor.document)]
    for mode in SOFTNESS_MODES:
        person.do(c.SetBrush(mode=mode, value=0.8))
        person.stroke([10, 10, 0], [18, 12, 0])
        states.append(state(person.editor.document))
    person.stroke([14, 10, 0], shift=True)
    person.do(c.ClearSoftness())
    assert not softness(person).any()
    assert not len(pins(person))
    person.do(c.Undo(), c.Undo())
    for expected in reversed(states):
        assert state(person.editor.document) == expected
        person.do(c.Undo())
