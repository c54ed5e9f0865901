"""What tests of waiting share: a bent bar, and frames until something holds."""

from __future__ import annotations

import time
from collections.abc import Callable
from pathlib import Path

from app.worker.client import Worker
from app.worker.service import bind
from app.worker.snapshot import snapshot
from solver import load_mesh
from solver.types import FloatArray
from tests.app.person import Person, slab
from tests.app.worker.work import WAIT

BESIDE = [10, 2, 0]


def bent(folder: Path, worker: Worker) -> Person:
    mesh = slab(20, 4, 2.0)
    mesh.save(folder / "bar.obj", mesh.vertices)
    person = Person(load_mesh(folder / "bar.obj"), folder / "bar.obj", worker=worker)
    person.ready_bar()
    person.stroke([19, 2, 0], [16, 8, 0])
    person.editor.settle()
    return person


def asked(person: Person) -> FloatArray:
    """The surface that the document asks for."""
    shape = snapshot(person.editor.document)
    return bind(shape.bind).pose(list(shape.transforms), rigid=shape.rigid)


def until(person: Person, condition: Callable[[], bool]) -> None:
    """Frames, until it holds."""
    deadline = time.monotonic() + WAIT
    while not condition():
        assert time.monotonic() < deadline
        person.frame(BESIDE)
        time.sleep(0.002)


def is_over(person: Person) -> Callable[[], bool]:
    return lambda: person.editor.tasks.now is None


def saved(path: Path) -> FloatArray:
    return load_mesh(path).vertices


def text(person: Person) -> str:
    assert person.editor.message is not None
    return person.editor.message.text
