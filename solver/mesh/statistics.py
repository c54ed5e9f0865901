"""What a mesh is and what is unusual about it."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

from solver.mesh.formats.obj import keywords, obj_lines
from solver.mesh.mesh import Mesh
from solver.mesh.normals import frames
from solver.types import IntArray


@dataclass(frozen=True)
class MeshStatistics:
    """Counts over one mesh; nothing counted here is an error.

    `polygon_sizes` is corners -> how many faces. A component is a set of triangles joined by
    vertices; a boundary edge has one triangle, a boundary loop is a connected set of such edges, a
    non-manifold edge has three triangles or more. A degenerate triangle has no area (or a repeated
    vertex); a duplicate has the vertices of an earlier one. `diagonal` is that of the bounding box
    `lower` .. `upper`. The last three count what an OBJ holds beyond its surface.
    """

    vertices: int
    triangles: int
    polygon_sizes: dict[int, int]
    components: int
    boundary_edges: int
    boundary_loops: int
    non_manifold_edges: int
    degenerate_triangles: int
    duplicate_faces: int
    isolated_vertices: int
    lower: tuple[float, float, float]
    upper: tuple[float, float, float]
    diagonal: float
    texture_coordinates: int
    normals: int
    groups: int


def mesh_statistics(mesh: Mesh) -> MeshStatistics:
    """Count everything worth knowing about a mesh before it is deformed."""
    V, F = mesh.vertices, mesh.faces
    edges, counts = _edges(F)
    boundary = edges[counts == 1]
    lower, upper = V.min(axis=0), V.max(axis=0)
    sizes, numbers = np.unique(mesh.outlines.sizes, return_counts=True)
    lines = Counter(keywords(obj_lines(mesh.source.data)) if mesh.source else [])
    return MeshStatistics(
        vertices=len(V),
        triangles=len(F),
        polygon_sizes=dict(zip(sizes.tolist(), numbers.tolist(), strict=True)),
        components=_parts(F[:, [0, 1, 1, 2]].reshape(-1, 2)),
        boundary_edges=len(boundary),
        boundary_loops=_parts(boundary),
        non_manifold_edges=int((counts > 2).sum()),
        degenerate_triangles=int((~frames(V[F])[2]).sum()),
        duplicate_faces=len(F) - len(np.unique(np.sort(F, axis=1), axis=0)),
        isolated_vertices=len(V) - len(np.unique(F)),
        lower=tuple(lower.tolist()),
        upper=tuple(upper.tolist()),
        diagonal=float(np.linalg.norm(upper - lower)),
        texture_coordinates=lines[b"vt"],
        normals=lines[b"vn"],
        groups=lines[b"g"],
    )


def _edges(F: IntArray) -> tuple[IntArray, IntArray]:
    """Undirected edges (e, 2) and how many triangles each has; a repeated vertex makes no edge."""
    pairs = np.sort(F[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    pairs = pairs[pairs[:, 0] != pairs[:, 1]]
    # One number an edge sorts much faster than pairs.
    key, counts = np.unique(pairs[:, 0] * (F.max() + 1) + pairs[:, 1], return_counts=True)
    return np.stack(np.divmod(key, F.max() + 1), axis=1), counts


def _parts(pairs: IntArray) -> int:
    """Connected sets among the vertices that the pairs (k, 2) name."""
    if not len(pairs):
        return 0
    names, flat = np.unique(pairs, return_inverse=True)
    i, j = flat.reshape(-1, 2).T
    graph = coo_matrix((np.ones(len(i)), (i, j)), shape=(len(names), len(names)))
    return int(connected_components(graph, directed=False)[0])
