"""Writing PLY files: positions and polygons, binary."""

from __future__ import annotations

import numpy as np

from solver.mesh.formats.format import DeformedSurface

_HEADER = b"""ply
format binary_little_endian 1.0
element vertex %d
property double x
property double y
property double z
element face %d
property list %b int vertex_indices
end_header
"""


def write_ply(surface: DeformedSurface) -> bytes:
    """Binary, float64: every position reads back the same."""
    X, polygons = surface.positions, surface.polygons
    wide = bool((polygons.sizes > 255).any())
    count = np.dtype("<i4" if wide else "<u1")
    head = _HEADER % (len(X), len(polygons.sizes), b"int" if wide else b"uchar")
    # Each face is its count followed by its vertices, laid out byte by byte.
    lengths = count.itemsize + 4 * polygons.sizes
    starts = np.cumsum(lengths) - lengths
    faces = np.zeros(int(lengths.sum()), dtype=np.uint8)
    sizes = polygons.sizes.astype(count).view(np.uint8).reshape(-1, count.itemsize)
    faces[starts[:, None] + np.arange(count.itemsize)] = sizes
    at = np.repeat(starts + count.itemsize - 4 * polygons.starts, polygons.sizes)
    at += 4 * np.arange(len(polygons.corners))
    faces[at[:, None] + np.arange(4)] = polygons.corners.astype("<i4").view(np.uint8).reshape(-1, 4)
    return head + X.astype("<f8").tobytes() + faces.tobytes()
