"""Laws of poses with respect to another rest shape, and the rest shape in a session file."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from app.model.document import Document
from app.model.handles import Pose
from app.model.rest import affine_fit, composed, flattens, seen_from
from app.model.session.reading import read_session, to_document
from app.model.session.writing import write_session
from solver.geometry.motions import motion, moved, rotation
from tests.app.model.test_session import refusal, write
from tests.app.person import slab

R = motion(rotation([1, 2, 3], 70), [1.0, -2, 0.5])
T = np.eye(4) + np.vstack([np.random.default_rng(0).random((3, 4)), np.zeros(4)])


def test_seen_from_a_pose_is_what_leads_from_there_and_composing_leads_back() -> None:
    pose, rest = Pose({2: T, 3: R}), Pose({2: R, 4: T})
    seen = seen_from(pose, rest)
    for key in (2, 3, 4):
        np.testing.assert_allclose(seen.of(key) @ rest.of(key), pose.of(key), atol=1e-14)
        np.testing.assert_array_equal(seen.of(key)[3], [0, 0, 0, 1])
    back = composed(seen, rest.transforms)
    for key in (2, 3, 4):
        np.testing.assert_allclose(back.of(key), pose.of(key), atol=1e-14)
    assert seen_from(pose, pose).at_rest


def test_only_a_map_that_loses_a_dimension_flattens() -> None:
    assert flattens(np.diag([1.0, 1, 0, 1]))
    assert flattens(np.zeros((4, 4)))
    assert not flattens(np.diag([1e-30, 1e-30, 1e-30, 1]))
    assert not flattens(T)


@pytest.mark.parametrize("count", [1, 2, 3, 12])
@pytest.mark.parametrize("map_", [R, T], ids=["rigid", "affine"])
def test_points_are_taken_where_they_are_and_what_they_leave_open_is_rigid(
    count: int, map_: Any
) -> None:
    points = np.random.default_rng(1).random((count, 3))
    found = affine_fit(points, moved(map_, points))
    np.testing.assert_allclose(moved(found, points), moved(map_, points), atol=1e-12)
    if count == 12:
        np.testing.assert_allclose(found, map_, atol=1e-12)
    if map_ is R:
        np.testing.assert_allclose(found[:3, :3] @ found[:3, :3].T, np.eye(3), atol=1e-12)


def test_a_rest_shape_comes_back_bit_for_bit(tmp_path: Path) -> None:
    document = Document(slab(6, 3, 1.0), tmp_path / "arm.obj")
    write_session(tmp_path / "a.json", document)
    assert '"rest"' not in (tmp_path / "a.json").read_text()
    positions = np.random.default_rng(2).normal(size=document.mesh.vertices.shape)
    document.change("rest", document.new_rest(positions))
    write_session(tmp_path / "a.json", document)
    again = to_document(read_session(tmp_path / "a.json"), document.mesh, document.path)
    np.testing.assert_array_equal(again.rest_positions, positions)
    assert again.surface_number != document.surface_number


REFUSED: list[tuple[Any, str]] = [
    (0.5, "^rest: expected a list, got 0.5"),
    ([0.0] * 56, r"^rest\[0\]: expected three numbers, got 0.0"),
    ([[0, 0, 0], [0, 0]], r"^rest\[1\]: expected three numbers"),
    ([[0, 0, True]], r"^rest\[0\]: expected three numbers"),
    ([[0, 0, 0]] * 55, "^rest: expected 56 positions, one a vertex, got 55"),
]


@pytest.mark.parametrize(("rest", "text"), REFUSED, ids=[text for _, text in REFUSED])
def test_a_wrong_rest_shape_is_refused_by_name(tmp_path: Path, rest: Any, text: str) -> None:
    message = refusal(write(tmp_path / "a.json", rest=rest), slab(6, 3, 1.0))
    assert re.search(text, message), message
