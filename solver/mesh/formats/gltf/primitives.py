"""Triangles of a primitive: lists, strips and fans, with indices or without."""

from __future__ import annotations

import numpy as np

from solver.mesh.formats.gltf.accessors import read_integers
from solver.mesh.formats.gltf.container import Gltf
from solver.mesh.formats.gltf.schema import Json
from solver.types import IntArray

LIST, STRIP, FAN = 4, 5, 6


def has_triangles(primitive: Json) -> bool:
    """Whether it is a surface in space, not points or lines."""
    return (
        primitive.get("mode", LIST) in (LIST, STRIP, FAN) and "POSITION" in primitive["attributes"]
    )


def target_count(mesh: Json) -> int:
    """How many morph targets a mesh has."""
    return max((len(p.get("targets", [])) for p in mesh["primitives"]), default=0)


def triangles(gltf: Gltf, primitive: Json, vertex_count: int, where: str) -> IntArray:
    """(m, 3) vertices of its triangles, counted from the first of its own.

    Triangles of strips and fans that repeat a vertex only join others and are left out.
    Raises MeshError where an index names no vertex.
    """
    if "indices" in primitive:
        corners = read_integers(gltf, primitive["indices"], "SCALAR")[:, 0]
    else:
        corners = np.arange(vertex_count)
    if len(corners) and corners.max() >= vertex_count:
        raise gltf.error(
            f"{where}: an index names vertex {corners.max()}, but they go from 0 to "
            f"{vertex_count - 1}"
        )
    mode = primitive.get("mode", LIST)
    if mode == LIST:
        return corners[: len(corners) // 3 * 3].reshape(-1, 3)
    a, b, c = corners[:-2], corners[1:-1], corners[2:]
    if mode == FAN:
        faces = np.stack([b, c, np.broadcast_to(corners[:1], b.shape)], axis=1)
    else:
        odd = np.arange(len(a)) % 2 == 1
        faces = np.stack([a, np.where(odd, c, b), np.where(odd, b, c)], axis=1)
    joins = (faces == np.roll(faces, 1, axis=1)).any(axis=1)
    return faces[~joins]
