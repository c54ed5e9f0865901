"""What is let go of before the solver's bind has come: it is kept, and the surface follows."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from app.editor import commands as c
from app.worker.requests import Failure, Request, WorkerError
from solver import load_mesh
from tests.app.inline import InlineWorker
from tests.app.person import Person, error_of, slab, state, transforms
from tests.app.tools.dragging import FakeWorker, check_constraints, with_fake
from tests.app.tools.gizmo.hand import type_in

FOLLOWS = "The solver is still binding: the surface follows when it is done"
Act = Callable[[Person], None]


def begun(late: bool) -> tuple[Person, FakeWorker]:
    """A bar with its left end fixed and its right end painted, whose bind waits if it is late."""
    person = Person(slab(20, 4, 2.0))
    fake = with_fake(person)
    person.use("fixed", 1.6)
    person.stroke([0, 0, 0], [0, 4, 0])
    fake.late = late
    person.use("handle", 1.6)
    person.stroke([20, 0, 0], [20, 4, 0])
    person.use("drag", 1.6)
    person.do(c.SetPlacing(gizmo=False))
    return person, fake


def drag(person: Person) -> None:
    person.stroke([19, 2, 0], [18, 5, 0], [16, 8, 0])


def turn(person: Person) -> None:
    person.do(c.SetPlacing(pivot="free"), c.TurnHandles())
    type_in(person, "z70\n")


def type_a_rotation(person: Person) -> None:
    person.do(c.SetPlacing(pivot="free"), c.SetRotation(2, (0.0, 0.0, 70.0)))


def move(person: Person) -> None:
    person.do(c.MoveHandles())
    type_in(person, "y3\n")


def pin(person: Person) -> None:
    person.do(c.SetKeep(True))
    person.stroke([10, 2, 0], [10, 3, 0], [10, 5, 0])


def message(person: Person) -> str:
    assert person.editor.message is not None
    return person.editor.message.text


@pytest.mark.parametrize(
    ("act", "turns"),
    [
        *((act, turns) for act in (drag, turn, type_a_rotation, move) for turns in (True, False)),
        (pin, False),  # one that turns does so as a pin, a grab that is held as what is held softly
    ],
)
def test_it_ends_where_it_would_have_with_the_bind_there(act: Act, turns: bool) -> None:
    (slow, fake), (quick, _) = begun(late=True), begun(late=False)
    for person in (slow, quick):
        person.do(c.SetTurn(turns))
        act(person)
    assert message(slow) == FOLLOWS
    assert not np.array_equal(transforms(slow.editor.document)[-1], np.eye(4)), "it is kept"
    rest = slow.editor.document.mesh.vertices
    np.testing.assert_array_equal(slow.editor.positions, rest)
    fake.late = False
    for person in (slow, quick):
        person.editor.settle()
    check_constraints(slow)
    for one, other in zip(
        transforms(slow.editor.document), transforms(quick.editor.document), strict=True
    ):
        np.testing.assert_allclose(one, other, atol=1e-9)
    np.testing.assert_allclose(slow.editor.positions, quick.editor.positions, atol=1e-6)
    histories = [[entry.label for entry in p.editor.history.done] for p in (slow, quick)]
    assert histories[0] == histories[1]


def test_it_is_one_step_of_undo() -> None:
    person, fake = begun(late=True)
    document = person.editor.document
    before = state(document)
    drag(person)
    early = state(document)
    fake.late = False
    person.editor.settle()
    after = state(document)
    assert after != early
    person.do(c.Undo())
    assert state(document) == before
    person.do(c.Redo())
    assert state(document) == after


def test_a_bind_that_comes_during_the_drag_turns_the_handle_from_then_on() -> None:
    person, fake = begun(late=True)
    for number in person.hold([[19, 2, 0], [16, 8, 0], [16, 8, 0], [16, 8, 0]]):
        R = transforms(person.editor.document)[0][:3, :3]
        if number == 1:
            np.testing.assert_array_equal(R, np.eye(3))
            fake.late = False
    assert np.abs(R - np.eye(3)).max() > 0.1
    check_constraints(person)


def test_a_grab_that_is_kept_leaves_a_pin_that_turns_later() -> None:
    person, fake = begun(late=True)
    pin(person)
    fake.late = False
    person.editor.settle()
    T = transforms(person.editor.document)[-1]
    np.testing.assert_allclose(T @ [10, 2, 0, 1], [10, 5, 0, 1], atol=1e-3)
    assert np.abs(T[:3, :3] - np.eye(3)).max() > 0.01
    check_constraints(person)


@pytest.mark.parametrize(
    "then",
    [
        lambda person: person.do(c.Undo()),
        lambda person: person.do(c.KeepPose()),
        lambda person: (person.do(c.KeepPose()), person.do(c.Undo())),
        lambda person: person.do(c.ResetPose()),
    ],
)
def test_what_was_done_meanwhile_stays_as_it_was_done(then: Act) -> None:
    person, fake = begun(late=True)
    drag(person)
    then(person)
    before = state(person.editor.document)
    fake.late = False
    person.editor.settle()
    assert state(person.editor.document) == before


def test_nothing_turns_under_a_stroke_that_has_begun() -> None:
    person, fake = begun(late=True)
    drag(person)
    early = transforms(person.editor.document)[0]
    person.use("softness", 2)
    fake.late = False
    for _ in person.hold([[10, 2, 0], [11, 2, 0]]):
        np.testing.assert_array_equal(transforms(person.editor.document)[0], early)
    person.frame([11, 2, 0], "r")
    person.do(c.Undo())
    np.testing.assert_array_equal(transforms(person.editor.document)[0], early)


def test_a_click_before_the_bind_moves_nothing() -> None:
    person, fake = begun(late=True)
    before = state(person.editor.document)
    person.stroke([19, 2, 0])
    fake.late = False
    person.editor.settle()
    assert state(person.editor.document) == before


def test_a_soft_grab_leaves_nothing_and_says_why() -> None:
    person, _ = begun(late=True)
    before = state(person.editor.document)
    person.stroke([10, 2, 0], [10, 6, 0])
    assert state(person.editor.document) == before
    assert message(person) == "The solver was still binding, so nothing followed: grab once more"


def test_an_export_has_the_handle_as_it_turned(tmp_path: Path) -> None:
    person, fake = begun(late=True)
    drag(person)
    fake.late = False
    person.do(c.Export(tmp_path / "out.obj"))
    X = person.editor.positions
    person.editor.settle()
    np.testing.assert_array_equal(person.editor.positions, X)
    np.testing.assert_allclose(load_mesh(tmp_path / "out.obj").vertices, X, atol=1e-6)
    assert not np.array_equal(transforms(person.editor.document)[0][:3, :3], np.eye(3))


def test_an_export_keeps_how_it_turned_whatever_is_done_next(tmp_path: Path) -> None:
    person, fake = begun(late=True)
    drag(person)
    person.editor.execute(c.Export(tmp_path / "out.obj"))
    person.frame([10, 2, 0])
    assert not (tmp_path / "out.obj").exists()
    fake.late = False
    person.frame([10, 2, 0])
    assert not np.array_equal(transforms(person.editor.document)[0][:3, :3], np.eye(3))
    person.editor.settle()
    X = person.editor.positions.copy()
    person.do(c.Undo())
    person.editor.complete()
    np.testing.assert_allclose(load_mesh(tmp_path / "out.obj").vertices, X, atol=1e-6)


def test_where_the_bind_failed_the_reason_is_said_once_more() -> None:
    class Refusing(InlineWorker):
        def request(self, request: Request) -> None:
            self._results.append(Failure(request, WorkerError("no memory is left")))

    person = Person(slab(20, 4, 2.0), worker=Refusing())
    person.use("handle", 1.6)
    person.stroke([20, 0, 0], [20, 4, 0])
    person.use("drag")
    person.do(c.SetPlacing(gizmo=False))
    drag(person)
    assert "no memory is left" in error_of(person)
    assert not person.editor.document.pose.at_rest


def test_a_number_that_changes_nothing_owes_nothing() -> None:
    person, _ = begun(late=True)
    person.do(c.SetPlacing(pivot="free"), c.SetRotation(2, (0.0, 0.0, 0.0)))
    assert person.editor.late.debt is None
    type_a_rotation(person)
    assert person.editor.late.debt is not None
