"""Softness and bending length mean the same on every mesh of a shape."""

from __future__ import annotations

import numpy as np
import pytest

from benchmarks.cases.limbs import OUTLINES, SoftLimb, limb
from benchmarks.resolution.curves import TRIANGULATIONS, Curve, measure
from solver import Deformer
from solver.geometry.cotangent_weights import (
    REGULAR,
    bending_weights,
    half_edge_cotangents,
    typical_edge,
)
from solver.geometry.motions import motion, rotation
from solver.linear.rest_surface import RestSurface
from tests.solver import shapes

# The coarsest has four edges from the middle of the soft band to its rim.
SIZES = (32, 20), (64, 44)
FINE = 128, 88


def all_curves(shape: str, bending_length: float) -> list[Curve]:
    meshes = [(t, *size) for size in SIZES for t in TRIANGULATIONS]
    return [measure(t, limb(shape, t, *n), bending_length) for t, *n in [*meshes, ("right", *FINE)]]


@pytest.mark.parametrize("shape", OUTLINES)
@pytest.mark.parametrize("bending_length", [0.01, 0.05])
def test_curves_of_all_meshes_lie_on_each_other(shape: str, bending_length: float) -> None:
    found = all_curves(shape, bending_length)
    for what in ("linear", "rigid", "dragged"):
        shares = np.array([getattr(curve, what) for curve in found])
        np.testing.assert_allclose(shares / shares.mean(axis=0), 1, atol=0.05, err_msg=what)
    turns = np.array([curve.turn for curve in found])
    assert np.ptp(turns, axis=0).max() < 3


@pytest.mark.parametrize("triangulation", TRIANGULATIONS)
def test_softer_gathers_more(triangulation: str) -> None:
    hinge = measure("", limb("tube", triangulation, *SIZES[0])).linear[:5]
    assert (np.diff(hinge) > 0).all()


@pytest.mark.parametrize("degrees", [45, 90, 150])
def test_a_carried_tip_turns_as_far_on_every_mesh(degrees: float) -> None:
    for rings, around in ((16, 8), (40, 20), (100, 40)):
        V, F = shapes.tube(rings, around)
        deformer = Deformer(V, F, np.flatnonzero(V[:, 0] < 1), [np.flatnonzero(V[:, 0] > 7)])
        root, tip = np.array([1.0, 0, 0]), np.array([8.0, 0, 0])
        target = root + rotation([0, 0, 1], degrees) @ (tip - root)
        T = deformer.orient(0, tip, target, [np.eye(4)])
        assert np.degrees(np.arctan2(T[1, 0], T[0, 0])) == pytest.approx(degrees, abs=5)


@pytest.mark.parametrize("scale", [1e-4, 1e4])
def test_the_files_scale_does_not_matter(scale: float) -> None:
    one = limb("bar", "irregular", *SIZES[0])
    big = SoftLimb(scale * one.V, one.F)
    root, tip, T = one.root, one.tip, motion(rotation([0, 0, 1], 60))
    for softness in (0.5 * one.softness, one.softness):
        X, Y = (Deformer(m.V, m.F, root, [tip], softness).pose([T], 1) for m in (one, big))
        np.testing.assert_allclose(Y / scale, X, atol=1e-8)


def test_a_length_below_an_edge_is_taken_for_an_edge() -> None:
    one = limb("tube", "right", *SIZES[0])
    shape = RestSurface.of(one.V, one.F)
    edge = typical_edge(np.linalg.norm(shape.energy.vectors, axis=2))
    T = [motion(rotation([0, 0, 1], 60))]
    shorter, shortest, equal, longer = (
        Deformer(one.V, one.F, one.root, [one.tip], bending_length=length)
        for length in (0.5 * edge, 1e-6, edge, 2 * edge)
    )
    X = equal.pose(T)
    np.testing.assert_allclose(shorter.pose(T), X, atol=1e-12)
    np.testing.assert_allclose(shortest.pose(T), X, atol=1e-12)
    assert abs(longer.pose(T) - X).max() > 1e-3
    np.testing.assert_allclose(
        shortest.rebind(bending_length=2 * edge).pose(T), longer.pose(T), atol=1e-9
    )


def test_a_few_large_triangles_do_not_change_a_typical_edge() -> None:
    small = np.random.default_rng(0).uniform(0.9, 1.1, (100, 3))
    floor = np.full((2, 3), 1e3)
    edge = typical_edge(small)
    assert 0.9 < edge < 1.1
    assert typical_edge(np.vstack([small, floor])) == pytest.approx(edge, rel=0.01)
    assert typical_edge(np.full((5, 3), 7.0)) == pytest.approx(7)
    assert typical_edge(np.empty((0, 3))) == 0


def pair_weights(one: SoftLimb) -> np.ndarray:
    shape = RestSurface.of(one.V, one.F)
    pairs = shape.topology.pairs
    cotangents = half_edge_cotangents(np.linalg.norm(shape.energy.vectors, axis=2))
    return bending_weights(
        cotangents, (pairs.first, pairs.half_first), (pairs.second, pairs.half_second)
    )


def test_regular_triangles_keep_their_cotangents() -> None:
    np.testing.assert_allclose(pair_weights(SoftLimb(*shapes.tetrahedron())), REGULAR, rtol=1e-12)


def test_no_link_is_stiffer_than_the_sum_of_a_triangles_cotangents() -> None:
    # Legs of a right-angled grid have cotangent 1, diagonals 0; three cotangents make 2.
    w = pair_weights(SoftLimb(*shapes.grid(6, 5)))
    diagonals = 5 * 4
    assert np.count_nonzero(np.isclose(w, 0.5)) == diagonals
    assert np.count_nonzero(np.isclose(w, 1)) == len(w) - diagonals


def test_a_limbs_section_tells_its_turn() -> None:
    one = limb("tube", "irregular", *SIZES[0])
    angle = 10 * one.V[:, 0]
    c, s = np.cos(np.radians(angle)), np.sin(np.radians(angle))
    X = np.column_stack([-s * one.V[:, 1], c * one.V[:, 1], one.V[:, 2]])
    assert one.turn(X, 0.7) == pytest.approx(7, abs=0.2)
    assert one.share(X, 40) == pytest.approx(50, abs=1)
