"""Damaged files and sessions and absurd surfaces: used, or refused in one line."""

from __future__ import annotations

import warnings
from pathlib import Path
from random import Random

import pytest

from solver import SolverError, load_mesh
from tests.fuzz import trials
from tests.fuzz.corpus import mesh_files
from tests.fuzz.mutator import MUTATIONS


@pytest.mark.parametrize("name", trials.TRIALS)
def test_whatever_comes_is_used_or_refused_in_one_line(name: str, tmp_path: Path) -> None:
    used = [trials.run(name, seed, tmp_path / "trial") for seed in range(250)]
    assert 10 < sum(used) < 240, "damage of every kind, from harmless to hopeless"


@pytest.mark.parametrize("name", sorted(mesh_files()))
def test_files_that_are_damaged_are_whole_before(name: str, tmp_path: Path) -> None:
    """Of those that are kept, two were hostile from the start."""
    (tmp_path / name).write_bytes(mesh_files()[name])
    if name in ("binary.off", "circle.gltf"):
        with pytest.raises(SolverError):
            load_mesh(tmp_path / name)
    else:
        assert len(load_mesh(tmp_path / name).faces)


def _warns(random: Random, folder: Path) -> None:
    warnings.warn("so be it", RuntimeWarning, stacklevel=1)


def _speaks_at_length(random: Random, folder: Path) -> None:
    raise SolverError("one line\nand another")


def _breaks(random: Random, folder: Path) -> None:
    raise KeyError("nobody's")


@pytest.mark.parametrize("trial", [_warns, _speaks_at_length, _breaks])
def test_all_else_is_a_finding(
    trial: trials.Trial, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(trials.TRIALS, "session", trial)
    with pytest.raises(trials.Finding, match=r"^session 7: "):
        trials.run("session", 7, tmp_path / "trial")


@pytest.mark.parametrize("limit", ["SECONDS", "BYTES"])
def test_too_much_time_or_memory_is_a_finding(
    limit: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(trials, limit, -1)
    with pytest.raises(trials.Finding, match=r"solver 1: \d+ s, \d+ MiB"):
        trials.run("solver", 1, tmp_path / "trial")


def test_a_seed_is_the_same_damage_everywhere() -> None:
    data = bytes(range(200))
    for mutation in MUTATIONS:
        first, second = (mutation(Random("a seed"), data) for _ in range(2))
        assert first == second
