"""A session says which pieces follow, where not all do."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from app.model.document import Document
from app.model.schema import SessionError
from app.model.session.reading import read_session, to_document
from app.model.session.writing import write_session
from tests.app.person import slab


def test_a_piece_that_there_is_not_is_refused(tmp_path: Path) -> None:
    document = Document(slab(2, 2, 1.0), tmp_path / "arm.obj")
    document.change("attach", [0, 1])
    write_session(tmp_path / "a.json", document)
    with pytest.raises(SessionError, match=r"settings\.attach\[1\]: expected 0 to 0, got 1"):
        to_document(read_session(tmp_path / "a.json"), document.mesh, document.path)


@pytest.mark.parametrize("attach", [False, [], [0]])
def test_which_pieces_follow_is_kept_and_the_default_is_left_out(
    tmp_path: Path, attach: object
) -> None:
    document = Document(slab(2, 2, 1.0), tmp_path / "arm.obj")
    write_session(tmp_path / "a.json", document)
    assert "attach" not in json.loads((tmp_path / "a.json").read_text())["settings"]
    document.change("attach", attach)
    write_session(tmp_path / "a.json", document)
    again = to_document(read_session(tmp_path / "a.json"), document.mesh, document.path)
    assert again.attach == attach
    assert again.setup() == document.setup()
