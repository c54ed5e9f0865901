"""Small meshes with a formula, rigid motions, and the shared data where it is present."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import ArrayLike

from solver.errors import SolverError
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


def quads(index: IntArray) -> IntArray:
    """Two triangles for each cell of an (r, c) array of vertex numbers."""
    a, b, c, d = (
        i.ravel() for i in (index[:-1, :-1], index[:-1, 1:], index[1:, 1:], index[1:, :-1])
    )
    return np.concatenate([np.column_stack([a, b, c]), np.column_stack([a, c, d])])


def grid(columns: int = 12, rows: int = 12) -> Surface:
    """A flat right-angled grid in the xy plane with unit cells: half its cotangents are zero."""
    x, y = np.meshgrid(np.arange(columns, dtype=float), np.arange(rows, dtype=float))
    V = np.column_stack([x.ravel(), y.ravel(), np.zeros(x.size)])
    return V, quads(np.arange(x.size).reshape(rows, columns))


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
    return V, quads(np.hstack([index, index[:, :1]]))[:, ::-1]


def bar(length: int = 10, side: int = 3) -> Surface:
    """The boundary of length x side x side unit cubes along x, normals outward."""
    counts = np.array([length, side, side])
    points: list[IntArray] = []
    triangles: list[IntArray] = []
    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        i, j = np.meshgrid(np.arange(counts[u] + 1), np.arange(counts[v] + 1), indexing="ij")
        for end in (0, 1):
            p = np.zeros((i.size, 3), dtype=np.int64)
            p[:, axis], p[:, u], p[:, v] = end * counts[axis], i.ravel(), j.ravel()
            local = quads(np.arange(i.size).reshape(i.shape))
            triangles.append((local[:, ::-1] if end else local) + sum(len(face) for face in points))
            points.append(p)
    lattice, first = np.unique(np.concatenate(points), axis=0, return_inverse=True)
    return lattice.astype(float), first.reshape(-1)[np.concatenate(triangles)][:, ::-1]


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


def rotation(axis: ArrayLike, degrees: float) -> FloatArray:
    """(3, 3), right-handed about `axis`. [Rodrigues]"""
    x, y, z = np.asarray(axis, dtype=float) / np.linalg.norm(axis)
    K = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    angle = np.radians(degrees)
    return np.asarray(np.eye(3) + np.sin(angle) * K + (1 - np.cos(angle)) * K @ K)


def random_rotation(rng: np.random.Generator) -> FloatArray:
    """Uniform on SO(3)."""
    w, x, y, z = (q := rng.normal(size=4)) / np.linalg.norm(q)
    return rotation([x, y, z], 2 * np.degrees(np.arctan2(np.linalg.norm([x, y, z]), w)))


def motion(R: FloatArray, t: ArrayLike = (0, 0, 0), centre: ArrayLike = (0, 0, 0)) -> FloatArray:
    """(4, 4): turn by R about `centre`, then move by t."""
    T = np.eye(4)
    T[:3, :3] = R
    T[:3, 3] = np.asarray(centre) - R @ np.asarray(centre) + np.asarray(t)
    return T


def moved(T: FloatArray, V: FloatArray) -> FloatArray:
    return np.asarray(V @ T[:3, :3].T + T[:3, 3])


def size(V: FloatArray) -> float:
    """The bounding box's diagonal."""
    return float(np.linalg.norm(np.ptp(V, axis=0)))


def aligned(X: FloatArray, V: FloatArray) -> FloatArray:
    """X after the rigid motion that takes it closest to V. [Kabsch 1976]"""
    x, v = X - X.mean(axis=0), V - V.mean(axis=0)
    A, _, B = np.linalg.svd(x.T @ v)
    D = np.diag([1, 1, np.sign(np.linalg.det(A @ B))])
    return np.asarray(x @ A @ D @ B + V.mean(axis=0))


def edge_strain(X: FloatArray, V: FloatArray, edges: IntArray) -> float:
    """Root mean square of l'/l - 1."""
    rest, now = (np.linalg.norm(Y[edges[:, 1]] - Y[edges[:, 0]], axis=1) for Y in (V, X))
    return float(np.sqrt(np.mean((now / rest - 1) ** 2)))
