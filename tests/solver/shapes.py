"""Small meshes with a formula, and the shared data where it is present."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import numpy as np
import pytest

from assets.generator import primitives
from solver.errors import SolverError
from solver.geometry.motions import rotation
from solver.types import FloatArray, IntArray

SHARED = Path(__file__).resolve().parents[2] / ".." / "shared" / "meshes"

Surface = tuple[FloatArray, IntArray]


def shared(name: str) -> Path:
    """A file of the shared data; skips the test where it is missing."""
    path = SHARED / name
    if not path.exists():
        pytest.skip(f"{name} is not there: the shared meshes are no part of the project")
    return path


@contextmanager
def refuses(error: type[SolverError], text: str) -> Iterator[None]:
    """Expects `error` with `text` in a message of one line."""
    with pytest.raises(error) as caught:
        yield
    message = str(caught.value)
    assert text in message
    assert "\n" not in message


def grid(columns: int = 12, rows: int = 12) -> Surface:
    """A flat right-angled grid in the xy plane with unit cells: half its cotangents are zero."""
    x, y = np.meshgrid(np.arange(columns, dtype=float), np.arange(rows, dtype=float))
    V = np.column_stack([x.ravel(), y.ravel(), np.zeros(x.size)])
    return V, primitives.regular_triangles(np.arange(x.size).reshape(rows, columns).T)


def bumpy_plane(size: int = 15) -> Surface:
    V, F = grid(size, size)
    V[:, 2] = np.sin(0.9 * V[:, 0]) * np.cos(0.7 * V[:, 1]) + 0.1 * V[:, 0]
    return V, F


def tube(rings: int = 24, around: int = 12, radius: float = 1.0, length: float = 8.0) -> Surface:
    """An open cylinder along x, normals outward."""
    i, k = np.meshgrid(np.arange(rings), np.arange(around), indexing="ij")
    angle = 2 * np.pi * k / around
    x = length * i / (rings - 1)
    V = np.stack([x, radius * np.cos(angle), radius * np.sin(angle)], axis=2).reshape(-1, 3)
    index = (i * around + k).astype(np.int64)
    return V, primitives.regular_triangles(np.hstack([index, index[:, :1]]).T)


def bar(length: int = 10, side: int = 3) -> Surface:
    """The boundary of length x side x side unit cubes along x, normals outward."""
    V, F = primitives.bar(length, side, across=side)
    return V - V.min(axis=0), F


def tetrahedron() -> Surface:
    """Regular, edges of 2 sqrt 2, normals outward."""
    V = np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]], dtype=float)
    return V, np.array([[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]])


def sphere(subdivisions: int = 2) -> Surface:
    """A tetrahedron split and blown up to the unit sphere: uneven, some triangles obtuse."""
    V, F = tetrahedron()
    for _ in range(subdivisions + 1):
        ends = np.sort(F[:, [[1, 2], [2, 0], [0, 1]]].reshape(-1, 2), axis=1)
        edges, which = np.unique(ends, axis=0, return_inverse=True)
        a, b, c = (which.reshape(-1, 3) + len(V)).T
        V = np.vstack([V, V[edges].mean(axis=1)])
        i, j, k = F.T
        parts = [(i, c, b), (c, j, a), (b, a, k), (a, b, c)]
        F = np.concatenate([np.column_stack(part) for part in parts])
    return V / np.linalg.norm(V, axis=1, keepdims=True), F


def random_rotation(rng: np.random.Generator) -> FloatArray:
    """Uniform on SO(3)."""
    w, x, y, z = (q := rng.normal(size=4)) / np.linalg.norm(q)
    return rotation([x, y, z], 2 * np.degrees(np.arctan2(np.linalg.norm([x, y, z]), w)))


def aligned(X: FloatArray, V: FloatArray) -> FloatArray:
    """X after the rigid motion that takes it closest to V. [Kabsch 1976]"""
    x, v = X - X.mean(axis=0), V - V.mean(axis=0)
    A, _, B = np.linalg.svd(x.T @ v)
    D = np.diag([1, 1, np.sign(np.linalg.det(A @ B))])
    return np.asarray(x @ A @ D @ B + V.mean(axis=0))


def together(*surfaces: Surface) -> Surface:
    """Several surfaces as one mesh."""
    starts = np.cumsum([0, *(len(V) for V, _ in surfaces)])
    faces = [F + start for (_, F), start in zip(surfaces, starts[:-1], strict=True)]
    return np.concatenate([V for V, _ in surfaces]), np.concatenate(faces)
