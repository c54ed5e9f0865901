"""Turns in a session file: how often a handle went round, beside where it is."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from app.model.session.reading import read_session, to_document
from solver.geometry.motions import motion, rotation
from tests.app.model.test_session import HANDLE, IDENTITY, refusal, write
from tests.app.person import slab

ACROSS = motion(rotation([0, 0, 1], 180), [1.0, 2.0, 3.0]).tolist()
TURNED = {**HANDLE, "transform": ACROSS}
FIST = {"name": "fist", "transforms": {"hand": ACROSS}}


@pytest.mark.parametrize("halves", [1, -1, 3, -5, 199])
def test_a_turn_is_read_beside_its_transform(tmp_path: Path, halves: int) -> None:
    rounded = [0, 0, round(np.pi * halves, 3)]
    path = write(
        tmp_path / "a.json",
        handles=[{**TURNED, "turn": rounded}],
        poses=[{**FIST, "turns": {"hand": rounded}}],
    )
    document = to_document(read_session(path), slab(6, 3, 1.0), tmp_path / "m")
    key = document.handles[0].key
    for pose in (document.pose, document.poses[0].pose):
        np.testing.assert_allclose(pose.turn(key), [0, 0, np.pi * halves], atol=1e-9)
        np.testing.assert_array_equal(pose.of(key), ACROSS)


def test_without_one_a_handle_turned_the_shorter_way(tmp_path: Path) -> None:
    path = write(tmp_path / "a.json", handles=[TURNED], poses=[FIST])
    document = to_document(read_session(path), slab(6, 3, 1.0), tmp_path / "m")
    key = document.handles[0].key
    for pose in (document.pose, document.poses[0].pose):
        assert np.linalg.norm(pose.turn(key)) == pytest.approx(np.pi)


ELSEWHERE = "expected a turn to where the transform leads, got"
REFUSED: list[tuple[dict[str, Any], str]] = [
    ({"handles": [{**TURNED, "turn": [0, 0, 6.2832]}]}, rf"^handles\[0\]\.turn: {ELSEWHERE}"),
    ({"handles": [{**HANDLE, "turn": [0, 0, 1]}]}, rf"^handles\[0\]\.turn: {ELSEWHERE} \[0"),
    (
        {"handles": [], "pins": [{"vertices": [3], "turn": [1, 0, 0]}]},
        rf"^pins\[0\]\.turn: {ELSEWHERE}",
    ),
    ({"poses": [{**FIST, "turns": []}]}, r"^poses\[0\]\.turns: expected an object"),
    (
        {"poses": [{**FIST, "turns": {"two\nlines": [1, 2]}}]},
        r"^poses\[0\]\.turns\.two\\nlines: expected three numbers",
    ),
    (
        {"poses": [{**FIST, "turns": {"foot": [0, 0, 3.1416]}}]},
        r"^poses\[0\]\.turns: unknown handle 'foot', expected one of 'hand'$",
    ),
    (
        {"poses": [{**FIST, "turns": {"hand": [0, 0, 3]}}]},
        rf"^poses\[0\]\.turns\.hand: {ELSEWHERE}",
    ),
    ({"handles": [{**HANDLE, "transform": IDENTITY, "turn": True}]}, r"\.turn: expected three"),
]


@pytest.mark.parametrize(("changes", "text"), REFUSED, ids=[text for _, text in REFUSED])
def test_what_is_wrong_with_turns_is_refused_by_name(
    tmp_path: Path, changes: dict[str, Any], text: str
) -> None:
    message = refusal(write(tmp_path / "a.json", **changes), slab(6, 3, 1.0))
    assert re.search(text, message), message
