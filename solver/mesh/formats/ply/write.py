"""Writing PLY files: a deformed copy of the file that was read, or a plain one."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from solver.mesh.formats.colours import whole
from solver.mesh.formats.columns import changed_columns, turned_face_normals
from solver.mesh.formats.format import DeformedSurface
from solver.mesh.formats.ply.header import COLOUR, NORMAL, POSITION
from solver.mesh.formats.ply.read import PlySource
from solver.mesh.formats.ply.widening import widened

_HEADER = b"""ply
format binary_little_endian 1.0
element vertex %d
property double x
property double y
property double z
%belement face %d
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
    normals = source.at(vertex).columns(vertex, NORMAL) if has_normals else None
    names = POSITION + NORMAL if has_normals else POSITION
    body = source.at(vertex, surface.progress)
    data = body.replaced(vertex, names, *changed_columns(surface, normals))
    if not face.has_numbers(NORMAL):
        return data
    values, turned = turned_face_normals(surface, source.at(face).columns(face, NORMAL))
    changed = np.repeat(turned[:, None], 3, axis=1)
    return replace(source, data=data).at(face).replaced(face, NORMAL, values, changed)


def _plain(surface: DeformedSurface) -> bytes:
    polygons = surface.polygons
    wide = bool((polygons.sizes > 255).any())
    count = np.dtype("<i4" if wide else "<u1")
    rows = _vertex_rows(surface)
    colours = b"".join(
        b"property uchar %b\n" % name.encode() for name in (rows.dtype.names or ())[3:]
    )
    head = _HEADER % (len(rows), colours, len(polygons.sizes), b"int" if wide else b"uchar")
    # Each face is its count followed by its vertices, laid out byte by byte.
    lengths = count.itemsize + 4 * polygons.sizes
    starts = np.cumsum(lengths) - lengths
    faces = np.zeros(int(lengths.sum()), dtype=np.uint8)
    sizes = polygons.sizes.astype(count).view(np.uint8).reshape(-1, count.itemsize)
    faces[starts[:, None] + np.arange(count.itemsize)] = sizes
    at = np.repeat(starts + count.itemsize - 4 * polygons.starts, polygons.sizes)
    at += 4 * np.arange(len(polygons.corners))
    faces[at[:, None] + np.arange(4)] = polygons.corners.astype("<i4").view(np.uint8).reshape(-1, 4)
    return head + rows.tobytes() + faces.tobytes()


def _vertex_rows(surface: DeformedSurface) -> NDArray[Any]:
    """(n,) records of x y z, and of a colour where the surface has some."""
    columns: dict[str, NDArray[Any]] = dict(zip(POSITION, surface.positions.T, strict=True))
    if surface.colours is not None:
        columns |= zip(COLOUR, whole(surface.colours()).T, strict=True)
    kinds = [(name, "<f8" if name in POSITION else "u1") for name in columns]
    rows = np.empty(len(surface.positions), dtype=kinds)
    for name, values in columns.items():
        rows[name] = values
    return rows
