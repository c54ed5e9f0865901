"""Writing PLY files: a deformed copy of the file that was read, or a plain one."""

from __future__ import annotations

from dataclasses import replace
from itertools import takewhile

import numpy as np

from solver.mesh.formats.columns import changed_columns, turned_face_normals
from solver.mesh.formats.format import DeformedSurface
from solver.mesh.formats.ply.body import Body
from solver.mesh.formats.ply.header import NORMAL, POSITION, Element
from solver.mesh.formats.ply.read import PlySource
from solver.mesh.formats.ply.widening import widened
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

    New numbers have the type that the file gives them; whole numbers, which hold no deformed
    position, become float64.
    """
    source = surface.source
    if not isinstance(source, PlySource):
        return _plain(surface)
    return _rewritten(source, surface) if surface.moved.any() else source.data


def _rewritten(source: PlySource, surface: DeformedSurface) -> bytes:
    source = widened(source)
    vertex, face = source.header.vertex, source.header.face
    has_normals = vertex.has_numbers(NORMAL)
    normals = _at(vertex, source).columns(vertex, NORMAL) if has_normals else None
    names = POSITION + NORMAL if has_normals else POSITION
    body = _at(vertex, source, surface.progress)
    data = body.replaced(vertex, names, *changed_columns(surface, normals))
    if not face.has_numbers(NORMAL):
        return data
    values, turned = turned_face_normals(surface, _at(face, source).columns(face, NORMAL))
    changed = np.repeat(turned[:, None], 3, axis=1)
    return _at(face, replace(source, data=data)).replaced(face, NORMAL, values, changed)


def _at(element: Element, source: PlySource, progress: Progress = silent) -> Body:
    """The body where the rows of the element follow."""
    body = source.body(progress=progress)
    for before in takewhile(lambda other: other is not element, source.header.elements):
        body.skip(before)
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
