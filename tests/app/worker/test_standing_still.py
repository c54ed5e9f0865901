"""A process that stands still holds nobody up: it is waited for, then replaced."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time

import numpy as np
import pytest

from app.worker import pulse
from app.worker.client import ProcessWorker
from app.worker.pulse import PAUSE, Pulse
from app.worker.requests import Bound, Failure, Refined, Restarted
from app.worker.snapshot import bind_request
from tests.app.worker.work import (
    POSIX,
    WAIT,
    document,
    expected,
    frozen,
    is_gone,
    refinement,
    results,
    stop,
)

pytestmark = POSIX


@pytest.fixture
def bound(solver_process: ProcessWorker) -> ProcessWorker:
    """One that has begun to work, and is not loading any more."""
    solver_process.request(bind_request(document()))
    results(solver_process)
    return solver_process


def test_one_that_goes_on_in_time_simply_goes_on(bound: ProcessWorker) -> None:
    pid, request = bound.pid, bind_request(document())
    with frozen(bound):
        bound.request(request)
        assert not bound.wait(4 * PAUSE)
        assert bound.poll() == []
    (result,) = results(bound)
    assert isinstance(result, Bound)
    assert bound.pid == pid


def test_one_that_stands_still_is_replaced_and_its_work_is_done(
    bound: ProcessWorker, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(pulse, "SILENCE", 1.0)
    pid, request = bound.pid, bind_request(document())
    stop(bound)
    bound.request(request)
    restarted, result = results(bound)
    assert restarted == Restarted("did not answer")
    assert isinstance(result, Bound)
    assert pid is not None
    assert bound.pid != pid
    assert is_gone(pid)
    wish = refinement(request)
    bound.request(wish)
    (refined,) = results(bound)
    assert isinstance(refined, Refined)
    np.testing.assert_allclose(refined.positions, expected(request, wish), atol=1e-12)


def test_a_full_pipe_holds_nobody_up(bound: ProcessWorker, monkeypatch: pytest.MonkeyPatch) -> None:
    """Without shared memory a request goes through the pipe, which takes a fraction of it."""

    def full(number: int, start: int, size: int) -> None:
        if size > 1:
            raise OSError(28, "No space left on device")

    if hasattr(os, "posix_fallocate"):
        monkeypatch.setattr(os, "posix_fallocate", full)
    request = bind_request(document(4000))
    assert request.vertices.nbytes > 2**19
    with frozen(bound):
        bound.request(request)
        assert not bound.wait(4 * PAUSE)
    (result,) = results(bound)
    assert isinstance(result, Bound)


def test_closing_does_not_wait_for_it(bound: ProcessWorker) -> None:
    pid = bound.pid
    assert pid is not None
    stop(bound)
    bound.request(bind_request(document(200)))
    bound.close()
    assert is_gone(pid)


def test_a_request_that_takes_for_ever_fails_and_the_next_is_done(
    bound: ProcessWorker, monkeypatch: pytest.MonkeyPatch
) -> None:
    request = bind_request(document())
    with monkeypatch.context() as hasty:
        hasty.setattr(pulse, "LONGEST", 2 * PAUSE)
        hasty.setattr(pulse, "LONGEST_EACH", 0.0)
        stop(bound)
        bound.request(request)
        (failure,) = results(bound)
    assert isinstance(failure, Failure)
    assert failure.request is request
    assert "the solver had no answer after" in str(failure.error)
    bound.request(request)
    (result,) = results(bound)
    assert isinstance(result, Bound)


@pytest.mark.parametrize("works", [True, False])
def test_a_process_that_takes_processor_time_does_not_stand_still(
    works: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(pulse, "SILENCE", 6 * PAUSE)
    code = "print(flush=True)\nwhile True: pass"
    busy = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE)
    assert busy.stdout is not None
    busy.stdout.readline()
    if not works:
        os.kill(busy.pid, signal.SIGSTOP)
    looked = Pulse(busy.pid, bind_request(document()))
    deadline = time.monotonic() + (12 * PAUSE if works else WAIT)
    while time.monotonic() < deadline and not looked.stands_still:
        looked.look()
        time.sleep(PAUSE / 4)
    busy.kill()
    busy.communicate()
    assert looked.stands_still is not works


def test_seconds_in_which_nobody_looked_are_not_counted(monkeypatch: pytest.MonkeyPatch) -> None:
    """The window was stopped too, or the machine slept."""
    looked = Pulse(os.getpid(), bind_request(document()))
    now = time.monotonic()
    monkeypatch.setattr(time, "monotonic", lambda: now + 3600.0)
    looked.look()
    assert looked.spent <= pulse.GAP
