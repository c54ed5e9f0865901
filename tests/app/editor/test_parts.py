"""Several pieces: which follow, which are seen, and what the person is told of them."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from app.editor import commands as c
from app.workspace.parts import Parts
from solver import Mesh, load_mesh
from solver.types import IntArray
from tests.app.person import Person, sheet, slab, state


def with_buttons() -> Mesh:
    """A slab, a button that lies on it, and one far above it."""
    body, (V, F) = slab(20, 4, 2.0), sheet(1, 1)
    n = len(body.vertices)
    X = np.vstack([body.vertices, 0.5 * V + [10, 2, 0.05], 0.5 * V + [10, 2, 30]])
    return Mesh.from_arrays(X, np.vstack([body.faces, F + n, F + n + len(V)]))


@pytest.fixture
def person() -> Iterator[Person]:
    made = Person(with_buttons())
    made.ready_bar()
    yield made
    made.editor.close()


def own(person: Person, number: int) -> IntArray:
    return np.flatnonzero(person.editor.document.mesh.pieces == number)


def test_parts_are_listed_with_their_vertices(person: Person) -> None:
    counts = [part.count for part in person.editor.parts.all]
    assert counts == [len(own(person, number)) for number in range(3)]
    assert len({part.name for part in person.editor.parts.all}) == 3


def test_parts_have_the_names_that_their_file_gives_them(tmp_path: Path) -> None:
    corners = ("0 0 0", "1 0 0", "0 1 0", "0 0 5", "1 0 5", "0 1 5", "0 0 9", "1 0 9", "0 1 9")
    lines = [f"v {corner}\n" for corner in (*corners, "7 7 7", "8 7 7", "7 8 7")]
    lines += ["f 1 2 3\n", "g left eye # comment\n", "f 4 5 6\n", "g hair\n", "f 7 8 9\n"]
    (tmp_path / "a.obj").write_text("".join([*lines, "f 10 11 12\n"]))
    parts = Parts(load_mesh(tmp_path / "a.obj"))
    assert [part.name for part in parts.all] == ["piece 1", "left eye", "hair 3", "hair 4"]


def test_a_part_follows_until_it_is_told_to_stay(person: Person) -> None:
    rest = person.editor.document.mesh.vertices
    person.stroke([19, 2, 0], [16, 8, 0])
    assert np.abs(person.editor.positions - rest)[own(person, 1)].max() > 0.5
    before = state(person.editor.document)
    person.do(c.SetFollows(1, False))
    person.editor.settle()
    np.testing.assert_array_equal(person.editor.positions[own(person, 1)], rest[own(person, 1)])
    assert person.editor.history.done[-1].label == "piece 2: stays"
    person.do(c.Undo())
    assert state(person.editor.document) == before


def test_all_following_again_is_the_default(person: Person) -> None:
    person.do(c.SetFollows(1, False))
    seen = [person.editor.document.attach]
    person.do(c.SetFollows(1, True))
    seen.append(person.editor.document.attach)
    person.do(*(c.SetFollows(number, False) for number in range(3)))
    seen.append(person.editor.document.attach)
    assert seen == [[0, 2], True, False]


def test_a_hidden_part_is_neither_picked_nor_painted_and_still_follows(person: Person) -> None:
    editor, rest = person.editor, person.editor.document.mesh.vertices
    assert len(editor.scene().shaded.polygons) == len(editor.document.mesh.faces)
    person.do(c.ShowPart(1, False), c.ShowPart(2, False))
    assert len(editor.scene().shaded.polygons) == len(editor.document.mesh.faces) - 4
    person.use("fixed", 3)
    person.stroke([10.2, 2.2, 0.05])
    assert editor.document.role[own(person, 1)].max() == 0
    assert editor.document.role[own(person, 0)].max() > 0
    person.do(c.Undo())
    person.use("drag")
    person.stroke([19, 2, 0], [16, 8, 0])
    assert np.abs(editor.positions - rest)[own(person, 1)].max() > 0.5
    person.do(c.ShowPart(1, True))
    person.use("softness", 0.1)
    person.stroke(editor.positions[own(person, 1)].mean(axis=0))
    assert editor.document.softness[own(person, 1)].max() > 0


def test_the_last_part_stays_on_screen(person: Person) -> None:
    person.do(*(c.ShowPart(number, False) for number in range(3)))
    assert person.editor.parts.hidden == {0, 1}
    assert person.editor.message is not None
    assert "cannot be hidden" in person.editor.message.text


def test_the_hint_names_a_part_that_nothing_holds(person: Person) -> None:
    assert "nothing holds" not in person.editor.hint
    person.do(c.AddHandle("stray"))
    person.use("handle", 0.6)
    person.do(c.ShowPart(0, False), c.ShowPart(1, False))
    person.stroke([10.2, 2.2, 30])
    person.use("drag")
    person.editor.settle()
    assert person.editor.hint.endswith("nothing holds piece 3, so it moves as a whole")


@pytest.mark.parametrize("command", [c.ShowPart(7, True), c.SetFollows(-1, True)])
def test_parts_that_there_are_not_are_refused(person: Person, command: c.Command) -> None:
    before = state(person.editor.document)
    person.do(command)
    assert person.editor.message is not None
    assert "there is no piece" in person.editor.message.text
    assert state(person.editor.document) == before


def test_a_vertex_of_no_polygon_is_never_seen_and_all_is_framed_where_all_is_hidden() -> None:
    body = slab(4, 2, 1.0)
    parts = Parts(Mesh.from_arrays(np.vstack([body.vertices, [[9.0, 9, 9]]]), body.faces))
    used = np.arange(len(body.vertices))
    assert np.array_equal(np.flatnonzero(parts.visible), used)
    parts.show(0, False)
    assert not parts.visible.any()
    assert np.array_equal(parts.framed, used)
