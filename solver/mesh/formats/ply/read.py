"""Reading PLY files: the vertex and face elements of any well-formed header."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from itertools import takewhile

import numpy as np

from solver.errors import MeshError
from solver.mesh.formats.colours import rgba
from solver.mesh.formats.format import FileContent
from solver.mesh.formats.ply.binary import BinaryBody
from solver.mesh.formats.ply.body import Body
from solver.mesh.formats.ply.header import NORMAL, POSITION, Element, Header, read_header
from solver.mesh.formats.ply.text import TextBody
from solver.mesh.polygons import Polygons
from solver.mesh.progress import Progress, silent
from solver.types import FloatArray

_COLOURS = ("red", "green", "blue"), ("diffuse_red", "diffuse_green", "diffuse_blue")
_ALPHA = "alpha", "diffuse_alpha"
# What the properties of a vertex mean, where all of a row are there; and of a face.
_VERTEX = {
    "texture coordinates": (("u", "v"), ("s", "t"), ("texture_u", "texture_v")),
    "normals": (NORMAL,),
    "colours": _COLOURS,
}
_FACE = {
    "texture coordinates": (("texcoord",),),
    "face normals": (NORMAL,),
    "face colours": _COLOURS,
}


@dataclass(frozen=True, eq=False)
class PlySource:
    """A PLY file, for writing it back."""

    data: bytes
    header: Header

    def body(self, name: str = "", progress: Progress = silent) -> Body:
        """The rows, from the first element on."""
        kind = TextBody if self.header.byte_order is None else BinaryBody
        return kind(self.data, name, self.header, progress)

    def at(self, element: Element, progress: Progress = silent) -> Body:
        """The body where the rows of the element follow."""
        body = self.body(progress=progress)
        for before in takewhile(lambda other: other is not element, self.header.elements):
            body.skip(before)
        return body

    def colours(self) -> FloatArray:
        """(n, 4) of the vertices, which have some."""
        vertex = self.header.vertex
        names = [*next(filter(vertex.has_numbers, _COLOURS))]
        names += [name for name in _ALPHA if vertex.has_numbers([name])][:1]
        values = self.at(vertex).columns(vertex, names)
        kind = np.dtype(vertex.properties[vertex.position(names[0])].type)
        return rgba(values, 1.0 if kind.kind == "f" else np.iinfo(kind).max)


def read_ply(data: bytes, name: str, progress: Progress = silent) -> FileContent:
    """Vertices and polygons, with a PlySource.

    Raises MeshError naming what is wrong, with its line or number.
    """
    source = PlySource(data, read_header(data, name))
    header, body = source.header, source.body(name, progress)
    for element in header.elements:
        if element.name == "vertex":
            V = _vertices(body, element, name)
        elif element.name == "face":
            polygons = Polygons(*body.lists(element, header.face_list))
        else:
            body.skip(element)
    _check_faces(polygons, len(V), name)
    extras = _extras(header)
    colours = source.colours if any(map(header.vertex.has_numbers, _COLOURS)) else None
    return FileContent(V, polygons, extras, source, colours=colours)


def _extras(header: Header) -> dict[str, int]:
    """How many of each kind; of properties and elements of unknown meaning, how many there are."""
    found: Counter[str] = Counter()
    for element, known, own in (
        (header.vertex, _VERTEX, set(POSITION)),
        (header.face, _FACE, {header.face_list}),
    ):
        names = {entry.name for entry in element.properties} - own
        for words, spellings in known.items():
            told = next((spelling for spelling in spellings if names.issuperset(spelling)), ())
            found[words] += element.count * bool(told)
            names.difference_update(told, _ALPHA)
        found["further properties"] += len(names)
    found["further elements"] = len(header.elements) - 2
    return {words: count for words, count in found.items() if count}


def _vertices(body: Body, element: Element, name: str) -> FloatArray:
    V = body.columns(element, POSITION)
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
