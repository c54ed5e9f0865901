"""UVs as a tailor's pattern: a front and a back, with the vertices repeated along the seam."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from solver.types import FloatArray, IntArray

MARGIN = 0.02


@dataclass(frozen=True, eq=False)
class Part:
    """One named part with one material: V (n, 3), F (m, 3), and a UV of each vertex, (n, 2)."""

    name: str
    material: str
    V: FloatArray
    F: IntArray
    uv: FloatArray


def cut_part(name: str, material: str, V: FloatArray, F: IntArray) -> Part:
    """The front and the back of a mesh, each projected along z, side by side in the unit square.

    A vertex where they meet is repeated, as it has two UVs: what exporters of glTF do.
    """
    middle = V[F].mean(axis=1)[:, 2]
    back = middle < (V[:, 2].min() + V[:, 2].max()) / 2
    corners = 2 * F + back[:, None]
    used, faces = np.unique(corners, return_inverse=True)
    vertex, is_back = np.divmod(used, 2)
    low, size = V.min(axis=0), np.ptp(V, axis=0)
    u, v = (V[vertex, :2] - low[:2]).T / max(2 * size[0], size[1])
    half = np.where(is_back, 1 - u, u)
    uv = MARGIN / 2 + (1 - MARGIN) * np.stack((half, v), axis=1)
    return Part(name, material, V[vertex], faces.reshape(-1, 3), uv)
