from __future__ import annotations

import itertools

import numpy as np
import pytest
from numpy.typing import ArrayLike

from app.editor.commands import SetBrush, Undo
from app.model.handles import FIRST_HANDLE, FIXED, FREE
from solver import Mesh
from tests.app.person import Person, sheet, slab

PATH = [[2.3, 4.1, 0.0], [16.2, 4.9, 0.0], [25.1, 15.3, 0.0]]


def along(path: list[list[float]], steps: int) -> list[ArrayLike]:
    """Each leg of a path in `steps` equal parts."""
    points: list[ArrayLike] = [path[0]]
    for a, b in itertools.pairwise(path):
        points += [np.add(a, np.subtract(b, a) * k / steps) for k in range(1, steps + 1)]
    return points


def person_on_sheet() -> Person:
    return Person(Mesh.from_arrays(*sheet(30, 20)))


@pytest.mark.parametrize("radius", [0.9, 2.37])
def test_fast_and_slow_strokes_along_one_path_paint_the_same(radius: float) -> None:
    roles, softness = [], []
    for steps in (1, 3, 80):
        person = person_on_sheet()
        person.use("fixed", radius)
        person.stroke(*along(PATH, steps))
        person.use("softness", radius)
        person.stroke(*along(PATH, steps))
        roles.append(person.editor.document.role)
        softness.append(person.editor.document.softness)
    assert (roles[0] == FIXED).sum() > 20
    for role, soft in zip(roles[1:], softness[1:], strict=True):
        np.testing.assert_array_equal(role, roles[0])
        np.testing.assert_allclose(soft, softness[0], atol=1e-6)


def test_a_fast_stroke_leaves_no_gap() -> None:
    person = person_on_sheet()
    person.use("fixed", 0.8)
    person.stroke([0, 10, 0], [30, 10, 0])
    row = person.editor.document.mesh.vertices[:, 1] == 10
    assert (person.editor.document.role[row] == FIXED).all()


def test_a_stroke_that_jumps_across_a_gap_paints_nothing_between() -> None:
    V, F = sheet(10, 10)
    far = V - (0, 0, 30)
    mesh = Mesh.from_arrays(np.vstack([V, far]), np.vstack([F, F + len(V)]))
    person = Person(mesh, eye=(0, 0, 100))
    person.use("fixed", 1.5)
    edge_of_far = person.eye + (np.array([10.2, 5, 0]) - person.eye) * 1.4
    person.stroke([9.7, 5, 0], edge_of_far)
    painted = mesh.vertices[person.editor.document.role == FIXED]
    near, other = painted[painted[:, 2] == 0], painted[painted[:, 2] < 0]
    assert len(near)
    assert (np.linalg.norm(near - [9.7, 5, 0], axis=1) < 2.2).all()
    assert len(other) == 0 or (other[:, 0] > 8).all()


def test_the_last_stroke_wins_and_one_vertex_has_one_role() -> None:
    person = person_on_sheet()
    document = person.editor.document
    person.use("fixed", 4)
    person.stroke([10, 10, 0])
    before = (document.role == FIXED).sum()
    person.use("handle", 2)
    person.stroke([10, 10, 0])
    assert (document.role == FIRST_HANDLE).sum() > 0
    assert (document.role == FIXED).sum() + (document.role == FIRST_HANDLE).sum() == before


def test_shift_erases_only_what_the_tool_paints() -> None:
    person = person_on_sheet()
    document = person.editor.document
    person.use("fixed", 2)
    person.stroke([10, 10, 0])
    person.use("handle", 2)
    person.stroke([16, 10, 0])
    handle = document.role == FIRST_HANDLE
    person.use("fixed", 30)
    person.stroke([13, 10, 0], shift=True)
    assert not (document.role == FIXED).any()
    np.testing.assert_array_equal(document.role == FIRST_HANDLE, handle)
    person.use("handle", 30)
    person.stroke([13, 10, 0], shift=True)
    assert (document.role == FREE).all()


def test_the_first_handle_stroke_makes_the_handle_in_the_same_entry() -> None:
    person = person_on_sheet()
    person.use("handle", 2)
    person.stroke([10, 10, 0])
    assert [h.name for h in person.editor.document.handles] == ["handle 1"]
    person.do(Undo())
    assert person.editor.document.handles == ()
    assert not person.editor.document.role.any()


def test_softness_keeps_the_largest_weight_of_a_stroke() -> None:
    """Rubbing in one place is the same as touching it once; the next stroke adds to it."""
    once, often = person_on_sheet(), person_on_sheet()
    for person in (once, often):
        person.use("softness", 4)
        person.do(SetBrush(strength=0.5, value=0.8))
    once.stroke([10, 10, 0])
    often.stroke(*[[10, 10, 0]] * 5)
    np.testing.assert_array_equal(once.editor.document.softness, often.editor.document.softness)
    assert once.editor.document.softness.max() == pytest.approx(0.4)
    once.stroke([10, 10, 0])
    assert once.editor.document.softness.max() == pytest.approx(0.6)
    once.do(SetBrush(strength=1.0))
    once.stroke([10, 10, 0], shift=True)
    assert once.editor.document.softness[10 * 31 + 10] == pytest.approx(0, abs=1e-9)


def test_softness_shows_during_the_stroke() -> None:
    person = person_on_sheet()
    person.use("softness", 4)
    seen = [
        (person.editor.document.softness.sum(), person.editor.colors_version)
        for _ in person.hold([[5, 10, 0], [10, 10, 0], [15, 10, 0]])
    ]
    assert seen[0][0] < seen[1][0] < seen[2][0]
    assert len({version for _, version in seen}) == 3


def test_painting_reaches_the_surface_on_screen_not_the_rest_shape(ready: Person) -> None:
    ready.stroke([20, 2, 0], [20, 2, 6])
    document, positions = ready.editor.document, ready.editor.positions
    end = positions[document.role == FIRST_HANDLE].mean(axis=0)
    ready.use("softness", 1.0)
    ready.stroke(np.add(end, [0, 0, 1]))
    soft = np.flatnonzero(document.softness)
    assert len(soft)
    assert (positions[soft, 0] > 12).all()


def test_a_thin_slab_is_painted_on_one_side() -> None:
    person = Person(slab(20, 20, 0.1))
    person.use("fixed", 3)
    person.stroke([7, 7, 0], [13, 13, 0])
    fixed = np.flatnonzero(person.editor.document.role)
    assert len(fixed) > 50
    assert fixed.max() < 21 * 21
