"""What tests of drags check, and a worker that is as slow, late or useless as they want."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from app.worker.client import Worker
from app.worker.requests import Refined, RefineRequest, Request, Result
from solver.geometry.bounding_box import diagonal
from solver.geometry.motions import moved
from tests.app.inline import InlineWorker
from tests.app.person import Person, transforms


def check_constraints(person: Person) -> None:
    """Handles are at T p, fixed vertices at rest."""
    document, X = person.editor.document, person.editor.positions
    rest = document.mesh.vertices
    for handle, T in zip(document.handles, transforms(document), strict=True):
        own = document.vertices_of(handle.key)
        np.testing.assert_allclose(X[own], moved(T, rest[own]), atol=1e-9 * diagonal(rest))
    np.testing.assert_array_equal(X[document.fixed], rest[document.fixed])


class FakeWorker(InlineWorker):
    """Notes the levels it is asked for, and makes them slow, late or useless as the test wants."""

    def __init__(self, real: Worker) -> None:
        super().__init__()
        self.levels: list[int] = []
        self.real = real
        self.seconds = 0.001
        self.broken = self.late = False

    def request(self, request: Request) -> None:
        if isinstance(request, RefineRequest):
            self.levels.append(request.rigid)
        self.real.request(request)

    def poll(self) -> list[Result]:
        return [] if self.late else [self._changed(result) for result in self.real.poll()]

    @property
    def busy(self) -> bool:
        return self.real.busy

    def _changed(self, result: Result) -> Result:
        if not isinstance(result, Refined):
            return result
        positions = result.positions * (np.nan if self.broken else 1.0)
        return replace(result, positions=positions, seconds=self.seconds)


def with_fake(person: Person) -> FakeWorker:
    fake = FakeWorker(person.editor.worker)
    person.editor.worker = person.editor.surface.worker = fake
    return fake
