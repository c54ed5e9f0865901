"""The solver's process, as the window sees it."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from multiprocessing.shared_memory import SharedMemory
from pathlib import Path

import numpy as np
import pytest

from app.model.document import Document
from app.worker import client, process
from app.worker.client import ProcessWorker, Worker
from app.worker.inline import InlineWorker
from app.worker.requests import (
    BindRequest,
    Bound,
    Failure,
    Refined,
    RefineRequest,
    Restarted,
    Result,
    WorkerError,
)
from app.worker.service import SolverService, bind
from app.workspace.snapshot import bind_request
from solver import MaterialError
from solver.types import FloatArray
from tests.app.person import Person, slab, transforms

ROOT = Path(__file__).resolve().parents[3]
WAIT = 60.0
POSIX = pytest.mark.skipif(os.name != "posix", reason="asks a POSIX system for its processes")
TARGET = np.eye(4)
TARGET[:3, 3] = -1, 2, 0.5


def document(columns: int = 12) -> Document:
    made = Document(slab(columns, 3, 2.0), Path("mesh.obj"))
    made.change("handles", (made.new_handle(),))
    x = made.mesh.vertices[:, 0]
    made.change("role", 1, np.flatnonzero(x < 2))
    made.change("role", 2, np.flatnonzero(x > columns - 2))
    return made


@pytest.fixture
def solver_process() -> Iterator[ProcessWorker]:
    made = ProcessWorker()
    yield made
    made.close()


def results(of: Worker) -> list[Result]:
    """All there is to come."""
    arrived: list[Result] = []
    while of.busy:
        assert of.wait(WAIT)
        arrived += of.poll()
    return arrived


def refinement(request: BindRequest, rigid: int = 1, x: float = -1.0) -> RefineRequest:
    T = TARGET.copy()
    T[0, 3] = x
    return RefineRequest(request.version, T[None], rigid, len(request.vertices))


def expected(request: BindRequest, of: RefineRequest) -> FloatArray:
    return bind(request).pose(list(of.transforms), rigid=of.rigid)


def kill(of: ProcessWorker) -> None:
    assert of.pid is not None
    os.kill(of.pid, signal.SIGKILL if hasattr(signal, "SIGKILL") else signal.SIGTERM)


@contextmanager
def frozen(of: ProcessWorker) -> Iterator[None]:
    """The process gets nowhere meanwhile."""
    assert of.pid is not None
    os.kill(of.pid, signal.SIGSTOP)
    yield
    os.kill(of.pid, signal.SIGCONT)


def is_gone(pid: int) -> bool:
    """Also when nobody has asked yet what became of it."""
    status = Path("/proc") / str(pid) / "stat"
    if Path("/proc/self/stat").exists():
        return not status.exists() or status.read_text().rpartition(")")[2].split()[0] in "ZX"
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return True
    return False


def blocks() -> set[str]:
    """The shared memory there is on this machine, where that can be seen."""
    folder = Path("/dev/shm")
    return {path.name for path in folder.glob("psm_*")} if folder.is_dir() else set()


# A snapshot


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


# Results


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


# Errors


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


def test_any_other_error_arrives_as_one_of_the_worker(capfd: pytest.CaptureFixture[str]) -> None:
    request = bind_request(document())
    object.__setattr__(request, "keys", None)
    answer = SolverService().answer(request)
    assert isinstance(answer.value, WorkerError)
    assert "TypeError" in str(answer.value)
    assert "Traceback" in capfd.readouterr().err


def test_a_refinement_needs_its_bind() -> None:
    bench, request = SolverService(), bind_request(document())
    assert isinstance(bench.answer(refinement(request)).value, WorkerError)
    bench.answer(request)
    assert not isinstance(bench.answer(refinement(request)).value, WorkerError)


# A process that dies


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
    assert arrived == [Restarted()]
    assert solver_process.pid not in (pid, None)
    solver_process.request(refinement(request))
    assert isinstance(results(solver_process)[-1], Refined)


def test_a_request_that_ends_every_process_is_an_error_in_the_end(
    solver_process: ProcessWorker,
) -> None:
    request = bind_request(document())
    solver_process.request(request)
    results(solver_process)
    wish = refinement(request)
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


# The end


@POSIX
def test_closing_leaves_no_process_and_no_memory() -> None:
    before = blocks()
    made = ProcessWorker()
    made.request(bind_request(document()))
    results(made)
    pid = made.pid
    assert pid is not None
    (name,) = blocks() - before or {""}
    made.request(bind_request(document(200)))  # in the middle of something
    made.close()
    made.close()
    assert is_gone(pid)
    assert blocks() <= before
    if name:
        with pytest.raises(FileNotFoundError):
            SharedMemory(name)
    assert not made.busy
    made.request(bind_request(document()))
    assert made.poll() == []
    assert made.pid is None


SCRIPT = """
import sys
from app.worker.client import ProcessWorker
from tests.app.worker.test_worker import bind_request, document, results

if __name__ == "__main__":
    worker = ProcessWorker()
    worker.request(bind_request(document()))
    results(worker)
    print(worker.pid, flush=True)
    if sys.argv[1] == "killed":
        sys.stdin.read()
"""


@POSIX
@pytest.mark.parametrize("end", ["forgotten", "killed"])
def test_nothing_is_left_when_the_window_ends_without_closing(tmp_path: Path, end: str) -> None:
    before, script = blocks(), tmp_path / "window.py"
    script.write_text(SCRIPT, encoding="utf-8")
    window = subprocess.Popen(
        [sys.executable, str(script), end],
        env=os.environ | {"PYTHONPATH": str(ROOT)},
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    assert window.stdout is not None
    pid = int(window.stdout.readline())
    if end == "killed":
        window.kill()
    _, errors = window.communicate(timeout=WAIT)
    if end == "forgotten":
        assert errors == ""
    deadline = time.monotonic() + WAIT
    while not is_gone(pid) or not blocks() <= before:
        assert time.monotonic() < deadline
        time.sleep(0.02)


def test_the_process_knows_no_window_and_its_start_holds_nobody_up() -> None:
    code = "import sys, app.worker.child; print([n for n in sys.modules if 'polyscope' in n])"
    found = subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True)
    assert found.stdout.strip() == "[]"
    environment = dict(os.environ)
    made = process.SolverProcess()
    made.start()
    assert os.environ == environment
    made.send(bind_request(document()))
    assert made.receive() is None  # it still loads, and nobody waited for that
    made.wait(WAIT)
    assert made.receive() is not None
    made.release()


# What is shared between binds


@pytest.mark.parametrize("change", ["nothing", "softness", "material", "role", "orientation"])
def test_sharing_the_last_bind_does_not_change_the_surface(change: str) -> None:
    made = document()
    first = bind_request(made)
    last = first, bind(first)
    middle = np.flatnonzero(np.abs(made.mesh.vertices[:, 0] - 6) < 2)
    if change == "softness":
        made.change("softness", 1.0, middle)
    elif change == "material":
        made.change("material", "clay")
    elif change == "role":
        made.change("role", 1, middle[:3])
    elif change == "orientation":
        made.change("orientation", False)
    request = bind_request(made)
    shared, alone = (
        made_from.pose([TARGET], rigid=1) for made_from in (bind(request, last), bind(request))
    )
    np.testing.assert_allclose(shared, alone, atol=1e-8)


def test_another_mesh_is_bound_from_scratch() -> None:
    first, other = bind_request(document()), bind_request(document(7))
    X = bind(other, (first, bind(first))).pose([np.eye(4)])
    np.testing.assert_array_equal(X, other.vertices)
