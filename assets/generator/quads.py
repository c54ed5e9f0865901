"""A toy dog of quads: a few blocks, rounded by subdivision, with UVs and groups."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from solver.types import FloatArray, IntArray

# Block edges along x (across), y (up) and z (length, nose at +z).
GRID = (
    (-0.30, -0.11, 0.11, 0.30),
    (0.00, 0.13, 0.40, 0.62, 0.86, 1.10, 1.30, 1.56),
    (-1.05, -0.80, -0.45, 0.05, 0.50, 0.80, 1.05, 1.35),
)
# Blocks (x, y, z) of each group, as half-open ranges.
GROUPS = {
    "body": [((0, 3), (2, 4), (1, 5))],
    "legs": [((x, x + 1), (0, 2), (z, z + 1)) for x in (0, 2) for z in (1, 4)],
    "head": [((0, 3), (4, 6), (4, 6)), ((1, 2), (4, 5), (6, 7))],
    "ears": [((x, x + 1), (6, 7), (4, 5)) for x in (0, 2)],
    "tail": [((1, 2), (4, 6), (1, 2))],
}
SIDES = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])


@dataclass(frozen=True)
class QuadMesh:
    """Quads Q (m, 4) over vertices V, a number in `names` for each, and UVs of each corner."""

    V: FloatArray
    Q: IntArray
    group: IntArray
    uv: FloatArray
    names: tuple[str, ...]


def blocks() -> QuadMesh:
    """The surface of the blocks; every quad gets a tile of its own in the unit UV square."""
    shape = tuple(len(g) - 1 for g in GRID)
    owner = np.full(shape, -1)
    for number, ranges in enumerate(GROUPS.values()):
        for box in ranges:
            owner[tuple(slice(*r) for r in box)] = number
    corners, group = _boundary(np.pad(owner, 1, constant_values=-1))
    lattice, index = np.unique(corners.reshape(-1, 3), axis=0, return_inverse=True)
    V = np.stack([np.asarray(g)[lattice[:, a]] for a, g in enumerate(GRID)], axis=1)
    n = int(np.ceil(np.sqrt(len(group))))
    tile = np.stack(np.divmod(np.arange(len(group)), n), axis=1)[:, None, ::-1]
    uv = (tile + 0.05 + 0.9 * SIDES[:, :2]) / n
    return QuadMesh(V, index.reshape(-1, 4), group, uv, tuple(GROUPS))


def _boundary(owner: IntArray) -> tuple[IntArray, IntArray]:
    """Lattice corners (m, 4, 3), counter-clockwise from outside, and owners of the open sides."""
    corners, group = [], []
    for axis in range(3):
        for direction in (1, -1):
            cells = np.argwhere((owner >= 0) & (np.roll(owner, -direction, axis) < 0))
            order = [(axis + 1) % 3, (axis + 2) % 3, axis]
            square = np.zeros((4, 3), dtype=np.int64)
            square[:, order] = SIDES + np.array([0, 0, direction > 0])
            corners.append(cells[:, None] - 1 + square[::direction])
            group.append(owner[tuple(cells.T)])
    return np.concatenate(corners), np.concatenate(group)


def subdivide(mesh: QuadMesh) -> QuadMesh:
    """One step of Catmull and Clark's subdivision; UVs are split evenly."""
    V, Q = mesh.V, mesh.Q
    n, m = len(V), len(Q)
    ends = np.sort(np.stack((Q, np.roll(Q, -1, axis=1)), axis=-1).reshape(-1, 2), axis=1)
    edges, side = np.unique(ends, axis=0, return_inverse=True)
    side = side.reshape(m, 4)
    centre = V[Q].mean(axis=1)
    middle = V[edges].mean(axis=1)
    around = np.zeros_like(middle)
    np.add.at(around, side.ravel(), centre.repeat(4, axis=0) / 2)
    valence = np.bincount(Q.ravel(), minlength=n)[:, None]
    F, R = np.zeros_like(V), np.zeros_like(V)
    np.add.at(F, Q.ravel(), centre.repeat(4, axis=0))
    np.add.at(R, edges.ravel(), middle.repeat(2, axis=0))
    moved = (F / valence + 2 * R / valence + (valence - 3) * V) / valence
    point, left = n + side, n + np.roll(side, 1, axis=1)
    hub = np.broadcast_to(n + len(edges) + np.arange(m)[:, None], (m, 4))
    small = np.stack((Q, point, hub, left), axis=-1).reshape(-1, 4)
    after = (mesh.uv + np.roll(mesh.uv, -1, axis=1)) / 2
    whole = np.broadcast_to(mesh.uv.mean(axis=1, keepdims=True), mesh.uv.shape)
    uv = np.stack((mesh.uv, after, whole, np.roll(after, 1, axis=1)), axis=2).reshape(-1, 4, 2)
    everything = np.concatenate((moved, (middle + around) / 2, centre))
    return QuadMesh(everything, small, mesh.group.repeat(4), uv, mesh.names)


def vertex_normals(V: FloatArray, Q: IntArray) -> FloatArray:
    """(n, 3) unit normals, area-weighted."""
    P = V[Q]
    area = np.cross(P[:, 2] - P[:, 0], P[:, 3] - P[:, 1])
    N = np.zeros_like(V)
    np.add.at(N, Q.ravel(), area.repeat(4, axis=0))
    return np.asarray(N / np.linalg.norm(N, axis=1, keepdims=True))


def dog() -> QuadMesh:
    """The blocks, subdivided twice."""
    return subdivide(subdivide(blocks()))
