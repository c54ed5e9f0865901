"""Meshes with a formula: bar, cylinder, bumpy plane. All y up, closed ones with outward normals."""

from __future__ import annotations

import numpy as np

from solver.types import FloatArray, IntArray


def grid_triangles(index: IntArray) -> IntArray:
    """Triangles of an (r, c) array of vertex numbers; diagonals alternate, so none is favoured."""
    a, b, c, d = index[:-1, :-1], index[1:, :-1], index[1:, 1:], index[:-1, 1:]
    even = np.indices(a.shape).sum(axis=0) % 2 == 0
    one = np.where(even[..., None], np.stack((a, b, c), -1), np.stack((a, b, d), -1))
    two = np.where(even[..., None], np.stack((a, c, d), -1), np.stack((b, c, d), -1))
    return np.concatenate((one.reshape(-1, 3), two.reshape(-1, 3)))


def regular_triangles(index: IntArray) -> IntArray:
    """Triangles of an (r, c) array of vertex numbers, all diagonals one way."""
    a, b, c, d = (
        i.ravel() for i in (index[:-1, :-1], index[1:, :-1], index[1:, 1:], index[:-1, 1:])
    )
    return np.concatenate((np.stack((a, b, c), axis=1), np.stack((a, c, d), axis=1)))


def bar(length: float = 4.0, side: float = 0.5, across: int = 8) -> tuple[FloatArray, IntArray]:
    """A box along x with a square section, cut into `across` cells across and cubes along."""
    counts = np.array([round(length / side * across), across, across])
    corners: list[IntArray] = []
    triangles: list[IntArray] = []
    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        i, j = np.indices((counts[u] + 1, counts[v] + 1))
        for end in (0, 1):
            points = np.zeros((i.size, 3), dtype=np.int64)
            points[:, axis], points[:, u], points[:, v] = end * counts[axis], i.ravel(), j.ravel()
            local = grid_triangles(np.arange(i.size).reshape(i.shape))
            triangles.append((local if end else local[:, ::-1]) + sum(map(len, corners)))
            corners.append(points)
    lattice, first = np.unique(np.concatenate(corners), axis=0, return_inverse=True)
    V = (lattice - counts / 2) * side / across
    return V, first.reshape(-1)[np.concatenate(triangles)]


def disc_triangles(rings: int) -> IntArray:
    """A disc as a centre and `rings` rings of 6, 12, 18, ... vertices, numbered from the centre."""
    parts: list[IntArray] = []
    for k in range(rings):
        inner, outer = (3 * k * (k - 1) + 1 if k else 0), 3 * k * (k + 1) + 1
        sector, j = np.divmod(np.arange(6 * (k + 1)), k + 1)
        a, b = outer + np.arange(6 * (k + 1)), outer + (np.arange(6 * (k + 1)) + 1) % (6 * (k + 1))
        parts.append(np.stack((a, b, inner + (sector * k + j) % max(6 * k, 1)), axis=1))
        if k:
            sector, j = np.divmod(np.arange(6 * k), k)
            a, b = inner + np.arange(6 * k), inner + (np.arange(6 * k) + 1) % (6 * k)
            parts.append(np.stack((b, a, outer + sector * (k + 1) + j + 1), axis=1))
    return np.concatenate(parts)


def disc(rings: int, radius: float, turn: float) -> FloatArray:
    """(n, 2) places of the vertices of `disc_triangles`; `turn` is in radians."""
    k = np.repeat(np.arange(1, rings + 1), 6 * np.arange(1, rings + 1))
    along = np.concatenate([np.arange(6 * i) / (6 * i) for i in range(1, rings + 1)])
    angle = 2 * np.pi * along + turn
    ring = radius * k[:, None] / rings * np.stack((np.cos(angle), np.sin(angle)), axis=1)
    return np.concatenate((np.zeros((1, 2)), ring))


def cylinder(
    length: float = 4.0, radius: float = 0.5, rings: int = 7
) -> tuple[FloatArray, IntArray]:
    """A closed cylinder along x: near-equilateral triangles on the side, rings on the caps."""
    around = 6 * rings
    step = 2 * np.pi / around
    rows = round(length / (radius * step * np.sqrt(0.75))) + 1
    row, i = np.divmod(np.arange(rows * around), around)
    angle = (i + row / 2) * step
    side = np.stack((length * row / (rows - 1), radius * np.cos(angle), radius * np.sin(angle)), 1)
    here, there = row * around + i, row * around + (i + 1) % around
    low = np.stack((here, there, here + around), axis=1)[:-around]
    high = np.stack((there, there + around, here + around), axis=1)[:-around]

    inside = 1 + 3 * rings * (rings - 1)
    caps: list[IntArray] = []
    middles: list[FloatArray] = []
    for x, first, turn in ((0.0, 0, 0.0), (length, (rows - 1) * around, (rows - 1) * step / 2)):
        flat = disc(rings, radius, turn)[:inside]
        middles.append(np.column_stack((np.full(inside, x), flat)))
        start = rows * around + len(caps) * inside
        number = np.concatenate((start + np.arange(inside), first + np.arange(around)))
        cap = number[disc_triangles(rings)]
        caps.append(cap if x else cap[:, ::-1])
    V = np.concatenate((side, *middles)) - [length / 2, 0, 0]
    return V, np.concatenate((low, high, *caps))


def bumpy_plane(side: float = 2.0, cells: int = 55) -> tuple[FloatArray, IntArray]:
    """An open square sheet with five by five smooth bumps, flat at its border."""
    x, z = side * (np.indices((cells + 1, cells + 1)).reshape(2, -1) / cells - 0.5)
    wave = np.cos(5 * np.pi * x / side) ** 2 * np.cos(5 * np.pi * z / side) ** 2
    V = np.stack((x, 0.035 * side * wave, z), axis=1)
    return V, grid_triangles(np.arange((cells + 1) ** 2).reshape(cells + 1, -1))[:, ::-1]
