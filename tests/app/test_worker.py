from __future__ import annotations

import threading
from pathlib import Path

import numpy as np
import pytest

from app.document import Document
from app.worker import Binder, BindFailure, BindRequest, Bound, bind
from solver import ConstraintError, Deformer
from tests.app.person import slab

WAIT = 30.0


def document() -> Document:
    made = Document(slab(12, 3, 2.0), Path("mesh.obj"))
    made.change("handles", (made.new_handle(),))
    x = made.mesh.vertices[:, 0]
    made.change("role", 1, np.flatnonzero(x < 2))
    made.change("role", 2, np.flatnonzero(x > 10))
    return made


class Gate:
    """A build that waits until it is let go, and notes what it was asked for."""

    def __init__(self) -> None:
        self.started, self.open = threading.Event(), threading.Event()
        self.versions: list[int] = []

    def __call__(self, request: BindRequest, last: Bound | None) -> Deformer:
        self.versions.append(request.version)
        self.started.set()
        assert self.open.wait(WAIT)
        return bind(request, last)


def test_a_request_is_a_snapshot() -> None:
    made = document()
    request = BindRequest.of(made)
    fixed, softness = request.fixed.copy(), request.softness.copy()
    made.change("role", 0, np.arange(len(made.role)))
    made.change("softness", 1.0, np.arange(len(made.role)))
    np.testing.assert_array_equal(request.fixed, fixed)
    np.testing.assert_array_equal(request.softness, softness)
    assert BindRequest.of(made).version > request.version


def test_handles_without_vertices_stay_out() -> None:
    made = document()
    made.change("handles", (*made.handles, made.new_handle()))
    assert BindRequest.of(made).keys == (made.handles[0].key,)


def test_the_newest_request_wins_and_those_that_wait_are_dropped() -> None:
    gate, made = Gate(), document()
    binder = Binder(gate)
    requests = []
    for value in (0.01, 0.02, 0.03, 0.04):
        made.change("bending_length", value)
        requests.append(BindRequest.of(made))
        binder.request(requests[-1])
        assert gate.started.wait(WAIT)
        assert binder.busy
    gate.open.set()
    assert binder.wait(WAIT)
    assert gate.versions == [requests[0].version, requests[-1].version]
    result = binder.poll()
    assert isinstance(result, Bound)
    assert result.request is requests[-1]
    assert result.seconds > 0
    assert binder.poll() is None
    assert not binder.busy
    binder.close()


def test_what_was_dropped_is_never_polled() -> None:
    gate = Gate()
    binder = Binder(gate)
    binder.request(BindRequest.of(document()))
    assert gate.started.wait(WAIT)
    binder.drop()
    assert not binder.busy
    gate.open.set()
    binder.close()
    assert binder.wait(WAIT)
    assert binder.poll() is None


def test_a_result_that_waits_is_dropped_too() -> None:
    binder = Binder()
    binder.request(BindRequest.of(document()))
    assert binder.wait(WAIT)
    binder.drop()
    assert binder.poll() is None
    binder.close()


def test_a_failure_arrives_as_such_and_the_next_bind_works() -> None:
    made = document()
    binder = Binder()
    made.change("bending_length", -1.0)
    binder.request(BindRequest.of(made))
    assert binder.wait(WAIT)
    failure = binder.poll()
    assert isinstance(failure, BindFailure)
    assert "bending_length" in str(failure.error)
    made.change("bending_length", 0.01)
    binder.request(BindRequest.of(made))
    assert binder.wait(WAIT)
    assert isinstance(binder.poll(), Bound)
    binder.close()


@pytest.mark.parametrize("change", ["nothing", "softness", "material", "role", "orientation"])
def test_sharing_the_last_bind_does_not_change_the_surface(change: str) -> None:
    made = document()
    first = BindRequest.of(made)
    last = Bound(first, bind(first), 0.0)
    middle = np.flatnonzero(np.abs(made.mesh.vertices[:, 0] - 6) < 2)
    if change == "softness":
        made.change("softness", 1.0, middle)
    elif change == "material":
        made.change("material", "clay")
    elif change == "role":
        made.change("role", 1, middle[:3])
    elif change == "orientation":
        made.change("orientation", False)
    request = BindRequest.of(made)
    T = np.eye(4)
    T[:3, 3] = -1, 2, 0.5
    shared, alone = bind(request, last).pose([T], rigid=1), bind(request).pose([T], rigid=1)
    np.testing.assert_allclose(shared, alone, atol=1e-8)


def test_another_mesh_is_bound_from_scratch() -> None:
    first = BindRequest.of(document())
    other = document()
    assert bind(BindRequest.of(other), Bound(first, bind(first), 0.0)).handle_count == 1


def test_the_errors_of_the_solver_are_not_hidden() -> None:
    made = document()
    made.change("role", 1, np.arange(len(made.role)))
    request = BindRequest.of(made)
    object.__setattr__(request, "handles", (np.array([0]),))
    with pytest.raises(ConstraintError):
        bind(request)
