"""What tests of the worker share: a document to bind, and processes that freeze or die."""

from __future__ import annotations

import os
import signal
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import numpy as np
import pytest

from app.model.document import Document
from app.worker.client import ProcessWorker, Worker
from app.worker.requests import (
    BindRequest,
    RefineRequest,
    Result,
)
from app.worker.service import bind
from solver.types import FloatArray
from tests.app.person import slab

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


def stop(of: ProcessWorker) -> None:
    """The process gets nowhere until it is told to go on, or killed."""
    assert of.pid is not None
    os.kill(of.pid, signal.SIGSTOP)


@contextmanager
def frozen(of: ProcessWorker) -> Iterator[None]:
    """The process gets nowhere meanwhile."""
    stop(of)
    yield
    assert of.pid is not None
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


def blocks(owner: int | None = None) -> set[str]:
    """The shared memory of a process, by default this one, where that can be seen."""
    folder = Path("/dev/shm")
    pattern = f"deform-{owner or os.getpid()}-*"
    return {path.name for path in folder.glob(pattern)} if folder.is_dir() else set()
