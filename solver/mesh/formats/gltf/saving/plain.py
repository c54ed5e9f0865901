"""A glTF file for a surface that comes from elsewhere: a node for each group, smooth normals."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np

from solver.mesh.formats.colours import to_light
from solver.mesh.formats.format import DeformedSurface
from solver.mesh.formats.gltf.container import Gltf
from solver.mesh.formats.gltf.part import Part
from solver.mesh.formats.gltf.primitives import LIST
from solver.mesh.formats.gltf.read import GltfSource
from solver.mesh.formats.gltf.saving.division import Share, divide
from solver.mesh.formats.gltf.saving.edit import Edit
from solver.mesh.formats.gltf.schema import Json
from solver.mesh.normals import smooth_normals
from solver.mesh.polygons import Polygons
from solver.types import FloatArray, IntArray

_INTEGERS = {np.dtype("<u2"): 5123, np.dtype("<u4"): 5125}
# Bytes of vertices and of indices, for readers that put them on a graphics card.
_VERTICES, _INDICES = 34962, 34963
# A surface farther from the origin than so many diagonals loses detail in float32.
_FAR = 16


def plain_surface(surface: DeformedSurface) -> DeformedSurface:
    """The deformed surface with a file for its source that shows it, at rest where it is now.

    Its triangles, divided by groups into nodes; vertices are in the order of the file. Where it
    lies so far out that float32 would round its detail away, the nodes hold its centre.
    """
    shares = divide(surface)
    order = np.concatenate([share.vertices for share in shares])
    X, starts = surface.positions[order], np.cumsum([0, *(len(s.vertices) for s in shares)])
    faces = [share.faces + start for share, start in zip(shares, starts[:-1], strict=True)]
    polygons = Polygons.from_array(np.concatenate(faces))
    normals = smooth_normals(surface.positions, surface.triangles)[order]
    colours = None if surface.colours is None else to_light(surface.colours()[order])
    return replace(
        surface,
        rest=X,
        positions=X,
        polygons=polygons,
        triangle_corners=np.arange(polygons.corners.size).reshape(-1, 3),
        source=_source(X, normals, colours, shares),
        poses={name: pose[order] for name, pose in surface.poses.items()},
        groups=None,
    )


def _source(
    X: FloatArray, normals: FloatArray, colours: FloatArray | None, shares: list[Share]
) -> GltfSource:
    """A file of a node and a mesh for each share, and the parts of the surface they show."""
    lower, upper = X.min(axis=0), X.max(axis=0)
    far = max(np.abs(lower).max(), np.abs(upper).max()) > _FAR * np.linalg.norm(upper - lower)
    centre = (lower + upper) / 2 if far else np.zeros(3)
    place = {"translation": centre.tolist()} if far else {}
    root: Json = {"asset": {"version": "2.0", "generator": "Surface deformation"}}
    edit = Edit(Gltf(root, (), "the mesh", Path()))
    nodes: list[Json] = []
    meshes: list[Json] = []
    parts, start, first = [], 0, 0
    for number, share in enumerate(shares):
        count, name = len(share.vertices), {"name": share.name} if share.name else {}
        own = slice(start, start + count)
        mesh = _mesh(edit, X[own] - centre, normals[own], share.faces)
        if colours is not None:
            color = edit.append({"type": "VEC4"}, colours[own], target=_VERTICES)
            mesh["primitives"][0]["attributes"]["COLOR_0"] = color
        nodes.append({"mesh": number} | name | place)
        meshes.append(mesh | name)
        position = mesh["primitives"][0]["attributes"]["POSITION"]
        triangles = slice(first, first + len(share.faces))
        parts.append(Part(number, number, (0,), position, start, count, (triangles,), np.eye(3)))
        start, first = own.stop, triangles.stop
    scenes = [{"nodes": list(range(len(nodes)))}]
    edit.json |= {"scene": 0, "scenes": scenes, "nodes": nodes, "meshes": meshes}
    return GltfSource(edit.finished(), tuple(parts))


def _mesh(edit: Edit, X: FloatArray, normals: FloatArray, F: IntArray) -> Json:
    bounded: Json = {"type": "VEC3", "min": [], "max": []}
    attributes = {
        "POSITION": edit.append(bounded, X, target=_VERTICES),
        "NORMAL": edit.append({"type": "VEC3"}, normals, target=_VERTICES),
    }
    return {
        "primitives": [
            {"attributes": attributes, "indices": _indices(edit, F, len(X)), "mode": LIST}
        ]
    }


def _indices(edit: Edit, F: IntArray, count: int) -> int:
    # The largest number of a type is not for a vertex: it can end a strip.
    kind = np.dtype("<u2" if count < 65536 else "<u4")
    view = edit.append_bytes(F.astype(kind).tobytes(), target=_INDICES)
    edit.json["accessors"].append(
        {"bufferView": view, "componentType": _INTEGERS[kind], "count": F.size, "type": "SCALAR"}
    )
    return len(edit.json["accessors"]) - 1
