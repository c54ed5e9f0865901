"""What will not fit into memory is said before it is tried."""

from __future__ import annotations

import weakref
from pathlib import Path

import numpy as np
import pytest

from app.worker import memory, service
from app.worker.memory import OutOfMemory, bind_bytes, check_memory, free_bytes
from app.worker.requests import BindRequest
from app.worker.service import Last, SolverService, bind
from app.worker.snapshot import bind_request
from solver import Deformer
from solver.linear.drag_model import DragModel
from solver.setup import FREE
from tests.app.worker.work import document


def test_coarse_frames_take_less_and_more_vertices_take_more() -> None:
    assert bind_bytes(10**6, 5000) < bind_bytes(10**6, None) < bind_bytes(2 * 10**6, None)
    assert bind_bytes(1000, 5000) == bind_bytes(1000, None)


def test_a_bind_that_does_not_fit_is_refused_in_one_line(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(memory, "free_bytes", lambda: 4e9)
    with pytest.raises(OutOfMemory, match=r"^binding 1,000,000 .* 14\.0 GB .* 4\.0 GB .*coarse"):
        check_memory(1_000_000, None)
    check_memory(1_000_000, 5000)
    with pytest.raises(OutOfMemory, match=r"close other programs$"):
        check_memory(2_000_000, 5000)


def test_where_nobody_says_what_is_free_nothing_is_refused(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    assert free_bytes(tmp_path / "nothing") is None
    monkeypatch.setattr(memory, "free_bytes", lambda: None)
    check_memory(10**9, None)


def test_free_memory_is_read_as_the_system_says_it(tmp_path: Path) -> None:
    told = tmp_path / "meminfo"
    told.write_text("MemTotal:  16000 kB\nMemAvailable:   2048 kB\nSwapTotal: 0 kB\n")
    assert free_bytes(told) == 2048 * 1024


def test_the_person_gets_it_as_the_answer(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(memory, "free_bytes", lambda: 0.0)
    monkeypatch.setattr(memory, "ALWAYS", 0)
    assert isinstance(SolverService().answer(bind_request(document())).value, OutOfMemory)


@pytest.mark.parametrize("change", ["handle", "mesh"])
def test_two_factors_are_never_in_memory_at_once(
    monkeypatch: pytest.MonkeyPatch, change: str
) -> None:
    factors: list[weakref.ref[object]] = []
    alive: list[int] = []

    def watched(request: BindRequest, last: Last | None) -> Deformer:
        alive.append(sum(factor() is not None for factor in factors))
        deformer = bind(request, last)
        factors.append(weakref.ref(deformer.system.factor))
        return deformer

    monkeypatch.setattr(service, "bind", watched)
    made, used = document(), SolverService()
    used.answer(bind_request(made))
    if change == "mesh":
        made = document(14)
    else:
        made.change("role", FREE, np.array([0]))
    assert isinstance(used.answer(bind_request(made)).value, DragModel)
    assert alive == [0, 0]
