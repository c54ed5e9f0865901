"""What a deformation changes in a file: positions, and normals of vertices and faces."""

from __future__ import annotations

import numpy as np

from solver.mesh.formats.format import DeformedSurface
from solver.mesh.normals import turn_normals
from solver.types import BoolArray, FloatArray


def turned_face_normals(
    surface: DeformedSurface, normals: FloatArray
) -> tuple[FloatArray, BoolArray]:
    """Normals (p, 3) of polygons as they are now, and which of them turned (p,)."""
    users = np.repeat(surface.polygon_of_triangle[:, None], 3, axis=1)
    return turn_normals(normals, users, surface.rest, surface.positions, surface.triangles)


def changed_columns(
    surface: DeformedSurface, normals: FloatArray | None
) -> tuple[FloatArray, BoolArray]:
    """Columns x y z, and those of a normal for every vertex (n, 3) where the file has them.

    Returns the deformed values (n, 3) or (n, 6) and which of them differ from the file's.
    """
    X, moved = surface.positions, surface.moved
    if normals is None:
        return X, np.repeat(moved[:, None], 3, axis=1)
    triangles = surface.triangles
    after, turned = turn_normals(normals, triangles, surface.rest, X, triangles)
    return np.hstack([X, after]), np.repeat(np.stack([moved, turned], axis=1), 3, axis=1)
