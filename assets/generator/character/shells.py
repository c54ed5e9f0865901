"""Clothes: a region of a surface, cut out along a smooth curve and moved outward."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise

import numpy as np

from assets.generator.implicit import Field, gradient, project
from assets.generator.relaxation import relax
from solver.geometry.topology import Topology
from solver.types import BoolArray, FloatArray, IntArray

Thickness = Callable[[FloatArray], FloatArray]
NEAR = 0.4
"""Vertices nearer to the cut than this share of an edge slide onto it: no thin triangles."""


def shell(
    field: Field, V: FloatArray, F: IntArray, outside: Field, thickness: Thickness
) -> tuple[FloatArray, IntArray]:
    """The part of a mesh on the zero level of `field` where `outside` < 0, `thickness` above it."""
    edge = np.linalg.norm(V[F] - V[np.roll(F, 1, axis=1)], axis=2)
    length = np.bincount(F.ravel(), edge.ravel()) / np.bincount(F.ravel())
    near = np.abs(outside(V)) < NEAR * length
    V = V.copy()
    V[near] = slide(field, outside, V[near])
    value = np.where(near, 0.0, outside(V))
    V, F, border = _clip(V, F, value)
    V[border] = slide(field, outside, V[border])
    V = _even_border(field, outside, V, F)
    V = relax(field, V, F, held=border)

    def above(p: FloatArray) -> FloatArray:
        return field(p) - thickness(p)

    return relax(above, project(above, V), F, rounds=20, held=border), F


def slide(field: Field, other: Field, p: FloatArray, rounds: int = 6) -> FloatArray:
    """Points moved along the zero level of `field` to where that of `other` crosses it."""
    for _ in range(rounds):
        normal = gradient(field, p)
        normal /= np.linalg.norm(normal, axis=1, keepdims=True)
        along = gradient(other, p)
        along -= (along * normal).sum(axis=1, keepdims=True) * normal
        square = np.maximum((along * along).sum(axis=1), 0.05)
        p = project(field, p - (other(p) / square)[:, None] * along, rounds=2)
    return p


def _even_border(
    field: Field, outside: Field, V: FloatArray, F: IntArray, rounds: int = 6
) -> FloatArray:
    """Vertices of the border moved along the cut, half-way to the middle of their neighbours'."""
    topology = Topology(F, len(V))
    ends = topology.edges[topology.valence == 1]
    ends = np.concatenate((ends, ends[:, ::-1]))
    border, row = np.unique(ends[:, 0], return_inverse=True)
    V = V.copy()
    for _ in range(rounds):
        total = np.zeros((len(border), 3))
        np.add.at(total, row, V[ends[:, 1]])
        middle = total / np.bincount(row)[:, None]
        V[border] = slide(field, outside, (V[border] + middle) / 2, rounds=2)
    return V


def _clip(V: FloatArray, F: IntArray, value: FloatArray) -> tuple[FloatArray, IntArray, BoolArray]:
    """The part where a function, given at the vertices, is negative, and which of its vertices
    lie on the cut."""
    low, high = value[F].min(axis=1), value[F].max(axis=1)
    triangles = F[(low < 0) & (high <= 0)].tolist()
    cuts: dict[tuple[int, int], int] = {}
    for face in F[(low < 0) & (high > 0)].tolist():
        outline = []
        for a, b in zip(face, face[1:] + face[:1], strict=True):
            if value[a] <= 0:
                outline.append(a)
            if value[a] * value[b] < 0:
                outline.append(cuts.setdefault((min(a, b), max(a, b)), len(V) + len(cuts)))
        triangles += [[outline[0], *two] for two in pairwise(outline[1:])]
    ends = np.array(list(cuts), dtype=np.int64).reshape(-1, 2)
    a, b = value[ends].T
    cut = V[ends[:, 0]] + (a / (a - b))[:, None] * (V[ends[:, 1]] - V[ends[:, 0]])
    on_cut = np.concatenate((value == 0, np.ones(len(cut), dtype=bool)))
    kept = np.array(triangles)
    kept = kept[~on_cut[kept].all(axis=1)]  # those are slivers along the cut
    used, faces = np.unique(kept, return_inverse=True)
    return np.concatenate((V, cut))[used], faces.reshape(-1, 3), on_cut[used]
