"""The measurement runs from one end to the other on a small mesh; nothing is said of times."""

from __future__ import annotations

from importlib.util import find_spec
from pathlib import Path

import numpy as np
import pytest

from benchmarks.cases.mannequin import Mannequin
from benchmarks.speed import backends, goals, parts, peers, steps
from benchmarks.speed.__main__ import main
from solver.factor import BACKENDS


def test_every_step_has_a_row_and_every_size_a_column(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    output = tmp_path / "RESULTS.md"
    main(["--sizes", "1000", "2000", "-o", str(output)])
    text = output.read_text(encoding="utf-8")
    assert capsys.readouterr().out.strip() == text.strip()
    rows = [[cell.strip() for cell in line.split("|")[1:-1]] for line in text.splitlines()]
    table = {row[0]: row for row in rows if row}
    sizes = ["1,002 vertices", "2,002 vertices"]
    assert ["", *sizes] in rows
    for name in (steps.BIND, steps.SOFTNESS, steps.HANDLE, steps.GRAB, steps.DRAG, steps.RIGID):
        assert all(float(cell) > 0 for cell in table[name][1:])
    assert ["what", "measured", "goal", "reached"] in rows
    exact = [goal for goal in goals.RATIOS if "coarse" not in goal.what]
    assert all(table[goal.what][-1] in ("yes", "**no**") for goal in exact)
    drawn = find_spec("matplotlib") is not None
    assert output.with_name("results.svg").exists() == drawn == ("results.svg" in text)


def test_a_missing_folder_is_said_before_anything_is_measured(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit) as stop:
        main(["-o", str(tmp_path / "none" / "RESULTS.md")])
    assert stop.value.code == 2
    assert "no such folder" in capsys.readouterr().err


def test_too_small_a_figure_is_refused(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as stop:
        main(["--sizes", "10"])
    assert stop.value.code == 2
    assert "at least 1000 vertices, got 10" in capsys.readouterr().err


def test_what_the_window_does_with_large_meshes_is_measured_too() -> None:
    session = steps.Session(Mannequin.make(1000), coarse=300)
    for task in session.coarse_tasks().values():
        assert task.seconds() > 0
    assert session.deformer.setup.coarse == 300
    (handle,) = session.deformer.setup.handles
    assert np.array_equal(handle, Mannequin.make(1000).forearm)


def test_a_goal_is_left_out_where_a_program_is_not_installed() -> None:
    result = steps.Result(1000, 10, {steps.BIND: 1.0, peers.PRECOMPUTE: 0.8}, {}, {})
    (row,) = goals.rows([result])
    assert row[1:] == ["1.25", "at most 1.5", "yes"]


def test_the_exponent_of_a_power_law_is_found() -> None:
    assert goals.exponent([10, 20, 70], [3 * n**1.5 for n in (10, 20, 70)]) == pytest.approx(1.5)


def test_the_parts_of_a_bind_are_all_found_and_none_is_counted_twice() -> None:
    mannequin = Mannequin.make(1000)
    found = parts.profile(lambda: steps.bind(mannequin), 1)
    compiled = {"symbolic analysis", "numeric factorisation"}
    expected = {*parts.PARTS, parts.REST} - (compiled if find_spec("cvxopt") is None else set())
    assert set(found) == expected


def test_all_back_ends_give_the_same_surface() -> None:
    comparison = backends.compare(Mannequin.make(1000), BACKENDS)
    assert list(comparison.difference) == [backend.name for backend in BACKENDS[1:]]
    assert all(difference < 1e-8 for difference in comparison.difference.values())
    assert len(comparison.times) == len(BACKENDS) * len(backends.STEPS)
    assert np.isfinite(list(comparison.times.values())).all()
