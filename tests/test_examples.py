"""The examples, run as anyone would run them: what they save does what they say."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from app.bundled import ASSETS
from solver import Mesh, fundamental_forms, load_mesh
from solver.types import FloatArray

ROOT = Path(__file__).resolve().parents[1]
EXAMPLES = sorted(path for path in (ROOT / "examples").glob("*.py") if path.stem != "__init__")


def run(name: str, folder: Path, *words: str | Path) -> str:
    """What the example prints; its files are in `folder`."""
    done = subprocess.run(
        [sys.executable, ROOT / "examples" / f"{name}.py", folder, *words],
        env=os.environ | {"PYTHONPATH": str(ROOT)},
        cwd=folder,
        capture_output=True,
        text=True,
        check=False,
        timeout=120,
    )
    assert (done.returncode, done.stderr) == (0, "")
    return done.stdout


def saved(path: Path, rest: Mesh) -> FloatArray:
    """The positions in a file with the polygons of `rest`."""
    mesh = load_mesh(path)
    assert mesh.outlines.tolist() == rest.outlines.tolist()
    return mesh.vertices


def numbers(line: str) -> float:
    """The number a line ends with."""
    return float(line.split()[-1])


def test_a_bar_bends_and_higher_levels_keep_its_lengths_better(tmp_path: Path) -> None:
    strains = [numbers(line) for line in run("bend_a_bar", tmp_path).splitlines()]
    assert strains[0] > strains[1] > strains[2]
    bar = load_mesh(ASSETS / "bar.obj")
    V, x = bar.vertices, bar.vertices[:, 0]
    fixed, end = x < x.min() + 0.4, x > x.max() - 0.4
    centre = V.mean(axis=0)
    turned = (V[end] - centre)[:, [1, 0, 2]] * [-1, 1, 1] + centre
    for level in (0, 1, 4):
        X = saved(tmp_path / f"bar-{level}.obj", bar)
        np.testing.assert_array_equal(X[fixed], V[fixed])
        np.testing.assert_allclose(X[end], turned, atol=1e-9)


def bending(V: FloatArray, X: FloatArray, F: np.ndarray, near: np.ndarray) -> float:
    """The part of all change of dihedral angles that is on edges with both ends `near`."""
    before, after = fundamental_forms(V, F), fundamental_forms(X, F)
    change = np.abs(after.dihedral_angles - before.dihedral_angles)
    return float(change[near[before.edges].all(axis=1)].sum() / change.sum())


def test_a_soft_elbow_gathers_the_fold(tmp_path: Path) -> None:
    turn = float(run("soft_elbow", tmp_path).split()[-2])
    assert 60 < turn < 100
    arm = load_mesh(ASSETS / "arm.obj")
    V, x = arm.vertices, arm.vertices[:, 0] / arm.vertices[:, 0].max()
    soft, uniform = (saved(tmp_path / f"{name}.obj", arm) for name in ("soft", "uniform"))
    for X in (soft, uniform):
        np.testing.assert_array_equal(X[x < 0.1], V[x < 0.1])
        hand = x > 0.75  # carried rigidly
        span = np.linalg.norm(V[hand] - V[hand][0], axis=1)
        np.testing.assert_allclose(np.linalg.norm(X[hand] - X[hand][0], axis=1), span, atol=1e-9)
    near = abs(x - 0.42) < 0.1
    assert bending(V, soft, arm.faces, near) > 1.2 * bending(V, uniform, arm.faces, near)


def test_a_region_grabbed_later_goes_where_it_is_asked_to(tmp_path: Path) -> None:
    run("grab_anywhere", tmp_path)
    cactus = load_mesh(ASSETS / "cactus.obj")
    V = cactus.vertices
    X = saved(tmp_path / "cactus.obj", cactus)
    height = V[:, 1] - V[:, 1].min()
    size = height.max()
    foot = height < 0.1 * size
    np.testing.assert_array_equal(X[foot], V[foot])
    distance = np.linalg.norm(V - V[height.argmax()], axis=1)
    weights = np.clip(1 - distance / (0.15 * size), 0, None)
    mean = weights @ (X - V) / weights.sum()
    np.testing.assert_allclose(mean, [0.3 * size, -0.05 * size, 0], atol=1e-6)


def test_forms_rebuild_a_surface_and_roll_a_sheet_into_a_tube(tmp_path: Path) -> None:
    run("reconstruct_from_forms", tmp_path)
    plane = load_mesh(ASSETS / "bumpy_plane.obj")
    forms = fundamental_forms(plane.vertices, plane.faces)
    again = fundamental_forms(saved(tmp_path / "rebuilt.obj", plane), plane.faces)
    np.testing.assert_allclose(again.lengths, forms.lengths, rtol=1e-7)
    np.testing.assert_allclose(again.dihedral_angles, forms.dihedral_angles, atol=1e-6)
    # A prism over a regular polygon of 24 unit sides, 12 high: all corners on one cylinder.
    tube = load_mesh(tmp_path / "tube.obj").vertices
    rings = tube.reshape(13, 25, 3)
    np.testing.assert_allclose(rings[:, 0], rings[:, -1], atol=1e-8)
    radius = np.linalg.norm(rings[:, :-1] - rings[:, :-1].mean(axis=1, keepdims=True), axis=2)
    np.testing.assert_allclose(radius, 0.5 / np.sin(np.pi / 24), atol=1e-8)


def test_a_batch_goes_on_after_a_bad_file(tmp_path: Path) -> None:
    (tmp_path / "bad.off").write_text("no mesh")
    (tmp_path / "out").mkdir()
    files = [ASSETS / "dog.obj", tmp_path / "bad.off", ASSETS / "cylinder.obj"]
    lines = run("batch_over_files", tmp_path / "out", *files).splitlines()
    assert [line.split(":")[0] for line in lines] == [path.name for path in files]
    assert "skipped" in lines[1]
    assert {path.name for path in (tmp_path / "out").iterdir()} == {"dog.obj", "cylinder.obj"}
    for path in (files[0], files[2]):
        rest = load_mesh(path)
        V, X = rest.vertices, saved(tmp_path / "out" / path.name, rest)
        axis = int(np.ptp(V, axis=0).argmax())
        along = (V[:, axis] - V[:, axis].min()) / np.ptp(V[:, axis])
        np.testing.assert_array_equal(X[along < 0.1], V[along < 0.1])
        assert np.abs(X - V)[along > 0.9].max() > 0.05


def test_a_batch_without_files_takes_those_of_the_program(tmp_path: Path) -> None:
    run("batch_over_files", tmp_path)
    written = {path.name for path in tmp_path.iterdir()}
    assert written == {path.name for path in ASSETS.glob("*.obj")}


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_every_example_is_short_listed_and_tested(path: Path) -> None:
    assert len(path.read_text(encoding="utf-8").splitlines()) < 50
    assert path.name in (ROOT / "examples" / "README.md").read_text(encoding="utf-8")
    assert f'run("{path.stem}"' in Path(__file__).read_text(encoding="utf-8")
