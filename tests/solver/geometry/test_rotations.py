"""Nearest rotations against the singular value decomposition."""

from __future__ import annotations

import numpy as np
import pytest

from solver.geometry.motions import rotation
from solver.geometry.procrustes import procrustes, rigid_fit
from solver.geometry.rotations import nearest_rotations
from solver.types import FloatArray
from tests.solver import shapes

rng = np.random.default_rng(0)
COUNT = 2000


def rotations(count: int = COUNT) -> FloatArray:
    return np.stack([shapes.random_rotation(rng) for _ in range(count)])


def with_singular_values(values: FloatArray) -> FloatArray:
    return rotations(len(values)) * values[:, None, :] @ rotations(len(values))


UNIQUE = {
    "random": rng.normal(size=(COUNT, 3, 3)),
    "large": 1e8 * rng.normal(size=(COUNT, 3, 3)),
    "small": 1e-8 * rng.normal(size=(COUNT, 3, 3)),
    "near rotations": rotations() + 1e-3 * rng.normal(size=(COUNT, 3, 3)),
    "rotations": rotations(),
    "shrunk": with_singular_values(rng.uniform(0.3, 1, (COUNT, 3))),
    "rank 2": with_singular_values(rng.uniform(0.3, 1, (COUNT, 3)) * [1, 1, 0]),
    "mirrored": with_singular_values(
        rng.uniform([1, 0.5, 0.1], [2, 0.9, 0.4], (COUNT, 3)) * [1, 1, -1]
    ),
}
AMBIGUOUS = {
    "any singular values": with_singular_values(rng.uniform(-1, 1, (COUNT, 3))),
    "nearly ambiguous": with_singular_values(
        np.array([1, 1, -1]) + 10 ** rng.uniform(-8, 0, (COUNT, 1)) * rng.normal(size=(COUNT, 3))
    ),
    "rank 1": with_singular_values(np.tile([1.0, 0, 0], (COUNT, 1))),
    "zero": np.zeros((COUNT, 3, 3)),
    "reflections": -rotations(),
    "two equal, mirrored": with_singular_values(np.tile([2.0, 1, -1], (COUNT, 1))),
}


def nearest_by_svd(A: FloatArray) -> FloatArray:
    U, _, Vt = np.linalg.svd(A)
    sign = np.sign(np.linalg.det(U @ Vt))
    U[:, :, 2] *= sign[:, None]
    return np.asarray(U @ Vt)


@pytest.mark.parametrize("name", UNIQUE)
def test_the_nearest_rotation_is_that_of_the_decomposition(name: str) -> None:
    A = UNIQUE[name]
    values = np.linalg.svd(A, compute_uv=False)
    values[:, 2] *= np.sign(np.linalg.det(A))
    clear = values[:, 1] + values[:, 2] > 1e-3 * values[:, 0]  # else two rotations are as near
    assert clear.mean() > 0.95
    np.testing.assert_allclose(nearest_rotations(A)[clear], nearest_by_svd(A)[clear], atol=1e-9)


@pytest.mark.parametrize("name", [*UNIQUE, *AMBIGUOUS])
def test_the_result_is_a_rotation_and_none_is_nearer(name: str) -> None:
    A = {**UNIQUE, **AMBIGUOUS}[name]
    R = nearest_rotations(A)
    np.testing.assert_allclose(
        R @ R.transpose(0, 2, 1), np.tile(np.eye(3), (COUNT, 1, 1)), atol=1e-9
    )
    assert (np.linalg.det(R) > 0).all()
    values = np.linalg.svd(A, compute_uv=False)
    values[:, 2] *= np.sign(np.linalg.det(A))
    best = values.sum(axis=1)
    reached = np.einsum("tij,tij->t", R, A)
    np.testing.assert_allclose(reached, best, rtol=0, atol=1e-9 * np.abs(A).max())


def test_no_matrices_give_no_rotations() -> None:
    assert nearest_rotations(np.empty((0, 3, 3))).shape == (0, 3, 3)


def test_procrustes_maximises_the_trace() -> None:
    for M in np.concatenate([rng.normal(size=(20, 3, 3)), -rotations(5)]):
        R = procrustes(M)
        assert np.linalg.det(R) == pytest.approx(1)
        others = np.einsum("tij,ji->t", rotations(200), M)
        assert np.trace(R @ M) >= others.max()


@pytest.mark.parametrize("flatten", [[1, 1, 1], [1, 1, 0]], ids=["solid", "planar"])
def test_a_rigid_fit_finds_the_rotation(flatten: list[float]) -> None:
    points = rng.normal(size=(10, 3)) * flatten
    R = shapes.random_rotation(rng)
    np.testing.assert_allclose(rigid_fit(points, points @ R.T + 5), R, atol=1e-9)


def test_a_rigid_fit_turns_least_where_points_leave_it_open() -> None:
    np.testing.assert_allclose(rigid_fit(np.ones((1, 3)), np.zeros((1, 3))), np.eye(3), atol=1e-12)
    line = np.outer(np.arange(4.0), [1, 0, 0])
    R = rotation([0, 0, 1], 40)
    np.testing.assert_allclose(rigid_fit(line, line @ R.T), R, atol=1e-9)
