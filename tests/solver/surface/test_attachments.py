"""Pieces follow what they touch or are near, and cost nothing where everything moves as one."""

from __future__ import annotations

import numpy as np
import pytest

from solver import ConstraintError, Deformer, Setup
from solver.geometry.bounding_box import diagonal
from solver.geometry.motions import motion, moved, rotation
from solver.geometry.procrustes import rigid_motion
from solver.geometry.welding import weld_pieces
from solver.linear.binding import bind
from solver.linear.rest_surface import RestSurface
from solver.types import FloatArray, IntArray
from tests.solver import shapes
from tests.solver.shapes import Surface

T = motion(rotation([0, 0, 1], 30), [0.2, 0.3, 0], [4, 0, 0])


def ball(centre: tuple[float, float, float], radius: float) -> Surface:
    V, F = shapes.sphere(2)
    return radius * V + centre, F


def plate(x: float, y: float, z: float) -> Surface:
    """A flat piece of 0.4 x 0.4: a button."""
    V, F = shapes.grid(3, 3)
    return 0.2 * V + [x, y, z], F


TUBE = shapes.tube(40, 20)
ROOT, TIP = (np.flatnonzero(mask) for mask in (TUBE[0][:, 0] < 0.5, TUBE[0][:, 0] > 7.5))
# An eye that sits in the surface, a button that lies on it, a bead that hangs beside the button.
DRESSED = shapes.together(
    TUBE, ball((4, 1, 0), 0.3), plate(5, -0.2, 1.02), ball((5.2, 0.0, 1.3), 0.12)
)
FAR = shapes.together(TUBE, ball((4, 3, 0), 0.3))


def piece(number: int, surface: Surface = DRESSED) -> IntArray:
    return np.flatnonzero(weld_pieces(*surface)[1] == number)


def gap(X: FloatArray, one: IntArray, other: IntArray) -> float:
    """The mean distance of some vertices to the nearest of others, in diagonals of the tube."""
    away = np.linalg.norm(X[one][:, None] - X[other][None], axis=2).min(axis=1)
    return float(away.mean()) / diagonal(TUBE[0])


def touching(V: FloatArray, one: IntArray, other: IntArray) -> IntArray:
    """Those of some vertices that lie on one of the others."""
    away = np.linalg.norm(V[one][:, None] - V[other][None], axis=2).min(axis=1)
    return one[away < 1e-6]


@pytest.mark.parametrize("rigid", [0, 1, 4])
def test_pieces_follow_what_they_are_near(rigid: int) -> None:
    V, F = DRESSED
    X = Deformer(V, F, ROOT, [TIP]).pose([T], rigid)
    body = piece(0)
    for number in (1, 2):
        assert abs(gap(X, piece(number), body) - gap(V, piece(number), body)) < 0.003
    assert abs(gap(X, piece(3), piece(2)) - gap(V, piece(3), piece(2))) < 0.003
    left = Deformer(V, F, ROOT, [TIP], attach=False).pose([T], rigid)
    for number in (1, 2, 3):
        np.testing.assert_array_equal(left[piece(number)], V[piece(number)])


@pytest.mark.parametrize("rigid", [1, 4])
def test_small_pieces_keep_their_shape(rigid: int) -> None:
    V, F = DRESSED
    X = Deformer(V, F, ROOT, [TIP]).pose([T], rigid)
    for number in (1, 2, 3):
        rest, now = V[piece(number)], X[piece(number)]
        missed = moved(rigid_motion(rest, now), rest) - now
        assert np.linalg.norm(missed, axis=1).max() < 0.01 * diagonal(rest)


def test_the_body_hardly_feels_them() -> None:
    V, F = DRESSED
    X = Deformer(V, F, ROOT, [TIP]).pose([T], 1)
    alone = Deformer(*TUBE, ROOT, [TIP]).pose([T], 1)
    assert np.abs(X[piece(0)] - alone).max() < 0.01 * diagonal(V)


def test_a_piece_follows_through_another() -> None:
    """The bead is near the button alone: without the button's link it stays."""
    V, F = DRESSED
    X = Deformer(V, F, ROOT, [TIP], attach=[1, 3]).pose([T])
    assert np.abs(X - V)[piece(1)].max() > 0.1
    np.testing.assert_array_equal(X[piece(2)], V[piece(2)])
    np.testing.assert_array_equal(X[piece(3)], V[piece(3)])


def test_a_piece_that_is_dragged_pulls_what_it_is_attached_to() -> None:
    V, F = DRESSED
    eye = piece(1)
    X = Deformer(V, F, ROOT, [eye]).pose([motion(np.eye(3), [0, 0.5, 0])], 1)
    near = np.argsort(np.linalg.norm(V[piece(0)] - [4, 1, 0], axis=1))[:5]
    assert (X[near, 1] - V[near, 1]).min() > 0.3


@pytest.mark.parametrize("attach", [True, False])
def test_what_is_far_from_everything_stays(attach: bool) -> None:
    V, F = FAR
    X = Deformer(V, F, ROOT, [TIP], attach=attach).pose([T], 1)
    np.testing.assert_array_equal(X[piece(1, FAR)], V[piece(1, FAR)])
    alone = Deformer(*TUBE, ROOT, [TIP]).pose([T], 1)
    np.testing.assert_allclose(X[piece(0, FAR)], alone, atol=1e-8)


@pytest.mark.parametrize("rigid", [0, 1, 4])
def test_one_motion_of_all_that_is_held_moves_everything(rigid: int) -> None:
    V, F = DRESSED
    M = motion(rotation([1, 2, 3], 100), [1, 2, 3])
    X = Deformer(V, F, (), [ROOT, TIP]).pose([M, M], rigid)
    np.testing.assert_allclose(X, moved(M, V), atol=1e-7 * diagonal(V))


def test_an_affine_motion_of_everything_costs_nothing() -> None:
    rest = RestSurface.of(*DRESSED)
    K = bind(rest, Setup(fixed=[0, 1, 2], handles=[[50]])).system.matrix()
    A = np.random.default_rng(3).normal(size=(4, 3))
    U = rest.affine_rows @ A
    assert abs(np.sum(U * (K @ U))) < 1e-12 * np.abs(K).max() * np.sum(U**2)


def test_the_matrix_is_that_of_the_energy_written_out() -> None:
    rest = RestSurface.of(*DRESSED)
    joined = bind(rest, Setup(fixed=[0], handles=[[799]])).system.matrix()
    apart = bind(rest, Setup(fixed=[0], handles=[[799]], attach=False)).system.matrix()
    U = np.random.default_rng(4).normal(size=(rest.row_count, 3))
    found = 0.5 * np.sum(U * (joined @ U))
    length = rest.energy.resolved(0.01)
    # Without attachments the other pieces are left out: their own energy is added here.
    own = 0.0
    for number in (1, 2, 3):
        held = piece(number)[[0, -1]]
        alone = Setup(fixed=held[:1], handles=[held[1:]], attach=False)
        own += 0.5 * np.sum(U * (bind(rest, alone).system.matrix() @ U))
    expected = 0.5 * np.sum(U * (apart @ U)) + own + written_out(rest, U, length)
    assert found == pytest.approx(expected, rel=1e-9)


def written_out(rest: RestSurface, U: FloatArray, length: float) -> float:
    """The sum over attachments, term by term, with frames as columns."""
    n, a, total = len(rest.vertices), rest.attachments, 0.0
    G = U[n:].reshape(-1, 3, 3).transpose(0, 2, 1)
    for k in range(len(a)):
        corners = rest.faces[a.face[k]]
        q = a.barycentric[k] @ rest.points[corners]
        first = U[a.vertex[k]] - a.barycentric[k] @ U[corners]
        first -= G[a.face[k]] @ (rest.points[a.vertex[k]] - q)
        second = G[a.own_face[k]] - G[a.face[k]]
        total += 0.5 * a.weight[k] * float(first @ first + length**2 * np.sum(second**2))
    return total


def test_a_chair_stays_a_chair() -> None:
    """Legs that are fixed and a back that is dragged hold one seat between them."""
    boxes = [((0, 0, 0), (4, 4, 1)), ((0, -4, 0), (1, 4, 1)), ((3, -4, 0), (1, 4, 1))]
    boxes.append(((0, 4, 0), (4, 4, 1)))
    V, F = shapes.together(*(box(start, extent) for start, extent in boxes))
    legs = np.flatnonzero(V[:, 1] < -3)
    back = np.flatnonzero(V[:, 1] > 6)
    turn = motion(rotation([1, 0, 0], -30), centre=[2, 4, 0.5])
    X = Deformer(V, F, legs, [back]).pose([turn], 4)
    number = weld_pieces(V, F)[1]
    seat = np.flatnonzero(number == 0)
    for part in (1, 2, 3):
        contact = touching(V, np.flatnonzero(number == part), seat)
        assert len(contact) > 5
        assert gap(X, contact, seat) < 0.005


def box(start: tuple[float, ...], extent: tuple[float, ...]) -> Surface:
    V, F = shapes.bar(6, 6)
    V = (V - V.min(axis=0)) / np.ptp(V, axis=0)
    return start + V * extent, F


def test_pieces_that_there_are_not_are_refused() -> None:
    V, F = DRESSED
    with shapes.refuses(ConstraintError, "attach names piece 7, expected 0 to 3"):
        Deformer(V, F, ROOT, [TIP], attach=[1, 7])
    with shapes.refuses(ConstraintError, "attach must be a list"):
        Deformer(V, F, ROOT, [TIP], attach=[0.5])


def test_following_can_be_switched_without_another_mesh() -> None:
    V, F = DRESSED
    deformer = Deformer(V, F, ROOT, [TIP])
    expected = Deformer(V, F, ROOT, [TIP], attach=[2]).pose([T], 1)
    np.testing.assert_allclose(deformer.rebind(attach=[2]).pose([T], 1), expected, atol=1e-12)


def test_a_grab_on_a_piece_that_follows_takes_all_along() -> None:
    V, F = DRESSED
    weights = np.where(weld_pieces(V, F)[1] == 1, 1.0, 0.0)
    shift = motion(np.eye(3), [0.5, 1, 0])
    X = Deformer(V, F).grab(weights).pose([shift])
    np.testing.assert_allclose(X, V + [0.5, 1, 0], atol=1e-9)
