"""A mesh cut along seams deforms as the uncut one; what merely touches stays apart."""

from __future__ import annotations

import numpy as np
import pytest

from solver import ConstraintError, Deformer
from solver.geometry.bounding_box import diagonal
from solver.geometry.motions import motion, rotation
from solver.geometry.topology import Topology
from solver.geometry.welding import weld, weld_pieces
from solver.types import FloatArray, IntArray
from tests.solver import shapes

V, F = shapes.tube(24, 12)
ROOT, TIP = V[:, 0] < 1, V[:, 0] > 7
SOFTNESS = np.clip(1 - np.abs(V[:, 0] - 4), 0, 1)
T = motion(rotation([0, 0, 1], 70), [-1, 2, 0], [8, 0, 0])
rng = np.random.default_rng(4)


def cut(F: IntArray, patch: IntArray) -> tuple[IntArray, IntArray]:
    """The vertex each vertex of the cut mesh is a copy of, and its triangles.

    patch: (m,) a number for each triangle; each patch gets vertices of its own.
    """
    corners = np.column_stack([np.repeat(patch, 3), F.ravel()])
    copies, number = np.unique(corners, axis=0, return_inverse=True)
    return copies[:, 1], number.reshape(-1, 3)


PATCHES = {
    "two halves": (V[F].mean(axis=1)[:, 0] > 4).astype(int),
    "patches": rng.integers(0, 7, len(F)),
    "every triangle alone": np.arange(len(F)),
}


@pytest.mark.parametrize("patch", PATCHES.values(), ids=PATCHES)
@pytest.mark.parametrize("rigid", [0, 1, 3])
def test_a_cut_mesh_deforms_as_the_uncut_one(patch: IntArray, rigid: int) -> None:
    source, faces = cut(F, patch)

    def surface(V: FloatArray, F: IntArray, of: IntArray) -> Deformer:
        root, tip = (np.flatnonzero(mask[of]) for mask in (ROOT, TIP))
        return Deformer(V, F, root, [tip], SOFTNESS[of])

    whole, seamed = surface(V, F, np.arange(len(V))), surface(V[source], faces, source)
    expected = whole.pose([T], rigid)
    assert np.abs(seamed.pose([T], rigid) - expected[source]).max() < 1e-9 * diagonal(V)
    weights = np.exp(-((V[:, 0] - 5) ** 2))
    grabs = [motion(np.eye(3)), motion(rotation([1, 0, 0], 30), [0, 1, 0])]
    expected = whole.grab(weights).pose(grabs, rigid)
    actual = seamed.grab(weights[source]).pose(grabs, rigid)
    assert np.abs(actual - expected[source]).max() < 1e-9 * diagonal(V)


def test_targets_are_met_on_both_sides_of_a_seam() -> None:
    source, faces = cut(F, PATCHES["patches"])
    tip = np.flatnonzero(TIP[source])
    goal = V[source][tip] @ rotation([1, 0, 0], 20).T + [0.5, 0, 0]
    X = Deformer(V[source], faces, np.flatnonzero(ROOT[source]), [tip]).solve(goal, 1)
    np.testing.assert_allclose(X[tip], goal, atol=1e-12)
    again = Deformer(V, F, np.flatnonzero(ROOT), [np.flatnonzero(TIP)])
    whole = again.solve(V[TIP] @ rotation([1, 0, 0], 20).T + [0.5, 0, 0], 1)
    np.testing.assert_allclose(X, whole[source], atol=1e-9)


def test_one_side_of_a_seam_that_is_painted_holds_both() -> None:
    source, faces = cut(F, PATCHES["two halves"])
    seam = np.flatnonzero(np.bincount(source)[source] > 1)
    one = seam[seam < len(source) / 2]
    other = np.setdiff1d(seam, one)
    X = Deformer(V[source], faces, np.flatnonzero(ROOT[source]), [one]).pose([T])
    np.testing.assert_allclose(X[other], V[source][other] @ T[:3, :3].T + T[:3, 3], atol=1e-12)


def test_a_vertex_with_two_roles_is_refused_with_seams_too() -> None:
    source, faces = cut(F, PATCHES["patches"])
    with shapes.refuses(ConstraintError, "vertex 3 is both fixed and in handle 0"):
        Deformer(V[source], faces, [3], [[3, 4]])
    with shapes.refuses(ConstraintError, f"expected 0 to {len(source) - 1}"):
        Deformer(V[source], faces, [len(source)], [[4]])


def test_closed_surfaces_that_touch_stay_apart() -> None:
    W, G = shapes.bar(4, 2)
    two, faces = np.vstack([W, W + [4, 0, 0]]), np.vstack([G, G + len(W)])
    assert len(np.unique(weld(two, Topology(faces, len(two))))) == len(two)
    assert (weld_pieces(two, faces)[1] == np.repeat([0, 1], len(W))).all()


def test_places_a_billionth_apart_are_one_place() -> None:
    source, faces = cut(F, PATCHES["patches"])
    W = V[source] + 2e-10 * diagonal(V) * rng.uniform(-1, 1, (len(source), 3))
    welded = weld(W, Topology(faces, len(W)))
    assert len(np.unique(welded)) == len(V)
    np.testing.assert_array_equal(source[np.unique(welded, return_index=True)[1]][welded], source)


def test_pieces_are_counted_by_their_first_vertex_and_stray_vertices_have_none() -> None:
    source, faces = cut(F, PATCHES["every triangle alone"])
    W = np.vstack([[9.0, 9, 9], V[source] + [50, 0, 0], V, [7.0, 7, 7]])
    G = np.vstack([F + 1 + len(source), faces + 1])
    expected = np.repeat([-1, 0, 1, -1], [1, len(source), len(V), 1])
    np.testing.assert_array_equal(weld_pieces(W, G)[1], expected)
