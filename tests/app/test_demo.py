"""The scripted person: what it saves, with graphics, without a display and without graphics."""

from __future__ import annotations

import json
import struct
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from app.bundled import DEFAULT_MESH
from app.demo import PICTURE_SIZE
from solver import load_mesh
from solver.types import FloatArray
from tests.app.command import WITHOUT_GRAPHICS, run

DEMO = ("before.png", "softness.png", "after.png")


@pytest.fixture(scope="module")
def saved(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder of a demo on a machine without any graphics library."""
    folder = tmp_path_factory.mktemp("saved") / "new"
    done = run("demo", "-o", folder, code=WITHOUT_GRAPHICS)
    assert done.returncode == 0, done.stderr
    assert done.stderr.startswith("no pictures: nothing can be drawn on this machine")
    assert done.stderr.count("\n") == 1
    assert sorted(p.name for p in folder.iterdir()) == ["demo.json", "demo.obj"]
    return folder


@pytest.fixture(scope="module")
def session(saved: Path) -> dict[str, Any]:
    return dict(json.loads((saved / "demo.json").read_text()))


@pytest.fixture(scope="module")
def rest() -> FloatArray:
    return load_mesh(DEFAULT_MESH).vertices


@pytest.fixture(scope="module")
def shown(saved: Path) -> FloatArray:
    return load_mesh(saved / "demo.obj").vertices


def test_the_body_has_not_moved_and_the_hand_is_where_it_was_put(
    session: dict[str, Any], rest: FloatArray, shown: FloatArray
) -> None:
    fixed, (handle,) = session["fixed"], session["handles"]
    assert set(np.flatnonzero(rest[:, 0] < -0.2)) <= set(fixed), "the other arm"
    np.testing.assert_array_equal(shown[fixed], rest[fixed])
    hand, T = handle["vertices"], np.array(handle["transform"])
    assert np.isin(np.flatnonzero(rest[:, 0] > 0.85), hand).mean() > 0.98
    expected = rest[hand] @ T[:3, :3].T + T[:3, 3]
    np.testing.assert_allclose(shown[hand], expected, rtol=0, atol=1e-9)
    assert np.linalg.norm(shown[hand] - rest[hand], axis=1).min() > 0.2


def test_the_elbow_has_folded_where_it_is_soft(
    session: dict[str, Any], rest: FloatArray, shown: FloatArray
) -> None:
    def bend(X: FloatArray) -> float:
        """Degrees between upper arm and forearm."""
        a, b, c, d = (
            X[np.abs(rest[:, 0] - x) < 0.02].mean(axis=0) for x in (0.28, 0.38, 0.56, 0.66)
        )
        cosine = (b - a) @ (d - c) / np.linalg.norm(b - a) / np.linalg.norm(d - c)
        return float(np.degrees(np.arccos(np.clip(cosine, -1, 1))))

    assert bend(rest) < 5
    assert bend(shown) > 60
    softness = np.array(session["softness"])
    assert softness[np.abs(rest[:, 0] - 0.465) < 0.02].min() > 0.5
    assert softness[rest[:, 0] < 0.2].max() == 0


def test_the_session_gives_the_same_surface_again(
    saved: Path, tmp_path: Path, shown: FloatArray
) -> None:
    out = tmp_path / "again.obj"
    done = run("deform", DEFAULT_MESH, "--session", saved / "demo.json", "-o", out)
    assert (done.returncode, done.stderr) == (0, "")
    np.testing.assert_allclose(load_mesh(out).vertices, shown, rtol=0, atol=1e-6)


@pytest.mark.skipif(find_spec("polyscope") is None, reason="polyscope is not installed")
def test_pictures_need_no_display(tmp_path: Path) -> None:
    done = run("demo", "-o", tmp_path)
    if "nothing can be drawn" in done.stderr:
        pytest.skip(f"this machine cannot draw without a display: {done.stderr}")
    assert (done.returncode, done.stderr) == (0, "")
    pictures = [(tmp_path / name).read_bytes() for name in DEMO]
    for name, data in zip(DEMO, pictures, strict=True):
        assert data[:8] == b"\x89PNG\r\n\x1a\n"
        assert struct.unpack(">II", data[16:24]) == PICTURE_SIZE
        assert len(data) > 30_000, "a picture of one colour is far smaller"
        assert name in done.stdout, "each is named with a caption"
    assert len(set(pictures)) == len(pictures), "each shows something else"
