"""A question stands in the way of all but its answer."""

from __future__ import annotations

import numpy as np
import pytest

from app.editor import commands as c
from app.editor.question import CANCEL, Answer, Question
from tests.app.person import Person, state

REPLACE = Question("Replace it?", (Answer("Yes", c.SetTool("fixed")), CANCEL))


def test_mouse_and_keys_do_nothing_while_a_question_stands(ready: Person) -> None:
    editor = ready.editor
    ready.frame([10, 2, 0])
    before, seen = state(editor.document), editor.viewpoint.camera.position
    editor.ask(REPLACE)
    ready.stroke([19, 2, 0], [14, 9, 0])
    ready.frame([10, 2, 0], "s")
    ready.frame([14, 9, 0], "s", wheel=2.0)
    ready.do(c.ResetPose(), c.AddHandle("one"), c.SetTool("navigate"))
    assert state(editor.document) == before
    np.testing.assert_array_equal(editor.viewpoint.camera.position, seen)
    assert editor.tool == "drag"
    assert editor.question == REPLACE


@pytest.mark.parametrize(("label", "tool"), [("Yes", "fixed"), ("Cancel", "drag")])
def test_an_answer_does_what_it_says_and_the_hand_is_free_again(
    ready: Person, label: str, tool: str
) -> None:
    ready.editor.ask(REPLACE)
    ready.answer(label)
    assert ready.editor.question is None
    assert ready.editor.tool == tool
    ready.use("drag")
    ready.stroke([19, 2, 0], [14, 9, 0])
    (handle,) = ready.editor.document.handles
    assert not np.array_equal(ready.editor.document.pose.of(handle.key), np.eye(4))


def test_a_drag_in_progress_is_kept_and_ends(ready: Person) -> None:
    editor = ready.editor
    ready.frame([19, 2, 0], "pd")
    ready.frame([14, 9, 0], "d")
    editor.ask(REPLACE)
    assert editor.interaction is None
    assert len(editor.history.done) == 3
    ready.frame([10, 9, 0], "d")
    ready.answer("Cancel")
    before = state(editor.document)
    ready.frame([10, 9, 0], "d")
    assert state(editor.document) == before
