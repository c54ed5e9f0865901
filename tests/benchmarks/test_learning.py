"""The study of learned softness: animals are held where they should be, and judged right."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from benchmarks.cases.animals import Animal, animals
from benchmarks.learning import __main__ as study
from benchmarks.learning.picture import draw
from solver import Mesh
from solver.geometry.motions import motion, moved, rotation
from solver.types import FloatArray, IntArray
from tests.solver import shapes


def table_on_legs() -> tuple[FloatArray, IntArray]:
    """Something with four feet, a head at the end of z and a tail at its start."""
    parts: list[tuple[tuple[float, float, float], tuple[float, float, float]]] = [
        ((-1, 3, -4), (1, 4.5, 4)),
        ((-0.5, 4, 3.5), (0.5, 6, 5.5)),
        ((-0.2, 4, -6), (0.2, 4.4, -4)),
        *(((x - 0.3, 0, z - 0.3), (x + 0.3, 3, z + 0.3)) for x in (-0.7, 0.7) for z in (-3, 3)),
    ]
    V, F = shapes.bar(12, 4)
    low, size = V.min(axis=0), np.ptp(V, axis=0)
    share = (V - low) / size
    vertices = [np.array(a) + share * (np.array(b) - np.array(a)) for a, b in parts]
    faces = [F + len(V) * k for k in range(len(parts))]
    return np.concatenate(vertices), np.concatenate(faces)


V, F = table_on_legs()
T = motion(rotation([1, 2, 3], 50), [4.0, 5.0, 6.0])


@pytest.mark.parametrize("turned", [False, True])
def test_feet_head_and_tail_are_handles_and_the_trunk_is_fixed(turned: bool) -> None:
    rest = V * [-1, 1, -1] if turned else V
    animal = Animal.of("animal", rest, F, [moved(T, rest)])
    assert len(animal.handles) == 6
    middles = np.array([rest[handle].mean(axis=0) for handle in animal.handles])
    assert (middles[:4, 1] < 0.5).all()
    forward = -1 if turned else 1
    assert forward * middles[4, 2] > 4
    assert forward * middles[5, 2] < -5
    assert np.abs(rest[animal.fixed, 2]).max() < 2


def test_poses_are_moved_to_where_the_trunk_is_and_a_right_shape_has_no_distance() -> None:
    animal = Animal.of("animal", V, F, [moved(T, V)])
    np.testing.assert_allclose(animal.poses[0], V, atol=1e-9)
    assert animal.away(0, V) < 1e-9
    diagonal = np.linalg.norm(np.ptp(V, axis=0))
    assert animal.away(0, V + [0.03 * diagonal, 0, 0]) == pytest.approx(3)


def test_animals_are_found_by_their_names(tmp_path: Path) -> None:
    (tmp_path / "horse").mkdir()
    mesh = Mesh.from_arrays(V, F)
    for name in ("horse-reference", "horse-01", "horse-02"):
        mesh.save(tmp_path / "horse" / f"{name}.obj", V)
    found = list(animals(tmp_path))
    assert [(animal.name, len(animal.poses)) for animal in found] == [("horse", 2)]


def test_without_animals_the_study_says_so(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    study.main(tmp_path)
    assert "no animals" in capsys.readouterr().out


def test_pictures_are_drawn(tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    animal = Animal.of("animal", V, F, [V, V])
    uniform = {"this tool, uniform, level 4": {1: V}}
    assert draw(animal, {"hinge": np.linspace(0, 1, len(V))}, uniform, tmp_path)
    for name in ("animal-softness.png", "animal-pose.png"):
        assert (tmp_path / name).read_bytes().startswith(b"\x89PNG")


def test_the_page_has_room_for_the_table() -> None:
    page = study.PAGE.read_text(encoding="utf-8")
    assert 0 < page.index(study.BEGIN) < page.index(study.END)
