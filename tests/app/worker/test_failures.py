"""What goes wrong in the solver arrives typed, and the last bind stays in use."""

from __future__ import annotations

from unittest.mock import Mock

import numpy as np
import pytest

from app.worker.client import ProcessWorker
from app.worker.process import SolverProcess
from app.worker.requests import (
    Bound,
    Failure,
    Refined,
    WorkerError,
)
from app.worker.service import SolverService
from app.worker.snapshot import bind_request
from solver import MaterialError
from solver.setup import FREE
from tests.app.inline import InlineWorker
from tests.app.worker.work import (
    document,
    expected,
    refinement,
    results,
)


@pytest.mark.parametrize("kind", ["process", "inline"])
def test_a_failure_arrives_typed_and_leaves_the_last_bind_in_use(kind: str) -> None:
    made, used = document(), ProcessWorker() if kind == "process" else InlineWorker()
    first = bind_request(made)
    used.request(first)
    results(used)
    made.change("softness", 2.0, np.array([0]))
    wrong = bind_request(made)
    used.request(wrong)
    (failure,) = results(used)
    assert isinstance(failure, Failure)
    assert failure.request is wrong
    assert isinstance(failure.error, MaterialError)
    assert "softness" in str(failure.error)
    wish = refinement(first)
    used.request(wish)
    (refined,) = results(used)
    assert isinstance(refined, Refined)
    np.testing.assert_allclose(refined.positions, expected(first, wish), atol=1e-12)
    used.close()


def test_after_a_failure_that_let_go_of_the_last_bind_it_is_bound_once_more(
    solver_process: ProcessWorker,
) -> None:
    made = document()
    first = bind_request(made)
    solver_process.request(first)
    results(solver_process)
    made.change("softness", 2.0, np.array([0]))
    made.change("role", FREE, first.setup.fixed[:1])
    solver_process.request(bind_request(made))
    (failure,) = results(solver_process)
    assert isinstance(failure, Failure)
    wish = refinement(first)
    solver_process.request(wish)
    (refined,) = results(solver_process)
    assert isinstance(refined, Refined)
    np.testing.assert_allclose(refined.positions, expected(first, wish), atol=1e-12)


def test_any_other_error_arrives_as_one_of_the_worker(capfd: pytest.CaptureFixture[str]) -> None:
    request = bind_request(document())
    object.__setattr__(request, "setup", None)
    answer = SolverService().answer(request)
    assert isinstance(answer.value, WorkerError)
    assert "AttributeError" in str(answer.value)
    assert "Traceback" in capfd.readouterr().err


def test_a_refinement_needs_its_bind() -> None:
    bench, request = SolverService(), bind_request(document())
    assert isinstance(bench.answer(refinement(request)).value, WorkerError)
    bench.answer(request)
    assert not isinstance(bench.answer(refinement(request)).value, WorkerError)


@pytest.mark.parametrize("wrong", [OSError(12, "no memory"), OSError(11, "no process")])
def test_a_request_that_could_not_be_handed_over_fails_and_the_next_is_done(
    solver_process: ProcessWorker, wrong: OSError, monkeypatch: pytest.MonkeyPatch
) -> None:
    request = bind_request(document())
    with monkeypatch.context() as broken:
        broken.setattr(SolverProcess, "send", Mock(side_effect=wrong))
        solver_process.request(request)
        (failure,) = results(solver_process)
    assert isinstance(failure, Failure)
    assert failure.request is request
    assert isinstance(failure.error, WorkerError)
    assert str(wrong.strerror) in str(failure.error)
    solver_process.request(request)
    (bound,) = results(solver_process)
    assert isinstance(bound, Bound)
