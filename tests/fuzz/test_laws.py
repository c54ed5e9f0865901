"""Laws for whatever Hypothesis thinks of: surfaces, constraints, files, and what a person does."""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from app.editor import commands as c
from app.model.session.reading import read_session, to_document
from app.model.session.writing import write_session
from solver import Deformer, Material, Mesh, load_mesh
from solver.geometry.motions import motion, moved, rotation
from solver.types import FloatArray
from tests.app.editor.test_long_history import ACTS
from tests.app.person import Person, slab, state
from tests.solver import shapes

SIZE = 6
POINTS = SIZE * SIZE
V, F = shapes.grid(SIZE, SIZE)
numbers = st.floats(-1, 1, allow_subnormal=False)
shares = st.floats(0, 1, allow_subnormal=False)
gains = st.floats(1e-2, 1e2)


@st.composite
def bound(draw: st.DrawFn) -> tuple[FloatArray, Deformer]:
    """A bumpy sheet, each vertex free, fixed or of one of two handles, with any softness."""
    height = draw(st.lists(numbers, min_size=POINTS, max_size=POINTS))
    roles = np.array(draw(st.lists(st.integers(0, 5), min_size=POINTS, max_size=POINTS)))
    softness = draw(st.lists(shares, min_size=POINTS, max_size=POINTS))
    X = V + np.column_stack([np.zeros((POINTS, 2)), height])
    fixed, *handles = (np.flatnonzero(roles == number) for number in (1, 2, 3))
    assume(len(fixed) and all(len(handle) for handle in handles))
    options: dict[str, Any] = {
        "softness": softness,
        "material": Material(draw(gains), draw(gains)),
        "orientation": draw(st.booleans()),
    }
    return X, Deformer(X, F, fixed, handles, **options)


@st.composite
def motions(draw: st.DrawFn) -> FloatArray:
    """A rigid motion."""
    axis = np.array(draw(st.tuples(numbers, numbers, numbers)))
    assume(np.linalg.norm(axis) > 0.1)
    shift = [10 * x for x in draw(st.tuples(numbers, numbers, numbers))]
    return motion(rotation(axis, draw(st.floats(-180, 180))), shift)


@given(bound(), st.integers(0, 4))
def test_where_no_handle_moves_nothing_does(case: tuple[FloatArray, Deformer], level: int) -> None:
    X, deformer = case
    np.testing.assert_allclose(deformer.pose([np.eye(4)] * 2, level), X, atol=1e-7)


@given(bound(), motions(), st.integers(0, 3))
def test_one_motion_of_all_that_is_held_is_that_of_the_surface(
    case: tuple[FloatArray, Deformer], T: FloatArray, level: int
) -> None:
    X, deformer = case
    setup = deformer.setup
    every = deformer.rebind(fixed=(), handles=[*setup.handles, setup.fixed])
    np.testing.assert_allclose(every.pose([T] * 3, level), moved(T, X), atol=1e-6)


@given(bound(), motions(), motions())
def test_handles_lead_in_proportion(
    case: tuple[FloatArray, Deformer], A: FloatArray, B: FloatArray
) -> None:
    """Level 0 is linear: half-way between two poses is the pose of the transforms half-way."""
    _, deformer = case
    ends = [deformer.pose([T, T]) for T in (A, B)]
    middle = deformer.pose([(A + B) / 2] * 2)
    np.testing.assert_allclose(middle, sum(ends) / 2, atol=1e-7)


coordinates = st.floats(-1e18, 1e18)


@given(
    st.lists(st.tuples(*[coordinates] * 3), min_size=4, max_size=12),
    st.data(),
    st.sampled_from([".obj", ".off", ".ply"]),
)
def test_any_positions_and_polygons_come_back_bit_for_bit(
    points: list[tuple[float, float, float]], data: st.DataObject, suffix: str
) -> None:
    corner = st.integers(0, len(points) - 1)
    faces = data.draw(st.lists(st.tuples(*[corner] * 4), min_size=1, max_size=8))
    mesh = Mesh.from_arrays(points, faces)
    with tempfile.TemporaryDirectory() as folder:
        mesh.save(Path(folder) / f"a{suffix}", mesh.vertices)
        again = load_mesh(Path(folder) / f"a{suffix}")
    assert again.vertices.tobytes() == mesh.vertices.tobytes()
    assert np.array_equal(again.faces, mesh.faces)


deeds = st.lists(
    st.tuples(st.integers(0, len(ACTS) - 1), st.integers(0, 9)), min_size=1, max_size=8
)


def person_after(done: list[tuple[int, int]]) -> Person:
    """At the bar, after some of the acts of a person."""
    person = Person(slab(20, 4, 2.0))
    for act, seed in done:
        ACTS[act](person, np.random.default_rng(seed))
    return person


@given(deeds)
def test_whatever_was_done_is_undone_and_done_again_exactly(done: list[tuple[int, int]]) -> None:
    person = person_after(done)
    document, history = person.editor.document, person.editor.history
    before, after = state(Person(slab(20, 4, 2.0)).editor.document), state(document)
    while history.done:
        person.do(c.Undo())
    assert state(document) == before
    while history.undone:
        person.do(c.Redo())
    assert state(document) == after
    person.editor.close()


@given(deeds)
def test_whatever_was_done_is_in_the_session(done: list[tuple[int, int]]) -> None:
    document = person_after(done).editor.document
    with tempfile.TemporaryDirectory() as folder:
        first, second = Path(folder) / "first.json", Path(folder) / "second.json"
        write_session(first, document)
        again = to_document(read_session(first), document.mesh, document.path)
        write_session(second, again)
        assert first.read_bytes() == second.read_bytes()
    assert again.role.astype(bool).tobytes() == document.role.astype(bool).tobytes()
    assert again.softness.tobytes() == document.softness.tobytes()
    assert again.rest_positions.tobytes() == document.rest_positions.tobytes()
    assert [h.name for h in again.handles] == [h.name for h in document.handles]
    for old, new in zip(document.handles, again.handles, strict=True):
        assert document.pose.of(old.key) == pytest.approx(again.pose.of(new.key), abs=0)
