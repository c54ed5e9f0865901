"""Nothing is left behind when the window ends, and binds share what they can."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from multiprocessing.shared_memory import SharedMemory
from pathlib import Path

import numpy as np
import pytest

from app.worker import process
from app.worker.client import ProcessWorker
from app.worker.requests import Bound
from app.worker.service import bind
from app.worker.shared import Block
from app.worker.snapshot import bind_request
from tests.app.worker.work import (
    POSIX,
    ROOT,
    TARGET,
    WAIT,
    blocks,
    document,
    is_gone,
    results,
)


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
from app.worker.snapshot import bind_request
from tests.app.worker.work import document, results

if __name__ == "__main__":
    worker = ProcessWorker()
    worker.request(bind_request(document()))
    results(worker)
    if sys.argv[1] == "busy":
        large = document(16000)
        large.change("coarse", False)
        worker.request(bind_request(large))
    print(worker.pid, flush=True)
    if sys.argv[1] != "forgotten":
        sys.stdin.read()
"""


def started(folder: Path, end: str) -> tuple[subprocess.Popen[str], int]:
    """A program that runs SCRIPT, in a group of its own, and the number of its solver."""
    script = folder / "window.py"
    script.write_text(SCRIPT, encoding="utf-8")
    window = subprocess.Popen(
        [sys.executable, str(script), end],
        env=os.environ | {"PYTHONPATH": str(ROOT)},
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
    )
    assert window.stdout is not None
    return window, int(window.stdout.readline())


@POSIX
@pytest.mark.parametrize("end", ["forgotten", "killed"])
def test_nothing_is_left_when_the_window_ends_without_closing(tmp_path: Path, end: str) -> None:
    window, pid = started(tmp_path, end)
    if end == "killed":
        window.kill()
    _, errors = window.communicate(timeout=WAIT)
    if end == "forgotten":
        assert errors == ""
    deadline = time.monotonic() + WAIT
    while not is_gone(pid) or blocks(window.pid):
        assert time.monotonic() < deadline
        time.sleep(0.02)


@POSIX
def test_nothing_is_left_when_all_are_killed_at_once(tmp_path: Path) -> None:
    window, pid = started(tmp_path, "killed")
    os.killpg(window.pid, signal.SIGKILL)
    window.communicate(timeout=WAIT)
    deadline = time.monotonic() + WAIT
    while not is_gone(pid):
        assert time.monotonic() < deadline
        time.sleep(0.02)
    assert not blocks(window.pid)


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="asks Linux for it")
def test_the_solver_ends_at_once_with_a_killed_window_whatever_it_does(tmp_path: Path) -> None:
    window, pid = started(tmp_path, "busy")
    time.sleep(0.2)  # in the middle of a bind of several seconds, which holds the global lock
    window.kill()
    window.wait(WAIT)
    deadline = time.monotonic() + 1.0
    while not is_gone(pid):
        assert time.monotonic() < deadline
        time.sleep(0.02)
    window.communicate(timeout=WAIT)


@pytest.mark.skipif(not Path("/dev/shm").is_dir(), reason="needs /dev/shm")
def test_where_there_is_little_shared_memory_all_goes_through_the_pipe(
    monkeypatch: pytest.MonkeyPatch, solver_process: ProcessWorker
) -> None:
    def full(number: int, start: int, size: int) -> None:
        if size > 1:
            raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "posix_fallocate", full)
    request = bind_request(document(60))
    solver_process.request(request)
    (bound,) = results(solver_process)
    assert isinstance(bound, Bound)
    np.testing.assert_array_equal(bound.model.pose([np.eye(4)]), request.vertices)


@POSIX
def test_memory_of_dead_programs_is_cleared_away() -> None:
    folder = Path("/dev/shm")
    if not folder.is_dir():
        pytest.skip("needs /dev/shm")
    dead = subprocess.Popen([sys.executable, "-c", ""])
    dead.wait()
    left, own = folder / f"deform-{dead.pid}-left", folder / f"deform-{os.getpid()}-mine"
    for path in (left, own):
        path.write_bytes(b"x")
    block = Block()
    block.of_size(10)
    block.release()
    assert not left.exists()
    assert own.exists()
    own.unlink()


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
    made.stop(process.GRACE)


@pytest.mark.parametrize("change", ["nothing", "softness", "material", "role", "orientation"])
def test_sharing_the_last_bind_does_not_change_the_surface(change: str) -> None:
    made = document()
    first = bind_request(made)
    last = first.mesh, bind(first)
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
    X = bind(other, (first.mesh, bind(first))).pose([np.eye(4)])
    np.testing.assert_array_equal(X, other.vertices)
