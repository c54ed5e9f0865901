"""What the normals of a glTF file say of hard edges."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from solver.errors import MeshError
from solver.mesh.formats.format import Smoothing
from solver.mesh.formats.gltf.accessors import read_floats
from solver.mesh.formats.gltf.container import Gltf
from solver.mesh.formats.gltf.part import Part
from solver.types import FloatArray, IntArray


def read_smoothing(gltf: Gltf, parts: Sequence[Part], faces: IntArray) -> Smoothing | None:
    """By the normals of the vertices of triangles (m, 3); None where there are none.

    Normals that cannot be read say nothing: no position depends on them.
    """
    alike = np.full(faces.shape, -1)
    found: list[FloatArray] = []
    total = 0
    for part in parts:
        first: dict[int, int | None] = {}
        primitives = gltf.json["meshes"][part.mesh]["primitives"]
        for number, triangles in zip(part.primitives, part.triangles, strict=True):
            accessor = primitives[number]["attributes"].get("NORMAL")
            if accessor is None:
                continue
            if accessor not in first:
                normals = _normals(gltf, accessor, part)
                first[accessor] = None if normals is None else total
                if normals is not None:
                    found.append(normals)
                    total += len(normals)
            start = first[accessor]
            if start is not None:
                alike[triangles] = start + faces[triangles] - part.start
    return Smoothing(alike.ravel(), np.concatenate(found)) if found else None


def _normals(gltf: Gltf, accessor: int, part: Part) -> FloatArray | None:
    """(count, 3) in the scene, of any length."""
    if gltf.json["accessors"][accessor]["count"] != part.count:
        return None
    try:
        local = read_floats(gltf, accessor, "VEC3")
    except MeshError:
        return None
    # Cofactors in place of the inverse transposed: a flat scaling has them too.
    x, y, z = np.moveaxis(part.linear, -2, 0)
    cofactors = np.stack([np.cross(y, z), np.cross(z, x), np.cross(x, y)], axis=-2)
    turned = np.einsum("...ij,...j->...i", cofactors, local)
    return np.sign(np.linalg.det(part.linear))[..., None] * turned
