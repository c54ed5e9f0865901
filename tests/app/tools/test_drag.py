"""Dragging a handle: what moves, what stays, what the cursor holds."""

from __future__ import annotations

import numpy as np
import pytest

from app.editor.commands import (
    ActivateHandle,
    AddHandle,
    ResetPose,
    SetSetting,
    SetTurn,
    Undo,
)
from app.model.handles import FIRST_HANDLE, FIXED, FREE
from solver.geometry.bounding_box import diagonal
from tests.app.person import Person, transforms
from tests.app.tools.dragging import check_constraints, with_fake


@pytest.mark.parametrize("turn", [True, False])
@pytest.mark.parametrize("rigid", [0, 1])
def test_handles_move_by_their_transform_and_fixed_vertices_stay(
    ready: Person, turn: bool, rigid: int
) -> None:
    ready.do(SetSetting("rigid", rigid), SetTurn(turn))
    for _ in ready.hold([[19, 2, 0], [18, 4, 0], [16, 8, 0]]):
        check_constraints(ready)
    ready.frame([16, 8, 0], "r")
    check_constraints(ready)
    R = transforms(ready.editor.document)[0][:3, :3]
    np.testing.assert_allclose(R @ R.T, np.eye(3), atol=1e-12)
    assert np.array_equal(R, np.eye(3)) != turn
    free = ready.editor.document.role == FREE
    rest = ready.editor.document.mesh.vertices
    assert np.abs(ready.editor.positions - rest)[free].max() > 1


def test_the_grabbed_point_stays_under_the_cursor_in_the_screens_plane(ready: Person) -> None:
    ready.stroke([19, 2, 0], [16, 8, 0])
    T = transforms(ready.editor.document)[0]
    np.testing.assert_allclose(
        T @ [19, 2, 0, 1], [16, 8, 0, 1], atol=1e-6 * diagonal(ready.editor.positions)
    )


def test_a_second_drag_goes_on_from_the_first(ready: Person) -> None:
    ready.do(SetTurn(False))
    ready.stroke([19, 2, 0], [18, 6, 0])
    ready.stroke([18, 6, 0], [17, 7, 0])
    transform = transforms(ready.editor.document)[0]
    np.testing.assert_allclose(transform[:3, 3], [-2, 5, 0], atol=1e-5)
    assert len(ready.editor.history.done) == 4  # two strokes, two drags


def test_a_drag_that_ends_at_a_rest_pose_equals_rest(ready: Person) -> None:
    ready.do(SetTurn(False))
    ready.stroke([19, 2, 0], [16, 8, 0])
    ready.do(Undo())
    rest = ready.editor.document.mesh.vertices
    np.testing.assert_array_equal(ready.editor.positions, rest)
    ready.stroke([19, 2, 0], [16, 8, 0])
    ready.do(ResetPose())
    np.testing.assert_array_equal(ready.editor.positions, rest)
    ready.do(Undo())
    assert np.abs(ready.editor.positions - rest).max() > 1


def test_a_click_moves_nothing_and_leaves_no_entry(ready: Person) -> None:
    entries = len(ready.editor.history.done)
    ready.stroke([19, 2, 0], [19, 2, 0])
    assert len(ready.editor.history.done) == entries
    np.testing.assert_array_equal(ready.editor.positions, ready.editor.document.mesh.vertices)


def test_the_dragged_handle_becomes_the_active_one(ready: Person) -> None:
    first = ready.editor.document.handles[0]
    ready.do(AddHandle("other"))
    assert ready.editor.active is not first
    ready.stroke([19, 2, 0], [18, 4, 0])
    assert ready.editor.active is not None
    assert ready.editor.active.key == first.key


def test_the_cursor_over_the_panel_holds_the_drag(ready: Person) -> None:
    ready.frame([19, 2, 0], "pd")
    ready.frame([18, 4, 0], "d")
    held = ready.editor.positions
    ready.frame(None, "d")
    assert ready.editor.captures
    assert ready.editor.positions is held


def test_a_cursor_at_rest_costs_no_pose(ready: Person) -> None:
    fake = with_fake(ready)
    for _ in ready.hold([[19, 2, 0], *[[18, 4, 0]] * 5]):
        pass
    assert len(fake.levels) == 1


def test_a_handle_painted_on_a_deformed_surface_does_not_jump_back(ready: Person) -> None:
    ready.stroke([19, 2, 0], [12, 10, 0])
    X = ready.editor.positions
    middle = X[np.argmin(np.linalg.norm(ready.editor.document.mesh.vertices - (10, 2, 0), axis=1))]
    ready.do(AddHandle("middle"))
    ready.use("handle", 1.2)
    ready.stroke(middle)
    ready.editor.settle()
    new = ready.editor.document.vertices_of(ready.editor.document.handles[1].key)
    rest = ready.editor.document.mesh.vertices
    assert len(new) > 2
    moved = np.abs(X - rest)[new].max()
    assert moved > 1
    assert np.abs(ready.editor.positions - X)[new].max() < 0.1 * moved
    check_constraints(ready)


def test_painting_fixed_returns_the_region_to_rest(ready: Person) -> None:
    ready.stroke([19, 2, 0], [16, 8, 0])
    X = ready.editor.positions
    middle = X[np.argmin(np.linalg.norm(ready.editor.document.mesh.vertices - (10, 2, 0), axis=1))]
    ready.use("fixed", 1.2)
    ready.stroke(middle)
    ready.editor.settle()
    check_constraints(ready)
    assert (ready.editor.document.role[X[:, 0] > 5] == FIXED).any()


def test_a_transform_that_flattens_can_still_be_dragged(ready: Person) -> None:
    """Session files may hold such transforms."""
    document = ready.editor.document
    flat = np.diag([1.0, 1.0, 0.0, 1.0])
    document.change("pose", document.pose.moved(document.handles[0].key, flat))
    ready.stroke([19, 2, 0], [17, 6, 0])
    assert np.isfinite(ready.editor.positions).all()
    assert ready.editor.history.done[-1].label == "Drag handle 1"


def test_handles_without_vertices_are_no_obstacle(ready: Person) -> None:
    first = ready.editor.document.handles[0].key
    ready.do(AddHandle("empty"), ActivateHandle(first))
    ready.stroke([19, 2, 0], [16, 8, 0])
    check_constraints(ready)
    assert (ready.editor.document.role == FIRST_HANDLE + 1).sum() == 0
