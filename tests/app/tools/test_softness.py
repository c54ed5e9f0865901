"""The softness brush in its modes, pins, fill and smoothing, and what a person is warned of."""

from __future__ import annotations

import dataclasses
from pathlib import Path

import numpy as np
import pytest

from app.bundled import DEFAULT_SESSION
from app.editor import commands as c
from app.editor.editor import Editor
from app.editor.file_actions import load_document
from app.model.handles import FIXED
from app.model.session import read_session, to_document, write_session
from app.tools.softness_strokes import SOFTNESS_MODES
from app.worker.inline import InlineWorker
from app.workspace.softness_warnings import STEEP, WEAK
from solver import Material, Mesh
from solver.geometry.laplacian import cotangent_laplacian
from solver.types import FloatArray, IntArray
from tests.app.person import Person, sheet, slab, state

MIDDLE = [15.0, 10.0, 0.0]


@pytest.fixture
def person() -> Person:
    """A sheet of 30 x 20 and the softness brush with a radius of 4."""
    made = Person(Mesh.from_arrays(*sheet(30, 20)))
    made.use("softness", 4)
    return made


def softness(person: Person) -> FloatArray:
    return person.editor.document.softness.copy()


def at(person: Person, point: list[float]) -> int:
    away = person.editor.document.mesh.vertices - point
    return int(np.linalg.norm(away, axis=1).argmin())


def pins(person: Person) -> IntArray:
    return np.flatnonzero(person.editor.document.pinned)


def dirichlet(person: Person) -> float:
    mesh, s = person.editor.document.mesh, person.editor.document.softness
    return float(s @ (cotangent_laplacian(mesh.vertices, mesh.faces) @ s))


# Modes


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


# Pins and fill


def dab(person: Person, value: float, *points: list[float]) -> None:
    person.do(c.SetBrush(mode="set", value=value))
    for point in points:
        person.stroke(point)


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
    free = np.setdiff1d(np.arange(len(filled)), kept)
    mesh = person.editor.document.mesh
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
    np.testing.assert_allclose(softness(person)[at(person, [25, 10, 0])], 0.8, atol=0.2)


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
    assert softness(person)[: len(V)].min() >= 0.4


def test_there_must_be_something_to_fill_from(person: Person) -> None:
    person.do(c.FillSoftness())
    assert person.editor.message is not None
    assert "dab a few soft and a few stiff spots first" in person.editor.message.text
    assert not person.editor.history.done


def test_a_brush_has_one_of_the_modes(person: Person) -> None:
    person.do(c.SetBrush(mode="scrub", value=0.1))
    assert person.editor.message is not None
    assert "unknown brush mode 'scrub', expected one of set, add" in person.editor.message.text
    assert person.editor.brush.mode == "set"
    assert person.editor.brush.value == 1.0


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


# Warnings


def default_editor() -> Editor:
    return Editor(load_document(None, DEFAULT_SESSION), InlineWorker(), DEFAULT_SESSION)


def test_the_default_session_and_a_stroke_of_the_default_brush_are_fine() -> None:
    editor = default_editor()
    assert not editor.warnings
    person = Person(editor.document.mesh, eye=(0, 0, 6))
    person.use("softness")
    person.stroke([0.3, 1.42, 0.0], [0.5, 1.42, 0.0])
    assert person.editor.document.softness.max() > 0.9
    assert not person.editor.warnings


def test_a_step_warns_of_a_crease_and_one_click_mends_it() -> None:
    editor = default_editor()
    x = editor.document.mesh.vertices[:, 0]
    with editor.edit("step") as gesture:
        gesture.change("softness", (np.abs(x - 0.465) < 0.1).astype(float), np.arange(len(x)))
    assert list(editor.warnings) == [STEEP]
    editor.execute(c.SmoothSoftness())
    assert not editor.warnings
    editor.execute(c.Undo())
    assert list(editor.warnings) == [STEEP]


def test_a_material_that_gives_way_warns_of_tearing() -> None:
    editor = default_editor()
    for stretching, expected in ((0.1, []), (0.01, [WEAK]), (1.0, [])):
        editor.execute(c.SetMaterial(Material(1.0, stretching)))
        assert list(editor.warnings) == expected


def test_what_cannot_bend_is_not_warned_of() -> None:
    person = Person(slab(20, 4, 2.0))
    with person.editor.edit("fix all") as gesture:
        gesture.change("role", FIXED, np.arange(len(person.editor.document.role)))
    person.use("softness", 0.5)
    person.stroke([10, 2, 0])
    assert not person.editor.warnings
    person.do(c.ClearFixed())
    assert list(person.editor.warnings) == [STEEP]


# Sliding


def test_every_bind_of_a_slide_is_shown_and_the_slide_is_one_entry(ready: Person) -> None:
    ready.use("softness", 3)
    ready.stroke([10, 2, 0])
    ready.use("drag")
    ready.stroke([19, 2, 0], [12, 8, 0])
    ready.editor.settle()
    entries, shown = len(ready.editor.history.done), ready.editor.positions
    for gain in np.geomspace(0.08, 0.01, 5):
        ready.frame(None, "d")
        ready.do(c.SetMaterial(Material(float(gain), 1.0)))
        assert np.abs(ready.editor.positions - shown).max() > 1e-5
        shown = ready.editor.positions
    ready.frame(None, "r")
    assert len(ready.editor.history.done) == entries + 1


def test_a_bind_comes_with_the_pose_that_was_asked_for(ready: Person) -> None:
    ready.stroke([19, 2, 0], [12, 8, 0])
    ready.do(c.SetSetting("bending_length", 0.03))
    bound = ready.editor.surface.bound
    assert bound is not None
    assert bound.pose is not None
    assert ready.editor.positions is bound.pose.positions
    ready.do(c.ResetPose(), c.SetSetting("bending_length", 0.02))
    bound = ready.editor.surface.bound
    assert bound is not None
    assert bound.pose is None
    assert dataclasses.is_dataclass(bound)
