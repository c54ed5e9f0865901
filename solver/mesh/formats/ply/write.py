"""Writing PLY files: a deformed copy of the file that was read, or a plain one."""

from __future__ import annotations

import numpy as np

from solver.mesh.formats.format import DeformedSurface
from solver.mesh.formats.ply.body import Body
from solver.mesh.formats.ply.header import NORMAL, POSITION
from solver.mesh.formats.ply.read import PlySource
from solver.mesh.formats.vertex_columns import changed_columns
from solver.mesh.progress import Progress, silent

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
    """The file that was read with new positions and normals, or a plain one, binary and float64.

    New numbers have the type that the file gives them. Whole numbers hold no deformed position: a
    file of such is not kept.
    """
    source = surface.source
    if isinstance(source, PlySource) and source.header.vertex.has_floats(POSITION):
        return _rewritten(source, surface)
    return _plain(surface)


def _rewritten(source: PlySource, surface: DeformedSurface) -> bytes:
    vertex = source.header.vertex
    has_normals = vertex.has_floats(NORMAL)
    normals = _at_vertex(source, silent).columns(vertex, NORMAL) if has_normals else None
    names = POSITION + NORMAL if has_normals else POSITION
    body = _at_vertex(source, surface.progress)
    return body.replaced(vertex, names, *changed_columns(surface, normals))


def _at_vertex(source: PlySource, progress: Progress) -> Body:
    """The body where the vertices follow."""
    body = source.body(progress=progress)
    for element in source.header.elements:
        if element.name == "vertex":
            break
        body.skip(element)
    return body


def _plain(surface: DeformedSurface) -> bytes:
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
