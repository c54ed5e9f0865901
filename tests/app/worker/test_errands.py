"""A shape that is asked for beside what the surface on screen needs."""

from __future__ import annotations

import time

import numpy as np
import pytest

from app.model.document import Document
from app.model.handles import Pose
from app.worker import client
from app.worker.client import ProcessWorker
from app.worker.errand import Errand, Snapshot
from app.worker.requests import Bound, Failure, Refined
from app.worker.service import bind
from app.worker.snapshot import bind_request, snapshot
from solver.types import FloatArray
from tests.app.worker.work import (
    POSIX,
    TARGET,
    WAIT,
    document,
    expected,
    frozen,
    kill,
    refinement,
    results,
    stop,
)


@pytest.fixture
def posed() -> Document:
    made = document()
    made.change("pose", Pose({made.handles[0].key: TARGET}))
    made.change("rigid", 1)
    return made


def result(of: Errand, worker: ProcessWorker) -> Refined | Failure:
    """What comes of it; all else that arrives is thrown away."""
    deadline = time.monotonic() + WAIT
    while of.result is None:
        assert time.monotonic() < deadline
        worker.poll()
        time.sleep(0.002)
    return of.result


def alone(shape: Snapshot) -> FloatArray:
    return bind(shape.bind).pose(list(shape.transforms), rigid=shape.rigid)


def check(of: Errand, worker: ProcessWorker) -> None:
    found = result(of, worker)
    assert isinstance(found, Refined)
    np.testing.assert_allclose(found.positions, alone(of.snapshot), atol=1e-12)


@pytest.mark.parametrize("rigid", [0, 1])
def test_it_is_bound_and_posed_as_the_document_was(
    solver_process: ProcessWorker, posed: Document, rigid: int
) -> None:
    posed.change("rigid", rigid)
    errand = solver_process.errand(snapshot(posed))
    posed.change("pose", Pose())
    posed.change("bending_length", 0.1)
    assert not solver_process.busy, "nothing that is polled"
    check(errand, solver_process)
    assert solver_process.poll() == []


def test_the_surface_on_screen_is_bound_again_after_an_errand_of_before(
    solver_process: ProcessWorker, posed: Document
) -> None:
    old = snapshot(posed)
    posed.change("bending_length", 0.1)
    request = bind_request(posed)
    solver_process.request(request)
    results(solver_process)
    check(solver_process.errand(old), solver_process)
    wish = refinement(request)
    solver_process.request(wish)
    (refined,) = results(solver_process)
    assert isinstance(refined, Refined)
    np.testing.assert_allclose(refined.positions, expected(request, wish), atol=1e-12)


def test_a_drag_and_an_errand_take_turns(solver_process: ProcessWorker, posed: Document) -> None:
    request = bind_request(posed)
    solver_process.request(request)
    results(solver_process)
    errand, refined = solver_process.errand(snapshot(posed)), 0
    solver_process.request(refinement(request))
    deadline = time.monotonic() + WAIT
    while errand.result is None or refined < 2:
        assert time.monotonic() < deadline
        if solver_process.poll():
            refined += 1
        solver_process.request(refinement(request, x=-0.01 * time.monotonic()))
    check(errand, solver_process)


def test_dropping_what_the_surface_needs_leaves_it(
    solver_process: ProcessWorker, posed: Document
) -> None:
    solver_process.request(bind_request(document(100)))
    errand = solver_process.errand(snapshot(posed))
    solver_process.drop()
    check(errand, solver_process)


@POSIX
def test_one_that_nobody_wants_is_not_begun(solver_process: ProcessWorker, posed: Document) -> None:
    with frozen(solver_process):
        solver_process.request(bind_request(document()))
        errand = solver_process.errand(snapshot(posed))
        errand.wanted = False
    assert isinstance(results(solver_process)[-1], Bound)
    assert errand.result is None
    assert not solver_process.binding


def test_a_newer_one_takes_its_place(solver_process: ProcessWorker, posed: Document) -> None:
    solver_process.request(bind_request(posed))
    first = solver_process.errand(snapshot(posed))
    second = solver_process.errand(snapshot(posed).posed(Pose()))
    check(second, solver_process)
    assert not first.wanted
    assert first.result is None


def test_what_cannot_be_had_is_its_result(solver_process: ProcessWorker, posed: Document) -> None:
    posed.change("softness", 2.0, np.array([0]))
    failure = result(solver_process.errand(snapshot(posed)), solver_process)
    assert isinstance(failure, Failure)
    assert "softness" in str(failure.error)
    assert solver_process.poll() == []


@POSIX
def test_it_is_done_by_the_next_process_where_one_dies(
    solver_process: ProcessWorker, posed: Document
) -> None:
    stop(solver_process)
    errand = solver_process.errand(snapshot(posed))
    kill(solver_process)
    check(errand, solver_process)


@POSIX
def test_one_that_ends_every_process_fails_in_the_end(
    solver_process: ProcessWorker, posed: Document
) -> None:
    stop(solver_process)
    errand, seen = solver_process.errand(snapshot(posed)), set[int | None]()
    deadline = time.monotonic() + WAIT
    while errand.result is None:
        assert time.monotonic() < deadline
        if solver_process.pid not in seen:
            seen.add(solver_process.pid)
            kill(solver_process)
        solver_process.poll()
    assert len(seen) == client.ATTEMPTS
    assert isinstance(errand.result, Failure)
    assert "stopped 3 times" in str(errand.result.error)
