"""What a worker gives for a document: snapshots, binds and refinements."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from app.model.handles import Pose
from app.worker import client, service
from app.worker.client import ProcessWorker
from app.worker.requests import (
    Bound,
    Refined,
)
from app.worker.service import SolverService, bind
from app.worker.snapshot import bind_request, preparation
from solver.linear.drag_model import DragModel
from solver.surface import contacts
from solver.surface.attachments import Attachments
from tests.app.worker.work import (
    POSIX,
    TARGET,
    WAIT,
    blocks,
    document,
    expected,
    frozen,
    refinement,
    results,
)


def test_a_request_is_a_snapshot() -> None:
    made = document()
    request = bind_request(made)
    assert request.setup.softness is not None
    fixed, softness = request.setup.fixed.copy(), request.setup.softness.copy()
    made.change("role", 0, np.arange(len(made.role)))
    made.change("softness", 1.0, np.arange(len(made.role)))
    np.testing.assert_array_equal(request.setup.fixed, fixed)
    np.testing.assert_array_equal(request.setup.softness, softness)
    assert bind_request(made).version > request.version


def test_handles_without_vertices_stay_out() -> None:
    made = document()
    made.change("handles", (*made.handles, made.new_handle()))
    assert bind_request(made).keys == (made.handles[0].key,)


def test_a_bind_and_a_refinement_equal_those_without_a_process(
    solver_process: ProcessWorker,
) -> None:
    request = bind_request(document())
    solver_process.request(request)
    assert solver_process.busy
    assert solver_process.binding
    (bound,) = results(solver_process)
    assert isinstance(bound, Bound)
    assert bound.request is request
    assert bound.seconds > 0
    assert not solver_process.binding
    alone = bind(request)
    np.testing.assert_allclose(bound.model.pose([TARGET]), alone.pose([TARGET]), atol=1e-12)
    np.testing.assert_allclose(
        bound.model.orient(0, [11, 1, 0], [9, 4, 1], [TARGET]),
        alone.orient(0, [11, 1, 0], [9, 4, 1], [TARGET]),
        atol=1e-12,
    )
    for rigid in (1, 3):
        wish = refinement(request, rigid)
        solver_process.request(wish)
        (refined,) = results(solver_process)
        assert isinstance(refined, Refined)
        assert refined.request is wish
        assert refined.seconds > 0
        np.testing.assert_allclose(refined.positions, expected(request, wish), atol=1e-12)


def test_results_are_not_written_over_by_later_ones(solver_process: ProcessWorker) -> None:
    request = bind_request(document())
    solver_process.request(request)
    (bound,) = results(solver_process)
    assert isinstance(bound, Bound)
    kept = bound.model.pose([TARGET])
    positions = []
    for x in (-1.0, -2.0):
        solver_process.request(refinement(request, x=x))
        (refined,) = results(solver_process)
        assert isinstance(refined, Refined)
        positions.append((refined.positions, refined.positions.copy()))
    for given, copied in positions:
        np.testing.assert_array_equal(given, copied)
    np.testing.assert_array_equal(bound.model.pose([TARGET]), kept)


def test_a_larger_mesh_gets_larger_memory(solver_process: ProcessWorker) -> None:
    before = blocks()
    for columns in (6, 60):
        request = bind_request(document(columns))
        solver_process.request(request)
        (bound,) = results(solver_process)
        assert isinstance(bound, Bound)
        np.testing.assert_array_equal(bound.model.pose([np.eye(4)]), request.vertices)
    assert len(blocks() - before) <= 1


@POSIX
def test_of_the_requests_that_wait_the_newest_wins(solver_process: ProcessWorker) -> None:
    made = document()
    requests = []
    with frozen(solver_process):
        for value in (0.01, 0.02, 0.03, 0.04):
            made.change("bending_length", value)
            requests.append(bind_request(made))
            solver_process.request(requests[-1])
            assert solver_process.busy
    # the first was running already, the others never ran
    arrived = results(solver_process)
    assert [result.request for result in arrived if isinstance(result, Bound)] == [
        requests[0],
        requests[-1],
    ]
    wishes = [refinement(requests[-1], x=float(-x)) for x in range(1, 9)]
    with frozen(solver_process):
        for wish in wishes:
            solver_process.request(wish)
    arrived = results(solver_process)
    assert [result.request for result in arrived if isinstance(result, Refined)] == [
        wishes[0],
        wishes[-1],
    ]


@POSIX
def test_what_goes_wrong_with_a_superseded_bind_is_nobodys_business(
    solver_process: ProcessWorker,
) -> None:
    made = document()
    with frozen(solver_process):
        for value in (2.0, 0.5):
            made.change("softness", value, np.array([0]))
            request = bind_request(made)
            solver_process.request(request)
    (bound,) = results(solver_process)
    assert isinstance(bound, Bound)
    assert bound.request is request


def test_a_bind_brings_the_pose_of_its_handles_along(solver_process: ProcessWorker) -> None:
    made = document()
    for transform, rigid in ((np.eye(4), 1), (TARGET, 0), (TARGET, 1), (TARGET, 3)):
        made.change("pose", made.pose.moved(made.handles[0].key, transform))
        made.change("rigid", rigid)
        request = bind_request(made)
        solver_process.request(request)
        (bound,) = results(solver_process)
        assert isinstance(bound, Bound)
        if rigid == 0 or transform is not TARGET:
            assert bound.pose is None
            continue
        assert bound.pose is not None
        wish = refinement(request, rigid)
        np.testing.assert_array_equal(bound.pose.request.transforms, wish.transforms)
        np.testing.assert_allclose(bound.pose.positions, expected(request, wish), atol=1e-12)


def test_a_refinement_for_a_bind_no_longer_in_use_is_dropped(
    solver_process: ProcessWorker,
) -> None:
    made = document()
    first = bind_request(made)
    solver_process.request(first)
    results(solver_process)
    made.change("bending_length", 0.05)
    second = bind_request(made)
    solver_process.request(second)
    solver_process.request(refinement(first))
    (bound,) = results(solver_process)
    assert isinstance(bound, Bound)
    assert bound.request is second


def test_what_was_dropped_is_never_polled(solver_process: ProcessWorker) -> None:
    solver_process.request(bind_request(document()))
    solver_process.drop()
    assert not solver_process.busy
    request = bind_request(document())
    solver_process.request(request)
    (bound,) = results(solver_process)
    assert isinstance(bound, Bound)
    assert bound.request is request
    solver_process.request(refinement(request))
    assert solver_process.wait(WAIT)
    solver_process.drop()  # a result that waits, too
    assert solver_process.poll() == []


def test_a_bind_of_another_mesh_does_not_wait_for_a_long_one(
    solver_process: ProcessWorker, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(client, "PATIENCE", 0.0)
    first = bind_request(document())
    solver_process.request(first)
    results(solver_process)
    pid = solver_process.pid
    solver_process.request(bind_request(document(400)))
    solver_process.drop()
    other = bind_request(document())
    solver_process.request(other)
    (bound,) = results(solver_process)
    assert isinstance(bound, Bound)
    assert bound.request is other
    assert solver_process.pid != pid


def test_waiting_ends_in_time(solver_process: ProcessWorker) -> None:
    solver_process.request(bind_request(document()))
    assert not solver_process.wait(0.0)
    assert solver_process.wait(WAIT)


def test_what_belongs_to_the_mesh_alone_is_found_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """In the background when a mesh opens, and not again by the binds to come."""
    found = []
    find = contacts.find_attachments

    def counted(*arguments: Any) -> Attachments:
        found.append(1)
        return find(*arguments)

    monkeypatch.setattr("solver.linear.rest_surface.find_attachments", counted)
    made, service = document(), SolverService()
    assert isinstance(service.answer(preparation(made)).value, DragModel)
    assert len(found) == 1
    assert isinstance(service.answer(bind_request(made)).value, DragModel)
    assert len(found) == 1


def test_a_large_mesh_can_be_dragged_before_its_level_is_prepared(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    made = document()
    made.change("rigid", 4)
    made.change("pose", Pose({2: TARGET}))
    request = bind_request(made)
    soon = SolverService().answer(request)
    assert soon.pose is not None
    monkeypatch.setattr(service, "QUICK", 10)
    used = SolverService()
    answer = used.answer(request)
    assert isinstance(answer.value, DragModel)
    assert answer.pose is None
    later = used.answer(request.first_pose).value
    assert isinstance(later, np.ndarray)
    assert isinstance(soon.pose.value, np.ndarray)
    np.testing.assert_allclose(later, soon.pose.value, atol=1e-12)
