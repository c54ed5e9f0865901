"""Kept poses in a session file: written, read again, and refused where they are wrong."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from app.model.document import Document
from app.model.handles import Pose
from app.model.poses import REST
from app.model.session.reading import read_session, to_document
from app.model.session.writing import write_session
from tests.app.model.test_session import HANDLE, IDENTITY, refusal, write
from tests.app.person import slab, state

FIST = {"name": "fist", "transforms": {"hand": IDENTITY}}


def posed(path: Path, *names: str) -> Document:
    """A document with handles of these names and two kept poses that move them."""
    random = np.random.default_rng(0)
    document = Document(slab(6, 3, 1.0), path)
    document.change("handles", tuple(document.new_handle(name) for name in names))
    for number, handle in enumerate(document.handles):
        document.change("role", handle.key, np.array([number]))
    keys = [handle.key for handle in document.handles]
    for name in ("fist", "läuft \n'\""):
        transforms = {key: np.eye(4) + np.vstack([random.random((3, 4)), [0] * 4]) for key in keys}
        kept = document.new_pose(Pose(transforms), name)
        document.change("poses", (*document.poses, kept))
    return document


def written(document: Document, path: Path) -> Document:
    write_session(path, document)
    return to_document(read_session(path), document.mesh, document.path)


def test_kept_poses_come_back_bit_for_bit_in_their_order(tmp_path: Path) -> None:
    document = posed(tmp_path / "arm.obj", "hand", "foot")
    again = written(document, tmp_path / "a.json")
    assert state(again) == state(document)
    assert REST not in {kept.key for kept in again.poses}
    data = json.loads((tmp_path / "a.json").read_text())
    assert [entry["name"] for entry in data["poses"]] == [kept.name for kept in document.poses]
    assert set(data["poses"][0]["transforms"]) == {"hand", "foot"}


def test_no_kept_poses_are_left_out(tmp_path: Path) -> None:
    write_session(tmp_path / "a.json", Document(slab(2, 2, 1.0), tmp_path / "arm.obj"))
    assert "poses" not in json.loads((tmp_path / "a.json").read_text())


def test_a_handle_that_is_not_named_is_at_rest(tmp_path: Path) -> None:
    path = write(tmp_path / "a.json", poses=[{"name": "fist", "transforms": {}}])
    document = to_document(read_session(path), slab(6, 3, 1.0), tmp_path / "m")
    assert document.poses[0].pose.at_rest


def test_handles_of_one_name_are_numbered_and_keep_their_poses(tmp_path: Path) -> None:
    document = posed(tmp_path / "arm.obj", "hand", "hand", "hand 2", "hand")
    again = written(document, tmp_path / "a.json")
    assert [h.name for h in again.handles] == ["hand", "hand 3", "hand 2", "hand 4"]
    assert [kept.pose for kept in again.poses] == [kept.pose for kept in document.poses]


REFUSED: list[tuple[dict[str, Any], str]] = [
    ({"poses": {}}, "^poses: expected a list"),
    ({"poses": [3]}, r"^poses\[0\]: expected an object, got 3"),
    ({"poses": [{"name": "a"}]}, r"^poses\[0\]\.transforms: missing"),
    ({"poses": [{"transforms": {}}]}, r"^poses\[0\]\.name: missing"),
    ({"poses": [{**FIST, "name": ""}]}, r"^poses\[0\]\.name: expected a text"),
    ({"poses": [{**FIST, "speed": 1}]}, r"^poses\[0\]\.speed: unknown key"),
    ({"poses": [{**FIST, "transforms": []}]}, r"^poses\[0\]\.transforms: expected an object"),
    (
        {"poses": [{**FIST, "transforms": {"two\nlines": IDENTITY[:3]}}]},
        r"^poses\[0\]\.transforms\.two\\nlines: expected 4x4 numbers",
    ),
    ({"poses": [FIST, FIST]}, r"^poses\[1\]\.name: expected each name once, got 'fist' twice"),
    (
        {"poses": [{**FIST, "transforms": {"foot": IDENTITY}}]},
        r"^poses\[0\]\.transforms: unknown handle 'foot', expected one of 'hand'$",
    ),
    (
        {"poses": [FIST], "handles": []},
        r"^poses\[0\]\.transforms: unknown handle 'hand', expected none$",
    ),
    (
        {"poses": [FIST], "handles": [HANDLE, {**HANDLE, "vertices": [9]}]},
        r"^poses\[0\]\.transforms: expected one handle of a name, got several of 'hand'",
    ),
]


@pytest.mark.parametrize(("changes", "text"), REFUSED, ids=[text for _, text in REFUSED])
def test_what_is_wrong_with_poses_is_refused_by_name(
    tmp_path: Path, changes: dict[str, Any], text: str
) -> None:
    message = refusal(write(tmp_path / "a.json", **changes), slab(6, 3, 1.0))
    assert re.search(text, message), message


def test_handles_of_one_name_without_poses_stay_readable(tmp_path: Path) -> None:
    path = write(tmp_path / "a.json", handles=[HANDLE, {**HANDLE, "vertices": [9]}])
    document = to_document(read_session(path), slab(6, 3, 1.0), tmp_path / "m")
    assert [handle.name for handle in document.handles] == ["hand", "hand"]
