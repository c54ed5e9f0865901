"""The figures: every claim of a caption, from the numbers that the run writes."""

from __future__ import annotations

import json
import math
import re
import struct
from collections.abc import Iterator
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from app.bundled import DEFAULT_MESH
from app.figures.arm import FOLD_AXIS, Arm, turn
from app.figures.measures import MEANING, ArmMeasures
from app.figures.stage import SIZE
from solver import load_mesh
from tests.app.command import WITHOUT_GRAPHICS, run

NUMBERS = [*(f"{k:02}" for k in range(4, 13)), "13a", "13b", "13c", "14a", "14b", "15"]
Figures = dict[str, dict[str, Any]]


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder of a run on a machine without any graphics library."""
    folder = tmp_path_factory.mktemp("figures") / "new"
    done = run("figures", "-o", folder, code=WITHOUT_GRAPHICS)
    assert done.returncode == 0, done.stderr
    assert done.stderr.startswith("no pictures: nothing can be drawn on this machine")
    assert done.stderr.count("\n") == 1
    return folder


@pytest.fixture(scope="module")
def figures(folder: Path) -> Figures:
    return {f["number"]: f for f in json.loads((folder / "figures.json").read_text())["figures"]}


@pytest.fixture(scope="module")
def numbers(figures: Figures) -> dict[str, dict[str, float]]:
    return {number: figure["numbers"] for number, figure in figures.items()}


@pytest.fixture(scope="module")
def arm() -> Arm:
    return Arm(load_mesh(DEFAULT_MESH))


@pytest.fixture(scope="module")
def measure(arm: Arm) -> ArmMeasures:
    return ArmMeasures(arm)


def leaves(value: Any) -> Iterator[Any]:
    if isinstance(value, dict | list):
        for item in value.values() if isinstance(value, dict) else value:
            yield from leaves(item)
    else:
        yield value


def test_without_graphics_there_are_numbers_and_no_pictures(folder: Path) -> None:
    assert sorted(path.name for path in folder.iterdir()) == ["figures.json", "figures.md"]
    assert "![" not in (folder / "figures.md").read_text()


def test_every_figure_has_a_caption_with_its_numbers(folder: Path, figures: Figures) -> None:
    page = (folder / "figures.md").read_text()
    assert list(figures) == NUMBERS
    for figure in figures.values():
        assert figure["title"]
        assert figure["caption"] in page
        assert re.search(r"\d", figure["caption"]), "a claim is a number"
        assert figure["numbers"]


def test_every_number_is_finite(figures: Figures) -> None:
    found = [value for value in leaves(figures) if isinstance(value, int | float)]
    assert len(found) > 100
    assert all(math.isfinite(value) for value in found)


@pytest.mark.skipif(find_spec("polyscope") is None, reason="polyscope is not installed")
def test_pictures_need_no_display(tmp_path: Path) -> None:
    done = run("figures", "-o", tmp_path)
    if "nothing can be drawn" in done.stderr:
        pytest.skip(f"this machine cannot draw without a display: {done.stderr}")
    assert (done.returncode, done.stderr) == (0, "")
    page = (tmp_path / "figures.md").read_text()
    pictures = []
    for figure in json.loads((tmp_path / "figures.json").read_text())["figures"]:
        data = (tmp_path / figure["picture"]).read_bytes()
        assert data[:8] == b"\x89PNG\r\n\x1a\n"
        assert struct.unpack(">II", data[16:24]) == SIZE
        assert len(data) > 20_000, "a picture of one colour is far smaller"
        assert f"({figure['picture']})" in page
        assert figure["picture"] in done.stdout
        pictures.append(data)
    assert len(set(pictures)) == len(NUMBERS), "each shows something else"


def test_figure_5_is_the_same_surface_elsewhere(numbers: dict[str, dict[str, float]]) -> None:
    assert numbers["05"]["moved"] > 0.1
    assert numbers["05"]["distance_after_alignment"] < 1e-8


def test_figure_7_holds_both_handles(numbers: dict[str, dict[str, float]]) -> None:
    assert numbers["07"]["fixed_moved"] == 0
    assert numbers["07"]["hand_off_target"] < 1e-9
    assert numbers["07"]["arm_length"] > 1.3
    assert numbers["07"]["edges_folded_over"] == 0


def test_figure_9_folds_more_than_figure_8(numbers: dict[str, dict[str, float]]) -> None:
    assert numbers["09"]["inner_side"] < numbers["08"]["inner_side"] < 1
    for name in ("08", "09"):
        assert numbers[name]["rim_jump"] < 6, "smooth at the rim"
        assert numbers[name]["edges_folded_over"] == 0


def test_material_makes_the_elbow_thinner_and_its_inner_side_shrink(
    numbers: dict[str, dict[str, float]],
) -> None:
    soft, plain = numbers["09"], numbers["10"]
    assert soft["inner_side"] < plain["inner_side"] - 0.01
    assert soft["elbow_width"] < plain["elbow_width"] - 0.005
    assert abs(soft["narrowest_section"] - plain["narrowest_section"]) < 0.01, "not there, as said"


def test_nothing_is_wider_than_at_rest_without_material(
    numbers: dict[str, dict[str, float]],
) -> None:
    """What the caption of figure 10 says against the paper."""
    assert numbers["10"]["widest_section"] == pytest.approx(1, abs=1e-6)
    assert numbers["10"]["elbow_width"] < 1


def test_a_step_creases_the_rim(numbers: dict[str, dict[str, float]]) -> None:
    step = numbers["11"]
    assert step["rim_jump"] > 3 * step["rim_jump_if_smooth"]
    assert step["rim_jump"] > 3 * numbers["09"]["rim_jump"]


def test_too_soft_a_material_tears_the_elbow(numbers: dict[str, dict[str, float]]) -> None:
    torn, soft = numbers["12"], numbers["09"]
    assert torn["edges_folded_over"] > 0
    assert torn["largest_jump"] > 10 * soft["largest_jump"]
    assert torn["elbow_section"] < 0.2 * soft["elbow_section"]
    assert torn["least_triangle"] < 0.5 * soft["least_triangle"]


def test_rotations_keep_the_folded_elbow_full(numbers: dict[str, dict[str, float]]) -> None:
    linear, one, many = (numbers[name] for name in ("13a", "13b", "13c"))
    assert linear["elbow_section"] < one["elbow_section"] < many["elbow_section"]
    assert many["elbow_section"] > 0.75
    assert linear["volume"] < min(one["volume"], many["volume"])
    assert many["largest_jump"] < one["largest_jump"] < linear["largest_jump"]


def test_six_dabs_fill_the_arm_smoothly(numbers: dict[str, dict[str, float]]) -> None:
    field, folded = numbers["14a"], numbers["14b"]
    assert field["dabs"] == 6
    assert field["painted"] < field["filled"]
    assert (field["least"], field["most"]) == (0, 1)
    assert field["steepest"] < 0.5
    assert folded["bend_in_soft_part"] > 0.6
    assert folded["edges_folded_over"] == 0


def test_a_grab_meets_its_moments_and_stays_elastic(
    numbers: dict[str, dict[str, float]],
) -> None:
    grab = numbers["15"]
    assert grab["fixed_moved"] == 0
    assert grab["moments_missed"] < 1e-6
    assert grab["turn"] > 20
    assert grab["give"] > 1e-3, "not a rigid handle"
    assert grab["edges_folded_over"] == 0


def test_a_rigid_motion_changes_no_measure(arm: Arm, measure: ArmMeasures) -> None:
    T = turn(40.0, np.array([0.3, 1.0, 0.2]))
    still = dict.fromkeys(MEANING, 1.0) | dict.fromkeys(
        ("strain_rms", "rim_jump", "largest_jump", "edges_folded_over"), 0.0
    )
    found = measure(arm.V @ T[:3, :3].T + T[:3, 3])
    for name in MEANING.keys() - {"bend_in_soft_part"}:  # a straight arm has no bend to share
        assert found[name] == pytest.approx(still[name], abs=1e-5), name


def test_an_arm_made_deeper_is_measured_so(arm: Arm, measure: ArmMeasures) -> None:
    found = measure(arm.V * np.where(np.arange(3) == FOLD_AXIS, 1.5, 1.0))
    for name in ("elbow_depth", "elbow_section", "volume", "widest_section"):
        assert found[name] == pytest.approx(1.5, rel=1e-2), name
    assert found["elbow_width"] == pytest.approx(1, rel=1e-2)
    assert found["strain_rms"] > 0.1


def test_the_arm_is_closed_at_both_ends(measure: ArmMeasures) -> None:
    rest = measure.at_rest()
    assert rest["volume"] == pytest.approx(0.505 * rest["elbow_section"], rel=0.15)
