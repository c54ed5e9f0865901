from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from app.editor import commands as c
from app.tools.softness_strokes import SOFTNESS_MODES
from solver import Material
from tests.app.person import Person, slab, state

Random = np.random.Generator


def spot(random: Random) -> list[float]:
    return [float(random.uniform(0, 20)), float(random.uniform(0, 4)), 0.0]


def paint(tool: str) -> Callable[[Person, Random], None]:
    def act(person: Person, random: Random) -> None:
        person.use(tool, float(random.uniform(0.5, 2.5)))
        points = [spot(random) for _ in range(random.integers(1, 4))]
        person.stroke(*points, shift=bool(random.random() < 0.25))

    return act


def drag(person: Person, random: Random) -> None:
    person.editor.settle()
    person.use("drag")
    document = person.editor.document
    handle = np.flatnonzero(document.role >= 2)
    start = person.editor.positions[random.choice(handle)] if len(handle) else spot(random)
    person.stroke(start, start + random.normal(size=3))


def ask(make: Callable[[Person, Random], c.Command | None]) -> Callable[[Person, Random], None]:
    def act(person: Person, random: Random) -> None:
        command = make(person, random)
        if command is not None:
            person.do(command)

    return act


def some_key(person: Person, random: Random) -> int | None:
    handles = person.editor.document.handles
    return handles[random.integers(len(handles))].key if handles else None


def of_some_handle(make: Callable[[int], c.Command]) -> Callable[[Person, Random], None]:
    def command(person: Person, random: Random) -> c.Command | None:
        key = some_key(person, random)
        return None if key is None else make(key)

    return ask(command)


ACTS = [
    paint("fixed"),
    paint("handle"),
    paint("handle"),
    paint("softness"),
    drag,
    drag,
    ask(lambda p, r: c.AddHandle()),
    of_some_handle(c.RemoveHandle),
    of_some_handle(c.ClearHandle),
    of_some_handle(c.ActivateHandle),
    of_some_handle(c.SelectHandle),
    of_some_handle(c.ResetHandle),
    of_some_handle(lambda key: c.SetPosition(key % 3, float(key))),
    of_some_handle(lambda key: c.SetRotation(0, (10.0 * key, 5.0, 0.0))),
    of_some_handle(lambda key: c.RenameHandle(key, f"name {key}")),
    ask(lambda p, r: c.ClearFixed()),
    ask(lambda p, r: c.ClearSoftness()),
    ask(lambda p, r: c.SetBrush(mode=str(r.choice(list(SOFTNESS_MODES))))),
    ask(lambda p, r: c.FillSoftness()),
    ask(lambda p, r: c.SmoothSoftness()),
    ask(lambda p, r: c.ClearPins()),
    ask(lambda p, r: c.ResetPose()),
    ask(lambda p, r: c.SetMaterial(str(r.choice(["hinge", "clay", "paper"])))),
    ask(lambda p, r: c.SetMaterial(Material(float(r.uniform(0.1, 2)), 1.0))),
    ask(lambda p, r: c.SetSetting("bending_length", float(r.uniform(0.005, 0.05)))),
    ask(lambda p, r: c.SetSetting("orientation", bool(r.random() < 0.5))),
    ask(lambda p, r: c.SetSetting("rigid", int(r.integers(2)))),
]


@pytest.mark.parametrize("seed", range(6))
def test_undo_and_redo_restore_the_exact_document(seed: int) -> None:
    random = np.random.default_rng(seed)
    person = Person(slab(20, 4, 2.0))
    editor = person.editor
    states = [state(editor.document)]
    for _ in range(35):
        ACTS[random.integers(len(ACTS))](person, random)
        # A slide of a slider ends when the mouse is let go.
        person.frame(None, "r")
        entries = len(editor.history.done)
        assert entries in (len(states) - 1, len(states))
        if entries == len(states):
            states.append(state(editor.document))
        else:
            assert state(editor.document) == states[-1]
    assert len(states) > 8
    for expected in reversed(states[:-1]):
        person.do(c.Undo())
        assert state(editor.document) == expected
    for expected in states[1:]:
        person.do(c.Redo())
        assert state(editor.document) == expected
    editor.close()


def test_removing_the_first_of_three_handles_and_undoing_restores_all() -> None:
    person = Person(slab(20, 4, 2.0))
    person.use("handle", 1.0)
    for x in (4, 10, 16):
        person.do(c.AddHandle(f"at {x}"))
        person.stroke([x, 2, 0])
    document = person.editor.document
    before, keys = state(document), [h.key for h in document.handles]
    at_16 = document.vertices_of(keys[2])
    person.do(c.RemoveHandle(keys[0]))
    np.testing.assert_array_equal(document.vertices_of(keys[2]), at_16)
    person.do(c.Undo())
    assert state(document) == before
    person.editor.close()


def test_a_new_gesture_clears_redo(bar: Person) -> None:
    bar.use("fixed", 1)
    bar.stroke([5, 2, 0])
    bar.do(c.Undo())
    assert bar.editor.history.undone
    bar.stroke([8, 2, 0])
    assert not bar.editor.history.undone
    bar.do(c.Redo())
    assert bar.editor.message is not None
    assert bar.editor.message.text == "Nothing to redo"


def test_gestures_that_change_nothing_are_not_recorded(bar: Person) -> None:
    bar.use("fixed", 1)
    bar.stroke([5, 2, 0])
    bar.stroke([5, 2, 0])
    bar.stroke([15, 2, 0], shift=True)
    bar.do(c.ResetPose(), c.ClearSoftness(), c.SetMaterial("hinge"), c.SetSetting("rigid", 1))
    assert [entry.label for entry in bar.editor.history.done] == ["Paint fixed"]


def test_sliding_a_slider_is_one_entry_and_the_next_slide_another(bar: Person) -> None:
    history = bar.editor.history
    for value in (0.011, 0.012, 0.013):
        bar.do(c.SetSetting("bending_length", value))
    assert len(history.done) == 1
    bar.frame(None, "r")
    for value in (0.014, 0.015):
        bar.do(c.SetSetting("bending_length", value))
    assert len(history.done) == 2
    bar.do(c.Undo())
    assert bar.editor.document.bending_length == 0.013
    bar.do(c.Undo())
    assert bar.editor.document.bending_length == 0.01


def test_a_slider_back_where_it_started_leaves_no_entry(bar: Person) -> None:
    for value in (0.02, 0.03, 0.01):
        bar.do(c.SetSetting("bending_length", value))
    assert not bar.editor.history.done
    assert not bar.editor.dirty


def test_sliders_of_different_settings_do_not_merge(bar: Person) -> None:
    bar.do(c.SetSetting("bending_length", 0.02), c.SetSetting("orientation", False))
    assert len(bar.editor.history.done) == 2


def test_an_unknown_field_is_refused(bar: Person) -> None:
    with pytest.raises(KeyError, match="no undoable field 'mesh'"):
        bar.editor.document.change("mesh", None)
    assert bar.editor.document.find(77) is None
