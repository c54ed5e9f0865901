"""A drag at a rigid level: slow, late and useless answers of the solver."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from app.editor.commands import (
    Export,
    SetSetting,
    SetTurn,
)
from app.live import pace
from app.worker.service import bind
from app.worker.snapshot import bind_request
from solver.linear.drag_model import DragModel
from solver.types import FloatArray
from tests.app.person import IdleWorker, Person, transforms
from tests.app.tools.dragging import check_constraints, with_fake


def linear(person: Person) -> FloatArray:
    """What level 0 is now."""
    bound = person.editor.surface.bound
    assert bound is not None
    X: FloatArray = bound.model.pose(transforms(person.editor.document))
    return X


PATH = [[19, 2, 0], [18, 4, 0], [17, 6, 0], [16, 8, 0], [15, 9, 0], [14, 10, 0]]


def is_linear(person: Person) -> bool:
    return np.allclose(person.editor.positions, linear(person), atol=1e-9)


def test_a_level_too_slow_for_a_frame_comes_on_release(ready: Person) -> None:
    fake = with_fake(ready)
    fake.seconds = 1.01 * pace.SLACK * pace.FRAME_BUDGET
    shown = [is_linear(ready) for _ in ready.hold(PATH)]
    # At rest all levels are one; the first answer tells that the level is slow.
    assert shown == [True, False, True, True, True, True]
    assert fake.levels == [1]
    ready.frame(PATH[-1], "r")
    assert fake.levels == [1, 1]
    assert not is_linear(ready)
    assert ready.editor.drag_seconds > fake.seconds
    # The next drag knows it from the start, and a click shows what there was.
    before = ready.editor.positions
    ready.frame(PATH[-1], "pd")
    assert ready.editor.positions is before
    ready.frame(PATH[-2], "d")
    assert is_linear(ready)
    assert fake.levels == [1, 1]


def test_a_drag_does_not_flicker_between_levels(ready: Person) -> None:
    fake = with_fake(ready)
    limit = pace.FRAME_BUDGET
    times = [limit, limit, 1.2 * limit, 0.5 * limit, 2 * limit, 0.1 * limit]
    shown = []
    for number in ready.hold([*PATH, [13, 10, 0]]):
        shown.append(is_linear(ready))
        fake.seconds = times[min(number, len(times) - 1)]
    # A little too slow once is no reason to change, and there is no way back before the release.
    assert shown == [True, False, False, False, False, False, True]
    fake.seconds = 0.1 * limit
    ready.frame([13, 10, 0], "r")
    assert not is_linear(ready)
    for _ in ready.hold([[13, 10, 0], [12, 10, 0]]):
        assert not is_linear(ready)


def test_handles_do_not_lag_behind_answers_that_come_late(ready: Person) -> None:
    fake = with_fake(ready)
    for number in ready.hold(PATH):
        check_constraints(ready)
        assert not ready.editor.busy
        fake.late = number > 1
    carried = ready.editor.positions
    assert not is_linear(ready)
    ready.frame(PATH[-1], "r")
    # Until the answer for the very transforms of the release is there nothing jumps.
    assert ready.editor.positions is carried
    assert ready.editor.busy
    fake.late = False
    ready.editor.settle()
    assert not ready.editor.busy
    document = ready.editor.document
    alone = bind(bind_request(document)).pose(transforms(document), rigid=1)
    np.testing.assert_allclose(ready.editor.positions, alone, atol=1e-8)


def test_a_drag_goes_on_with_the_old_bind_while_another_one_is_made(ready: Person) -> None:
    old = ready.editor.surface.bound
    ready.editor.worker = ready.editor.surface.worker = IdleWorker()
    ready.do(SetSetting("bending_length", 0.05))
    assert ready.editor.hint == "Binding ..."
    for _ in ready.hold(PATH[:3]):
        check_constraints(ready)
        assert is_linear(ready)
    ready.frame(PATH[2], "r")
    assert ready.editor.surface.bound is old
    assert ready.editor.busy
    assert ready.editor.history.done[-1].label == "Drag handle 1"


@pytest.mark.parametrize("turn", [True, False])
def test_a_pose_that_is_not_finite_is_refused_with_a_message(
    ready: Person, turn: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    ready.do(SetTurn(turn))
    fake = with_fake(ready)
    ready.frame([19, 2, 0], "pd")
    ready.frame([18, 4, 0], "d")
    good, entries = ready.editor.positions, len(ready.editor.history.done)
    fake.broken = True
    if turn:
        monkeypatch.setattr(DragModel, "orient", lambda *arguments: np.full((4, 4), np.nan))
    ready.frame([17, 6, 0], "d")
    assert ready.editor.message is not None
    assert ready.editor.message.kind == "error"
    assert "not finite" in ready.editor.message.text
    assert ready.editor.positions is good
    # The drag is over and its handle back where it was before.
    assert not ready.editor.captures
    assert len(ready.editor.history.done) == entries
    np.testing.assert_array_equal(transforms(ready.editor.document)[0], np.eye(4))


def test_a_refused_pose_is_not_exported(ready: Person, tmp_path: Path) -> None:
    ready.stroke([19, 2, 0], [16, 8, 0])
    fake = with_fake(ready)
    fake.broken = True
    for _ in range(2):
        ready.do(SetSetting("rigid", 2), Export(tmp_path / "out.obj"))
        assert ready.editor.message is not None
        assert "not finite" in ready.editor.message.text
        assert not (tmp_path / "out.obj").exists()
    assert fake.levels == [2]  # what was refused is not asked for again and again
