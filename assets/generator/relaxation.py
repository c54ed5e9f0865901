"""Evens out the triangles of a mesh that lies on an implicit surface."""

from __future__ import annotations

import numpy as np
from scipy.sparse import coo_matrix, diags_array

from assets.generator.implicit import Field, gradient, project
from solver.types import BoolArray, FloatArray, IntArray


def relax(
    field: Field, V: FloatArray, F: IntArray, rounds: int = 8, held: BoolArray | None = None
) -> FloatArray:
    """Each vertex slides on the surface towards its neighbours' mean; those of `held` stay."""
    sides = np.concatenate((F, F[:, [1, 2, 0]], F[:, [2, 0, 1]]))[:, :2]
    A = coo_matrix((np.ones(len(sides)), sides.T), shape=(len(V), len(V))).tocsr()
    mean = diags_array(1 / np.asarray(A.sum(axis=1)).ravel()) @ A
    for _ in range(rounds):
        normal = gradient(field, V)
        normal /= np.linalg.norm(normal, axis=1, keepdims=True)
        step = mean @ V - V
        step -= (step * normal).sum(axis=1, keepdims=True) * normal
        moved = project(field, V + 0.5 * step, rounds=2)
        V = moved if held is None else np.where(held[:, None], V, moved)
    return V
