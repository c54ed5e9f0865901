"""A glTF file for a surface that comes from elsewhere: one mesh, one node, smooth normals."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from solver.mesh.formats.format import DeformedSurface
from solver.mesh.formats.gltf.container import Gltf
from solver.mesh.formats.gltf.primitives import LIST
from solver.mesh.formats.gltf.read import GltfSource, Part
from solver.mesh.formats.gltf.saving.edit import Edit
from solver.mesh.formats.gltf.schema import Json
from solver.types import FloatArray, IntArray

_INTEGERS = {np.dtype("<u2"): 5123, np.dtype("<u4"): 5125}
# Bytes of vertices and of indices, for readers that put them on a graphics card.
_VERTICES, _INDICES = 34962, 34963
# A surface farther from the origin than so many diagonals loses detail in float32.
_FAR = 16


def plain_source(surface: DeformedSurface) -> GltfSource:
    """The deformed surface as a file, its polygons as triangles.

    Where it lies so far out that float32 would round its detail away, the node holds its centre.
    """
    X, F = surface.positions, surface.triangles
    lower, upper = X.min(axis=0), X.max(axis=0)
    far = max(np.abs(lower).max(), np.abs(upper).max()) > _FAR * np.linalg.norm(upper - lower)
    centre = (lower + upper) / 2 if far else np.zeros(3)
    root: Json = {"asset": {"version": "2.0", "generator": "Surface deformation"}}
    edit = Edit(Gltf(root, (), "the mesh", Path()))
    attributes = {
        "POSITION": edit.append(
            {"type": "VEC3", "min": [], "max": []}, X - centre, target=_VERTICES
        ),
        "NORMAL": edit.append({"type": "VEC3"}, vertex_normals(X, F), target=_VERTICES),
    }
    primitive = {"attributes": attributes, "indices": _indices(edit, F, len(X)), "mode": LIST}
    node = {"mesh": 0} | ({"translation": centre.tolist()} if far else {})
    edit.json |= {
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [node],
        "meshes": [{"primitives": [primitive]}],
    }
    part = Part(0, 0, (0,), attributes["POSITION"], 0, len(X), (slice(0, len(F)),), np.eye(3))
    return GltfSource(edit.finished(), (part,))


def vertex_normals(X: FloatArray, F: IntArray) -> FloatArray:
    """(n, 3) unit normals: the mean over triangles by area, the z axis where there is none."""
    P = X[F]
    P = P / max(float(np.abs(P).max()), np.finfo(float).tiny)
    area = np.cross(P[:, 1] - P[:, 0], P[:, 2] - P[:, 0])
    total = np.stack(
        [np.bincount(F.ravel(), area[:, c].repeat(3), len(X)) for c in range(3)], axis=1
    )
    length = np.linalg.norm(total, axis=1, keepdims=True)
    # In float32 a shorter sum is all rounding.
    return np.where(length > 1e-30, total / np.where(length > 0, length, 1), [0.0, 0.0, 1.0])


def _indices(edit: Edit, F: IntArray, count: int) -> int:
    # The largest number of a type is not for a vertex: it can end a strip.
    kind = np.dtype("<u2" if count < 65536 else "<u4")
    view = edit.append_bytes(F.astype(kind).tobytes(), target=_INDICES)
    edit.json["accessors"].append(
        {"bufferView": view, "componentType": _INTEGERS[kind], "count": F.size, "type": "SCALAR"}
    )
    return len(edit.json["accessors"]) - 1
