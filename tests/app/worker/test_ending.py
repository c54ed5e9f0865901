"""Nothing is left behind when the window ends, and binds share what they can."""

from __future__ import annotations

import os
import subprocess
import sys
import time
from multiprocessing.shared_memory import SharedMemory
from pathlib import Path

import numpy as np
import pytest

from app.worker import process
from app.worker.client import ProcessWorker
from app.worker.service import bind
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
    print(worker.pid, flush=True)
    if sys.argv[1] == "killed":
        sys.stdin.read()
"""


@POSIX
@pytest.mark.parametrize("end", ["forgotten", "killed"])
def test_nothing_is_left_when_the_window_ends_without_closing(tmp_path: Path, end: str) -> None:
    script = tmp_path / "window.py"
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
    while not is_gone(pid) or blocks(window.pid):
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
