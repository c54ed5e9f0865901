"""Mesh statistics: counts of elements, components, boundaries and flaws."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from solver.geometry.frames import triangle_frames
from solver.geometry.topology import Topology, components
from solver.mesh.mesh import Mesh


@dataclass(frozen=True)
class MeshStatistics:
    """Counts over one mesh; nothing counted here is an error.

    `polygon_sizes` is corners -> how many faces. A component is a set of triangles joined by
    vertices; a boundary edge has one triangle, a boundary loop is a connected set of such edges, a
    non-manifold edge has three triangles or more. A degenerate triangle has no area (or a repeated
    vertex); a duplicate has the vertices of an earlier one. `diagonal` is that of the bounding box
    `lower` .. `upper`. `extras` counts what the file holds beyond its surface, in plain words.
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
    extras: Mapping[str, int]


def mesh_statistics(mesh: Mesh) -> MeshStatistics:
    """Count everything worth knowing about a mesh before it is deformed."""
    V, F = mesh.vertices, mesh.faces
    topology = Topology(F, len(V))
    # A vertex that a triangle repeats makes no edge.
    proper = topology.edges[:, 0] < topology.edges[:, 1]
    boundary = topology.edges[proper & (topology.valence == 1)]
    lower, upper = V.min(axis=0), V.max(axis=0)
    sizes, numbers = np.unique(mesh.outlines.sizes, return_counts=True)
    return MeshStatistics(
        vertices=len(V),
        triangles=len(F),
        polygon_sizes=dict(zip(sizes.tolist(), numbers.tolist(), strict=True)),
        components=len(np.unique(topology.vertex_component[F])),
        boundary_edges=len(boundary),
        boundary_loops=len(np.unique(components(boundary, len(V))[boundary])),
        non_manifold_edges=int((proper & (topology.valence > 2)).sum()),
        degenerate_triangles=int(triangle_frames(V[F]).degenerate.sum()),
        duplicate_faces=len(F) - len(np.unique(np.sort(F, axis=1), axis=0)),
        isolated_vertices=len(V) - len(np.unique(F)),
        lower=tuple(lower.tolist()),
        upper=tuple(upper.tolist()),
        diagonal=float(np.linalg.norm(upper - lower)),
        extras=mesh.extras,
    )
