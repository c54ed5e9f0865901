"""Mesh statistics: counts of elements, components, boundaries and flaws."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from solver.geometry.frames import triangle_frames
from solver.geometry.topology import Topology, components
from solver.mesh.mesh import Mesh
from solver.types import IntArray


@dataclass(frozen=True)
class MeshStatistics:
    """Counts over one mesh; nothing counted here is an error.

    `polygon_sizes` is corners -> how many faces. A component is a set of triangles joined by
    vertices, `pieces` counts them with their seams welded; a boundary edge has one triangle, a
    boundary loop is a connected set of such edges, a non-manifold edge has three triangles or more.
    A degenerate triangle has no area (or a repeated vertex); a duplicate has the vertices of an
    earlier one. `diagonal` is that of the bounding box `lower` .. `upper`. `extras` counts what the
    file holds beyond its surface, in plain words.
    """

    vertices: int
    triangles: int
    polygon_sizes: dict[int, int]
    components: int
    pieces: int
    boundary_edges: int
    boundary_loops: int
    non_manifold_edges: int
    degenerate_triangles: int
    duplicate_faces: int
    isolated_vertices: int
    lower: tuple[float, float, float]
    upper: tuple[float, float, float]
    diagonal: float
    extras: Mapping[str, int]


def mesh_statistics(mesh: Mesh) -> MeshStatistics:
    """Count everything worth knowing about a mesh before it is deformed."""
    V, F = mesh.vertices, mesh.faces
    topology = Topology(F, len(V))
    # A vertex that a triangle repeats makes no edge.
    proper = topology.edges[:, 0] < topology.edges[:, 1]
    boundary = topology.edges[proper & (topology.valence == 1)]
    used = np.bincount(F.ravel(), minlength=len(V)) > 0
    lower, upper = V.min(axis=0), V.max(axis=0)
    numbers = np.bincount(mesh.outlines.sizes)
    return MeshStatistics(
        vertices=len(V),
        triangles=len(F),
        polygon_sizes={size: int(numbers[size]) for size in np.flatnonzero(numbers).tolist()},
        components=_distinct(topology.vertex_component[used]),
        pieces=int(mesh.pieces.max()) + 1,
        boundary_edges=len(boundary),
        boundary_loops=_distinct(components(boundary, len(V))[boundary]),
        non_manifold_edges=int((proper & (topology.valence > 2)).sum()),
        degenerate_triangles=int(triangle_frames(V[F]).degenerate.sum()),
        duplicate_faces=len(F) - _distinct(_face_keys(topology)),
        isolated_vertices=int((~used).sum()),
        lower=tuple(lower.tolist()),
        upper=tuple(upper.tolist()),
        diagonal=float(np.linalg.norm(upper - lower)),
        extras=mesh.extras,
    )


def _distinct(numbers: IntArray) -> int:
    """How many different ones there are. `np.unique` takes seconds for millions."""
    ordered = np.sort(numbers, axis=None)
    return len(ordered[:1]) + int(np.count_nonzero(np.diff(ordered)))


def _face_keys(topology: Topology) -> IntArray:
    """(m,) a number for each set of three vertices: from its largest and the edge opposite."""
    triangle, corner = np.arange(len(topology.faces)), topology.faces.argmax(axis=1)
    opposite = topology.half_edge_edge[triangle, corner]
    return opposite * topology.vertex_count + topology.faces[triangle, corner]
