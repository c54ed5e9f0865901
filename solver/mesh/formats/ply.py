"""PLY files, text and binary: the vertex and face elements of any well-formed header."""

from __future__ import annotations

import numpy as np

from solver.errors import MeshError
from solver.mesh.formats.ply_body import BinaryBody, Body, TextBody
from solver.mesh.formats.ply_header import Element, read_header
from solver.mesh.polygons import Polygons
from solver.types import FloatArray

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


def read_ply(data: bytes, name: str) -> tuple[FloatArray, Polygons]:
    """Vertices and polygons. Raises MeshError naming what is wrong, with its line or number."""
    header = read_header(data, name)
    body: Body
    if header.byte_order is None:
        body = TextBody(data, name, header)
    else:
        body = BinaryBody(data, name, header)
    for element in header.elements:
        if element.name == "vertex":
            V = _vertices(body, element, name)
        elif element.name == "face":
            polygons = Polygons(*body.lists(element, header.face_list))
        else:
            body.skip(element)
    _check_faces(polygons, len(V), name)
    return V, polygons


def write_ply(X: FloatArray, polygons: Polygons) -> bytes:
    """Binary, float64: every position reads back the same."""
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


def _vertices(body: Body, element: Element, name: str) -> FloatArray:
    V = np.stack(body.columns(element, ("x", "y", "z")), axis=1)
    bad = np.flatnonzero(~np.isfinite(V).all(axis=1))
    if bad.size:
        raise MeshError(f"{name}, vertex {bad[0]}: expected finite coordinates")
    return V


def _check_faces(polygons: Polygons, n: int, name: str) -> None:
    small = np.flatnonzero(polygons.sizes < 3)
    if small.size:
        raise MeshError(
            f"{name}, face {small[0]}: a face needs at least three corners, "
            f"got {polygons.sizes[small[0]]}"
        )
    wrong = np.flatnonzero((polygons.corners < 0) | (polygons.corners >= n))
    if wrong.size:
        face = np.searchsorted(np.cumsum(polygons.sizes), wrong[0], side="right")
        raise MeshError(
            f"{name}, face {face}: names vertex {polygons.corners[wrong[0]]}, "
            f"but they go from 0 to {n - 1}"
        )
