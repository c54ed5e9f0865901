"""A session written in pieces while the person works on: the same text, of one moment."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from app.model.document import Document
from app.model.session.pieces import COUNT, json_pieces
from app.model.session.reading import read_session
from app.model.session.writing import session_pieces
from tests.app.person import slab

LONG = np.random.default_rng(0).normal(size=(2 * COUNT + 3, 3))


@pytest.mark.parametrize(
    ("value", "same"),
    [
        (LONG, LONG.tolist()),
        (np.arange(COUNT), list(range(COUNT))),
        (np.zeros((0, 3)), []),
        (iter([{"a": LONG[:, 0]}, {}]), [{"a": LONG[:, 0].tolist()}, {}]),
        (iter([]), []),
        ({"one": [1, 2.5, None, True], "two": {"three": 'x"\n'}}, None),
    ],
)
def test_the_pieces_are_what_json_writes(value: Any, same: Any) -> None:
    assert "".join(json_pieces(value)) == json.dumps(value if same is None else same)


def test_no_piece_is_long() -> None:
    assert max(map(len, json_pieces(LONG))) < 100 * COUNT


@pytest.mark.parametrize("value", [np.array([1.0, np.nan]), [float("inf")]])
def test_what_is_not_finite_is_refused(value: Any) -> None:
    with pytest.raises(ValueError, match="not JSON compliant"):
        list(json_pieces(value))


def test_what_is_done_meanwhile_does_not_show(tmp_path: Path) -> None:
    document = Document(slab(3, 3, 1.0), tmp_path / "m.obj")
    document.change("role", 1, np.arange(5))
    document.change("softness", 0.5, np.arange(5, 9))
    whole = b"".join(session_pieces(document, {"path": "m.obj"}))
    pieces = session_pieces(document.frozen(), {"path": "m.obj"})
    begun = [next(pieces) for _ in range(3)]
    document.change("role", 0, np.arange(5))
    document.change("softness", 1.0, np.arange(9))
    document.change("handles", (document.new_handle(),))
    assert b"".join([*begun, *pieces]) == whole
    (tmp_path / "a.json").write_bytes(whole)
    assert read_session(tmp_path / "a.json").data["fixed"] == [0, 1, 2, 3, 4]
