"""Reading PLY files: the vertex and face elements of any well-formed header."""

from __future__ import annotations

import numpy as np

from solver.errors import MeshError
from solver.mesh.formats.format import FileContent
from solver.mesh.formats.ply.body import BinaryBody, Body, TextBody
from solver.mesh.formats.ply.header import Element, read_header
from solver.mesh.polygons import Polygons
from solver.types import FloatArray


def read_ply(data: bytes, name: str) -> FileContent:
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
    return FileContent(V, polygons)


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
