"""Grabbing bare surface: it follows, and lets go; a click puts a pin."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from app.editor import commands as c
from app.model.handles import FIXED, FREE, GRAB
from app.model.session.reading import read_session, to_document
from tests.app.person import Person, state


@pytest.mark.parametrize("rigid", [0, 1, 4])
def test_bare_surface_follows_the_cursor_and_is_let_go_of(ready: Person, rigid: int) -> None:
    ready.do(c.SetSetting("rigid", rigid), c.SetBrush(radius=0.08))
    editor, rest = ready.editor, ready.editor.document.mesh.vertices
    before, entries = state(editor.document), len(editor.history.done)
    for _ in ready.hold([[10, 2, 0], [10, 4, 0], [10, 7, 0]]):
        pass
    middle = np.argmin(np.linalg.norm(rest - [10, 2, 0], axis=1))
    assert editor.positions[middle][1] > rest[middle][1] + 3
    held = np.isin(editor.document.role, (FIXED, editor.document.handles[0].key))
    np.testing.assert_allclose(editor.positions[held], rest[held], atol=1e-9)
    ready.frame([10, 7, 0], "r")
    editor.settle()
    assert state(editor.document) == before
    assert len(editor.history.done) == entries
    np.testing.assert_array_equal(editor.positions, rest)


def test_a_grab_of_a_bent_surface_goes_on_from_where_it_is(ready: Person) -> None:
    ready.do(c.SetSetting("rigid", 0))
    ready.stroke([19, 2, 0], [17, 7, 0])
    editor = ready.editor
    editor.settle()
    bent = editor.positions
    middle = int(np.argmin(np.linalg.norm(editor.document.mesh.vertices - [10, 2, 0], axis=1)))
    place = bent[middle]
    for _ in ready.hold([place, *2 * [place + [0.0, 0.4, 0.0]]]):
        pass
    moved = np.linalg.norm(editor.positions - bent, axis=1)
    assert 0.2 < moved[middle] < 0.8
    assert moved.max() < 1.2
    ready.frame(place, "r")
    editor.settle()
    np.testing.assert_allclose(editor.positions, bent, atol=1e-9)


def test_escape_takes_a_grab_back_and_nothing_follows_until_the_release(ready: Person) -> None:
    before = state(ready.editor.document)
    for _ in ready.hold([[10, 2, 0], [10, 6, 0]]):
        pass
    ready.do(c.CancelGesture())
    camera = ready.editor.viewpoint.camera
    ready.frame([12, 6, 0], "d")
    ready.frame([12, 6, 0], "r")
    assert state(ready.editor.document) == before
    np.testing.assert_array_equal(ready.editor.viewpoint.camera.forward, camera.forward)


def test_a_grab_that_is_kept_leaves_a_pin_there_as_one_entry(ready: Person) -> None:
    ready.do(c.SetKeep(True), c.SetSetting("rigid", 0))
    editor, entries = ready.editor, len(ready.editor.history.done)
    ready.stroke([10, 2, 0], [10, 4, 0], [10, 5, 0])
    editor.settle()
    document = editor.document
    assert document.grab is None
    assert GRAB not in document.pose.transforms
    pin = document.handles[-1]
    assert pin.pin
    T = document.pose.of(pin.key)
    np.testing.assert_allclose(T @ [10, 2, 0, 1], [10, 5, 0, 1], atol=1e-3)
    assert len(editor.history.done) == entries + 1
    ready.do(c.Undo())
    assert not any(handle.pin for handle in document.handles)


def test_nothing_painted_two_clicks_and_a_drag(bar: Person) -> None:
    """A person opens a mesh, clicks one end, clicks the other and drags."""
    bar.use("drag")
    bar.stroke([1, 2, 0])
    bar.stroke([19, 2, 0])
    editor, rest = bar.editor, bar.editor.document.mesh.vertices
    assert [handle.name for handle in editor.document.handles] == ["pin 1", "pin 2"]
    np.testing.assert_array_equal(editor.positions, rest)
    bar.stroke([19, 2, 0], [17, 6, 0], [15, 9, 0])
    editor.settle()
    one, two = (editor.document.vertices_of(h.key) for h in editor.document.handles)
    np.testing.assert_allclose(editor.positions[one], rest[one], atol=1e-9)
    T = editor.document.pose.of(editor.document.handles[1].key)
    np.testing.assert_allclose(T @ [19, 2, 0, 1], [15, 9, 0, 1], atol=1e-3)
    assert np.abs(editor.positions[two] - rest[two]).max() > 3
    assert len(editor.history.done) == 3


def test_a_pin_takes_free_vertices_alone_and_stands_where_the_surface_is(ready: Person) -> None:
    ready.do(c.SetSetting("rigid", 0), c.SetBrush(radius=0.2), c.SetPlacing(gizmo=False))
    ready.stroke([19, 2, 0], [18, 5, 0])
    editor = ready.editor
    editor.settle()
    held = editor.document.role != FREE
    shown = editor.positions
    place = shown[np.argmin(np.linalg.norm(editor.document.mesh.vertices - [15, 2, 0], axis=1))]
    ready.stroke(place)
    editor.settle()
    assert (editor.document.role != FREE).sum() > held.sum()
    pin = editor.document.handles[-1]
    assert not held[editor.document.vertices_of(pin.key)].any()
    vertices = editor.document.vertices_of(pin.key)
    away = np.linalg.norm((editor.positions - shown)[vertices], axis=1)
    assert np.sqrt((away**2).mean()) < 0.1, "as near as a rigid spot can be"


def test_pins_are_saved_and_read_again(bar: Person, tmp_path: Path) -> None:
    bar.use("drag")
    bar.stroke([1, 2, 0])
    bar.stroke([19, 2, 0])
    bar.stroke([19, 2, 0], [17, 6, 0])
    path = tmp_path / "a.json"
    bar.do(c.SaveSession(path))
    document, mesh = bar.editor.document, bar.editor.document.mesh
    session = read_session(path)
    assert [entry["name"] for entry in session.data["pins"]] == ["pin 1", "pin 2"]
    assert session.data["handles"] == []
    again = to_document(session, mesh, path)
    assert [(h.name, h.pin) for h in again.handles] == [("pin 1", True), ("pin 2", True)]
    for old, new in zip(document.handles, again.handles, strict=True):
        np.testing.assert_array_equal(document.vertices_of(old.key), again.vertices_of(new.key))
        np.testing.assert_array_equal(document.pose.of(old.key), again.pose.of(new.key))


def test_a_press_a_few_pixels_beside_a_handle_takes_it(ready: Person) -> None:
    """The right edge of the bar is at x = 20; from 60 units away a pixel is 0.06 wide."""
    ready.do(c.SetPlacing(gizmo=False))
    ready.frame([20.4, 2, 0])
    (border,) = ready.editor.cursor.outlines
    key = ready.editor.document.handles[0].key
    assert len(border.segments)
    for _ in ready.hold([[20.4, 2, 0], [18, 5, 0]]):
        assert ready.editor.captures
    ready.frame([18, 5, 0], "r")
    assert not np.array_equal(ready.editor.document.pose.of(key), np.eye(4))


def test_a_stroke_may_begin_a_few_pixels_beside_the_surface(bar: Person) -> None:
    bar.use("fixed", 1)
    bar.frame([20.6, 2, 0])
    assert bar.editor.cursor.outlines, "the brush shows what it would paint"
    bar.stroke([20.6, 2, 0])
    assert (bar.editor.document.role == FIXED).any()
    bar.do(c.Undo())
    for _ in bar.hold([[23.0, 2, 0]]):
        assert not bar.editor.captures, "farther away the camera moves"
