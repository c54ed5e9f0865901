"""Where the handles of a coarse surface go where those of the fine one have given targets."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy.spatial import cKDTree

from solver.coarse.carrier import Carrier
from solver.geometry.procrustes import rigid_motion
from solver.types import FloatArray, IntArray

# A handle's fine vertices (k,) and where they go, (k, 3).
Goal = tuple[IntArray, FloatArray]


def coarse_targets(
    carrier: Carrier, goals: Sequence[Goal], handles: Sequence[IntArray]
) -> FloatArray:
    """Targets of the coarse handles' vertices, one after the other.

    Each vertex goes with the nearest fine one of its handle, turned as the handle is in the mean.
    """
    P, V = carrier.coarse.vertices, carrier.fine.vertices
    targets = [np.empty((0, 3))]
    for (vertices, goal), own in zip(goals, handles, strict=True):
        R = rigid_motion(V[vertices], goal)[:3, :3]
        nearest = cKDTree(V[vertices]).query(P[own])[1]
        targets.append(goal[nearest] + (P[own] - V[vertices[nearest]]) @ R.T)
    return np.concatenate(targets)
