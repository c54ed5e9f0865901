from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from app.editor.commands import (
    ActivateHandle,
    AddHandle,
    Export,
    ResetPose,
    SetSetting,
    SetTurn,
    Undo,
)
from app.model.handles import FIRST_HANDLE, FIXED, FREE
from app.worker.client import Worker
from app.worker.inline import InlineWorker
from app.worker.requests import Refined, RefineRequest, Request, Result
from app.worker.service import bind
from app.worker.snapshot import bind_request
from app.workspace import pace
from solver.linear.drag_model import DragModel
from solver.types import FloatArray
from tests.app.person import IdleWorker, Person, slab, transforms


def size(positions: FloatArray) -> float:
    return float(np.linalg.norm(np.ptp(positions, axis=0)))


def check_constraints(person: Person) -> None:
    """Handles are at T p, fixed vertices at rest."""
    document, X = person.editor.document, person.editor.positions
    rest = document.mesh.vertices
    for handle, T in zip(document.handles, transforms(document), strict=True):
        own = document.vertices_of(handle.key)
        moved = rest[own] @ T[:3, :3].T + T[:3, 3]
        np.testing.assert_allclose(X[own], moved, atol=1e-9 * size(rest))
    np.testing.assert_array_equal(X[document.fixed], rest[document.fixed])


@pytest.mark.parametrize("turn", [True, False])
@pytest.mark.parametrize("rigid", [0, 1])
def test_handles_move_by_their_transform_and_fixed_vertices_stay(
    ready: Person, turn: bool, rigid: int
) -> None:
    ready.do(SetSetting("rigid", rigid), SetTurn(turn))
    for _ in ready.hold([[19, 2, 0], [18, 4, 0], [16, 8, 0]]):
        check_constraints(ready)
    ready.frame([16, 8, 0], "r")
    check_constraints(ready)
    R = transforms(ready.editor.document)[0][:3, :3]
    np.testing.assert_allclose(R @ R.T, np.eye(3), atol=1e-12)
    assert np.array_equal(R, np.eye(3)) != turn
    free = ready.editor.document.role == FREE
    rest = ready.editor.document.mesh.vertices
    assert np.abs(ready.editor.positions - rest)[free].max() > 1


def test_the_grabbed_point_stays_under_the_cursor_in_the_screens_plane(ready: Person) -> None:
    ready.stroke([19, 2, 0], [16, 8, 0])
    T = transforms(ready.editor.document)[0]
    np.testing.assert_allclose(
        T @ [19, 2, 0, 1], [16, 8, 0, 1], atol=1e-6 * size(ready.editor.positions)
    )


def test_a_second_drag_goes_on_from_the_first(ready: Person) -> None:
    ready.do(SetTurn(False))
    ready.stroke([19, 2, 0], [18, 6, 0])
    ready.stroke([18, 6, 0], [17, 7, 0])
    transform = transforms(ready.editor.document)[0]
    np.testing.assert_allclose(transform[:3, 3], [-2, 5, 0], atol=1e-5)
    assert len(ready.editor.history.done) == 4  # two strokes, two drags


def test_a_drag_that_ends_at_a_rest_pose_equals_rest(ready: Person) -> None:
    ready.do(SetTurn(False))
    ready.stroke([19, 2, 0], [16, 8, 0])
    ready.do(Undo())
    rest = ready.editor.document.mesh.vertices
    np.testing.assert_array_equal(ready.editor.positions, rest)
    ready.stroke([19, 2, 0], [16, 8, 0])
    ready.do(ResetPose())
    np.testing.assert_array_equal(ready.editor.positions, rest)
    ready.do(Undo())
    assert np.abs(ready.editor.positions - rest).max() > 1


def test_a_click_moves_nothing_and_leaves_no_entry(ready: Person) -> None:
    entries = len(ready.editor.history.done)
    ready.stroke([19, 2, 0], [19, 2, 0])
    assert len(ready.editor.history.done) == entries
    np.testing.assert_array_equal(ready.editor.positions, ready.editor.document.mesh.vertices)


def test_the_dragged_handle_becomes_the_active_one(ready: Person) -> None:
    first = ready.editor.document.handles[0]
    ready.do(AddHandle("other"))
    assert ready.editor.active is not first
    ready.stroke([19, 2, 0], [18, 4, 0])
    assert ready.editor.active is not None
    assert ready.editor.active.key == first.key


def test_a_drag_waits_for_the_bind_it_needs() -> None:
    person = Person(slab(20, 4, 2.0), worker=IdleWorker())
    person.use("handle", 1.6)
    person.stroke([20, 0, 0], [20, 4, 0])
    person.use("drag")
    editor = person.editor
    person.stroke([19, 2, 0], [16, 8, 0])
    np.testing.assert_array_equal(transforms(editor.document)[0], np.eye(4))
    assert [entry.label for entry in editor.history.done] == ["Paint handle 1"]
    editor.close()


def test_the_cursor_over_the_panel_holds_the_drag(ready: Person) -> None:
    ready.frame([19, 2, 0], "pd")
    ready.frame([18, 4, 0], "d")
    held = ready.editor.positions
    ready.frame(None, "d")
    assert ready.editor.captures
    assert ready.editor.positions is held


def test_a_cursor_at_rest_costs_no_pose(ready: Person) -> None:
    fake = with_fake(ready)
    for _ in ready.hold([[19, 2, 0], *[[18, 4, 0]] * 5]):
        pass
    assert len(fake.levels) == 1


def test_a_handle_painted_on_a_deformed_surface_does_not_jump_back(ready: Person) -> None:
    ready.stroke([19, 2, 0], [12, 10, 0])
    X = ready.editor.positions
    middle = X[np.argmin(np.linalg.norm(ready.editor.document.mesh.vertices - (10, 2, 0), axis=1))]
    ready.do(AddHandle("middle"))
    ready.use("handle", 1.2)
    ready.stroke(middle)
    ready.editor.settle()
    new = ready.editor.document.vertices_of(ready.editor.document.handles[1].key)
    rest = ready.editor.document.mesh.vertices
    assert len(new) > 2
    moved = np.abs(X - rest)[new].max()
    assert moved > 1
    assert np.abs(ready.editor.positions - X)[new].max() < 0.1 * moved
    check_constraints(ready)


def test_painting_fixed_returns_the_region_to_rest(ready: Person) -> None:
    ready.stroke([19, 2, 0], [16, 8, 0])
    X = ready.editor.positions
    middle = X[np.argmin(np.linalg.norm(ready.editor.document.mesh.vertices - (10, 2, 0), axis=1))]
    ready.use("fixed", 1.2)
    ready.stroke(middle)
    ready.editor.settle()
    check_constraints(ready)
    assert (ready.editor.document.role[X[:, 0] > 5] == FIXED).any()


class FakeWorker(InlineWorker):
    """Notes the levels it is asked for, and makes them slow, late or useless as the test wants."""

    def __init__(self, real: Worker) -> None:
        super().__init__()
        self.levels: list[int] = []
        self.real = real
        self.seconds = 0.001
        self.broken = self.late = False

    def request(self, request: Request) -> None:
        if isinstance(request, RefineRequest):
            self.levels.append(request.rigid)
        self.real.request(request)

    def poll(self) -> list[Result]:
        return [] if self.late else [self._changed(result) for result in self.real.poll()]

    @property
    def busy(self) -> bool:
        return self.real.busy

    def _changed(self, result: Result) -> Result:
        if not isinstance(result, Refined):
            return result
        positions = result.positions * (np.nan if self.broken else 1.0)
        return replace(result, positions=positions, seconds=self.seconds)


def with_fake(person: Person) -> FakeWorker:
    fake = FakeWorker(person.editor.worker)
    person.editor.worker = person.editor.surface.worker = fake
    return fake


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


def test_a_transform_that_flattens_can_still_be_dragged(ready: Person) -> None:
    """Session files may hold such transforms."""
    document = ready.editor.document
    flat = np.diag([1.0, 1.0, 0.0, 1.0])
    document.change("pose", document.pose.moved(document.handles[0].key, flat))
    ready.stroke([19, 2, 0], [17, 6, 0])
    assert np.isfinite(ready.editor.positions).all()
    assert ready.editor.history.done[-1].label == "Drag handle 1"


def test_handles_without_vertices_are_no_obstacle(ready: Person) -> None:
    first = ready.editor.document.handles[0].key
    ready.do(AddHandle("empty"), ActivateHandle(first))
    ready.stroke([19, 2, 0], [16, 8, 0])
    check_constraints(ready)
    assert (ready.editor.document.role == FIRST_HANDLE + 1).sum() == 0
