"""A number that is typed may be of any size: the handle goes there, or a message says why not."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from app.editor import commands as c
from app.model.session.reading import read_session, to_document
from tests.app.person import Person, error_of, state
from tests.app.tools.gizmo.hand import BESIDE, type_in


@pytest.mark.parametrize(
    ("begin", "digits", "far"),
    [
        (c.MoveHandles(), "9999999", True),
        (c.MoveHandles(), "9" * 400, True),
        (c.MoveHandles(), "." + "1" * 400 + "9", False),
        (c.TurnHandles(), "9" * 400, False),
    ],
)
def test_what_is_typed_can_be_saved_and_read_again(
    ready: Person,
    tmp_path: Path,
    begin: c.Command,
    digits: str,
    far: bool,
    recwarn: pytest.WarningsRecorder,
) -> None:
    before = state(ready.editor.document)
    ready.frame(BESIDE)
    ready.do(begin)
    type_in(ready, f"x{digits}\n")
    assert ready.editor.interaction is None
    assert (state(ready.editor.document) == before) == far
    if far:
        assert "must move the surface by at most 5000 of its diagonals" in error_of(ready)
    ready.editor.settle()
    assert np.isfinite(ready.editor.positions).all()
    path = tmp_path / "bar.json"
    ready.do(c.SaveSession(path))
    mesh = ready.editor.document.mesh
    again = to_document(read_session(path), mesh, ready.editor.document.path)
    np.testing.assert_array_equal(
        again.pose.stacked(again.bound_keys),
        ready.editor.document.pose.stacked(ready.editor.document.bound_keys),
    )
    assert not list(recwarn)


@pytest.mark.parametrize("value", [1e30, -1e308])
def test_a_position_out_of_reach_is_a_message_and_moves_nothing(
    ready: Person, value: float, recwarn: pytest.WarningsRecorder
) -> None:
    before = state(ready.editor.document)
    ready.do(c.SetPosition(0, value))
    assert "handle 1 must move the surface by at most 5000 of its diagonals" in error_of(ready)
    assert state(ready.editor.document) == before
    assert not list(recwarn)


def test_a_rest_shape_that_throws_a_kept_pose_out_of_reach_is_not_made(ready: Person) -> None:
    document = ready.editor.document
    (handle,) = document.handles
    flat, wide = np.diag([1e-4, 1, 1, 1]), np.diag([900.0, 1, 1, 1])
    with ready.editor.edit("Stretch") as gesture:
        gesture.change("poses", (document.new_pose(document.pose.moved(handle.key, wide)),))
        gesture.change("pose", document.pose.moved(handle.key, flat))
    ready.editor.settle()
    before = state(document)
    ready.do(c.MakeRest())
    assert "handle 1 must have a linear part of entries up to 1000" in error_of(ready)
    assert state(document) == before
