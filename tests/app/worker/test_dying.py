"""A process that dies or hangs is replaced, and nothing is lost."""

from __future__ import annotations

import time

import numpy as np

from app.worker import client
from app.worker.client import ProcessWorker
from app.worker.requests import (
    Bound,
    Failure,
    Refined,
    Restarted,
    Result,
)
from app.worker.service import bind
from app.worker.snapshot import bind_request
from tests.app.person import Person, slab, transforms
from tests.app.worker.work import (
    POSIX,
    WAIT,
    document,
    expected,
    kill,
    refinement,
    results,
    stop,
)


def test_what_a_killed_process_was_doing_is_done_by_the_next(
    solver_process: ProcessWorker,
) -> None:
    request = bind_request(document())
    solver_process.request(request)
    kill(solver_process)
    restarted, bound = results(solver_process)
    assert isinstance(restarted, Restarted)
    assert isinstance(bound, Bound)
    wish = refinement(request)
    kill(solver_process)
    solver_process.request(wish)
    restarted, refined = results(solver_process)
    assert isinstance(restarted, Restarted)
    assert isinstance(refined, Refined)
    np.testing.assert_allclose(refined.positions, expected(request, wish), atol=1e-12)


def test_a_process_that_dies_idle_is_replaced_and_it_says_so(
    solver_process: ProcessWorker,
) -> None:
    request = bind_request(document())
    solver_process.request(request)
    results(solver_process)
    pid = solver_process.pid
    kill(solver_process)
    deadline = time.monotonic() + WAIT
    while not (arrived := solver_process.poll()):
        assert time.monotonic() < deadline
    assert arrived == [Restarted("stopped")]
    assert solver_process.pid not in (pid, None)
    solver_process.request(refinement(request))
    assert isinstance(results(solver_process)[-1], Refined)


@POSIX
def test_a_request_that_ends_every_process_is_an_error_in_the_end(
    solver_process: ProcessWorker,
) -> None:
    request = bind_request(document())
    solver_process.request(request)
    results(solver_process)
    wish = refinement(request)
    stop(solver_process)  # or it may answer before it is killed
    solver_process.request(wish)
    arrived: list[Result] = []
    while solver_process.busy:
        kill(solver_process)
        assert solver_process.wait(WAIT)
        arrived += solver_process.poll()
    *restarts, failure = arrived
    assert len(restarts) == client.ATTEMPTS - 1
    assert all(isinstance(result, Restarted) for result in restarts)
    assert isinstance(failure, Failure)
    assert failure.request is wish
    assert "stopped 3 times" in str(failure.error)
    solver_process.request(refinement(request))
    assert isinstance(results(solver_process)[-1], Refined)


def test_a_drag_goes_on_when_the_process_dies(solver_process: ProcessWorker) -> None:
    person = Person(slab(20, 4, 2.0), worker=solver_process)
    person.ready_bar()
    path = [[19, 2, 0], [18, 4, 0], [17, 6, 0], [16, 8, 0], [15, 9, 0]]
    for number in person.hold(path):
        handle = person.editor.document.handles[0]
        if number:
            own = person.editor.document.vertices_of(handle.key)
            rest = person.editor.document.mesh.vertices[own]
            T = person.editor.document.pose.of(handle.key)
            moved = rest @ T[:3, :3].T + T[:3, 3]
            np.testing.assert_allclose(person.editor.positions[own], moved, atol=1e-8)
        if number == 2:
            kill(solver_process)
    person.frame(path[-1], "r")
    person.editor.settle()
    assert person.editor.message is not None
    assert person.editor.message.text == "The solver stopped and was started again"
    editor = person.editor
    alone = bind(bind_request(editor.document)).pose(transforms(editor.document), rigid=1)
    np.testing.assert_allclose(editor.positions, alone, atol=1e-8)
    assert editor.history.done[-1].label == "Drag handle 1"
