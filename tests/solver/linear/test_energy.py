"""The two forms of the energy, against each other and against its definition."""

from __future__ import annotations

import numpy as np
import pytest
import scipy.sparse as sp
from scipy.sparse.linalg import spsolve

from solver import Deformer, fundamental_forms
from solver.forms.residuals import reconstruction_residuals
from solver.geometry.cotangent_weights import (
    LARGEST,
    SMALLEST,
    bending_weights,
    half_edge_cotangents,
    heron,
    stretching_weights,
)
from solver.geometry.frames import triangle_frames
from solver.geometry.laplacian import cotangent_laplacian
from solver.geometry.motions import motion, rotation
from solver.geometry.topology import Topology
from solver.linear.assembly import deformation_matrix
from solver.types import FloatArray, IntArray
from tests.solver import shapes
from tests.solver.definition import Definition, Gains, resolved, stack
from tests.solver.forms.test_forms import SURFACES

L = 0.3


def random_state(F: IntArray, n: int, seed: int = 0) -> tuple[FloatArray, FloatArray]:
    rng = np.random.default_rng(seed)
    return rng.normal(size=(n, 3)), rng.normal(size=(len(F), 3, 3))


def random_gains(edges: IntArray, seed: int = 0) -> tuple[FloatArray, FloatArray, Gains]:
    beta, sigma = np.random.default_rng(seed).uniform(0.1, 2.0, (2, len(edges)))
    named = {(a, b): (s, t) for (a, b), s, t in zip(edges.tolist(), beta, sigma, strict=True)}
    return beta, sigma, named


def energy(K: sp.csc_array, U: FloatArray) -> float:
    return float(0.5 * np.einsum("ij,ij->", U, K @ U))


def three_leaves() -> shapes.Surface:
    """Three triangles on one edge, and a fourth beside one of them."""
    V = np.array([[0, 0, 0], [1, 0, 0], [0.4, 1, 0], [0.5, -1, 0.2], [0.3, 0.1, 1], [1.2, 1, 0.3]])
    return V, np.array([[0, 1, 2], [1, 0, 3], [0, 1, 4], [2, 1, 5]])


@pytest.mark.parametrize("name", SURFACES)
def test_energies_from_rest_and_from_forms_agree(name: str) -> None:
    V, F = SURFACES[name]
    topology = Topology(F, len(V))
    ones = np.ones(len(topology.edges))
    K = deformation_matrix(V, topology, L, (ones, ones))
    D, w = reconstruction_residuals(topology, fundamental_forms(V, F), L)
    for seed in range(5):
        X, G = random_state(F, len(V), seed)
        from_rest = energy(K, stack(X, G))
        from_forms = 0.5 * (w[:, None] * (D @ stack(X, G @ triangle_frames(V[F]).axes)) ** 2).sum()
        assert from_rest == pytest.approx(from_forms, rel=1e-9)


@pytest.mark.parametrize("name", [*SURFACES, "three leaves"])
def test_the_matrix_is_the_energy_as_defined(name: str) -> None:
    V, F = {**SURFACES, "three leaves": three_leaves()}[name]
    topology = Topology(F, len(V))
    beta, sigma, gains = random_gains(topology.edges)
    K = deformation_matrix(V, topology, L, (beta, sigma))
    definition = Definition(V, F, L, gains)
    for seed in range(3):
        U = stack(*random_state(F, len(V), seed))
        assert energy(K, U) == pytest.approx(definition.energy(U), rel=1e-9)


def test_the_matrix_is_symmetric_and_semi_definite() -> None:
    V, F = shapes.bumpy_plane(6)
    topology = Topology(F, len(V))
    K = deformation_matrix(V, topology, L, random_gains(topology.edges)[:2]).toarray()
    np.testing.assert_allclose(K, K.T, atol=1e-14 * np.abs(K).max())
    values = np.linalg.eigvalsh(K)
    assert values[0] > -1e-12 * values[-1]
    # Affine motions alone cost nothing: four for each axis.
    assert (values < 1e-10 * values[-1]).sum() == 4


def test_affine_motions_cost_nothing() -> None:
    V, F = shapes.sphere(1)
    topology = Topology(F, len(V))
    K = deformation_matrix(V, topology, L, random_gains(topology.edges)[:2])
    A, t = np.random.default_rng(3).normal(size=(2, 3, 3))
    U = stack(V @ A.T + t[0], np.broadcast_to(A, (len(F), 3, 3)))
    np.testing.assert_allclose(K @ U, 0, atol=1e-11)


@pytest.mark.parametrize("orientation", [True, False])
def test_the_gradient_vanishes_at_a_pose(orientation: bool) -> None:
    V, F = shapes.bar(6, 2)
    left, right = np.flatnonzero(V[:, 0] <= 1), np.flatnonzero(V[:, 0] >= 5)
    edges = fundamental_forms(V, F).edges
    beta, sigma, gains = random_gains(edges)
    deformer = Deformer(
        V, F, left, [right], orientation=orientation, edge_gains=(edges, beta, sigma)
    )
    T = motion(rotation([1, 2, 3], 70), [0.5, 1, -2], [3, 1, 1])
    U = stack(deformer.pose([T]), deformer.frames([T]))
    definition = Definition(V, F, resolved(V, F), gains)
    held = [np.isin(F, group).all(axis=1) & orientation for group in (left, right)]
    free = np.concatenate(
        [~np.isin(np.arange(len(V)), [*left, *right]), np.repeat(~(held[0] | held[1]), 3)]
    )
    assert_stationary(definition, U, free)


def test_the_gradient_vanishes_at_solve() -> None:
    V, F = shapes.bar(6, 2)
    left, right = np.flatnonzero(V[:, 0] <= 1), np.flatnonzero(V[:, 0] >= 5)
    targets = V[right] * [1, 2, 0.5] + np.sin(V[right][:, ::-1])
    X = Deformer(V, F, left, [right], orientation=False).solve(targets)
    np.testing.assert_array_equal(X[left], V[left])
    np.testing.assert_allclose(X[right], targets, atol=1e-12)
    definition = Definition(V, F, resolved(V, F))
    K = sp.csc_array(definition.D.T @ (definition.w[:, None] * definition.D.toarray()))
    n = len(V)
    rows = spsolve(K[n:][:, n:], -(K[n:][:, :n] @ X))  # the frames that suit X best
    free = np.concatenate([~np.isin(np.arange(n), [*left, *right]), np.ones(3 * len(F), bool)])
    assert_stationary(definition, np.vstack([X, rows]), free)


def assert_stationary(definition: Definition, U: FloatArray, free: np.ndarray) -> None:
    """No direction of the free rows changes E to first order; of the held rows, one does."""
    rng = np.random.default_rng(4)
    scale = definition.energy(U)
    for _ in range(20):
        direction = rng.normal(size=U.shape)
        direction *= np.sqrt(scale / definition.energy(direction))
        assert abs(definition.slope(U, free[:, None] * direction)) < 1e-8 * scale
    assert abs(definition.slope(U, ~free[:, None] * direction)) > 1e-4 * scale


@pytest.mark.parametrize(
    "V",
    [
        shapes.grid(8, 8)[0],
        shapes.grid(8, 8)[0] * [1, 1e-3, 1],
        shapes.grid(8, 8)[0] * [1, 1e-9, 1],
        shapes.grid(8, 8)[0] @ np.array([[1, 0, 0], [3, 1, 0], [0, 0, 1]]),
        shapes.grid(8, 8)[0] * [1, 0, 0],
        np.zeros((64, 3)),
    ],
    ids=["regular", "flat", "needles", "obtuse", "no area", "one point"],
)
def test_weights_are_positive_and_bounded(V: FloatArray) -> None:
    F = shapes.grid(8, 8)[1]
    topology = Topology(F, len(V))
    corners = V[F]
    lengths = np.linalg.norm(corners[:, [2, 0, 1]] - corners[:, [1, 2, 0]], axis=2)
    cot = half_edge_cotangents(lengths)
    assert np.isfinite(cot).all()
    pairs = topology.pairs
    sides = (pairs.first, pairs.half_first), (pairs.second, pairs.half_second)
    for weights in (stretching_weights(cot), bending_weights(cot, *sides)):
        assert weights.min() >= SMALLEST
        assert weights.max() <= LARGEST


def test_cotangents_are_those_of_the_angles() -> None:
    V, F = shapes.sphere()
    for corner, cot in zip(
        V[F],
        half_edge_cotangents(np.linalg.norm(V[F][:, [2, 0, 1]] - V[F][:, [1, 2, 0]], axis=2)),
        strict=True,
    ):
        for k in range(3):
            u, v = corner[(k + 1) % 3] - corner[k], corner[(k + 2) % 3] - corner[k]
            assert cot[k] == pytest.approx(u @ v / np.linalg.norm(np.cross(u, v)), abs=1e-9)


def test_heron_keeps_its_digits_on_needles() -> None:
    height = 1e-6
    side = np.hypot(0.5, height)
    assert heron(np.array([[side, 1.0, side]]))[0] == pytest.approx(height / 2, rel=1e-3)
    assert heron(np.array([[3.0, 4.0, 5.0]]))[0] == pytest.approx(6, rel=1e-15)
    assert heron(np.array([[1.0, 1.0, 3.0]]))[0] == 0  # no such triangle


def test_the_laplacian_kills_constants_and_is_linear_precise() -> None:
    V, F = shapes.grid(8, 8)
    jitter = np.random.default_rng(5).uniform(-0.15, 0.15, (len(V), 2))
    V[:, :2] += jitter
    L_ = cotangent_laplacian(V, F)
    np.testing.assert_allclose(L_ @ np.ones(len(V)), 0, atol=1e-12)
    assert np.linalg.eigvalsh(L_.toarray())[0] > -1e-12


def test_manifold_pairs_are_those_with_two_triangles() -> None:
    V, F = three_leaves()
    topology = Topology(F, len(V))
    assert len(topology.pairs.first) == 4  # three around the common edge, one beside
    assert topology.edges[topology.manifold_pairs.edge].tolist() == [[1, 2]]
