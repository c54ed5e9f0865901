"""The header of a PLY file: which elements follow, and how they are stored."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

from solver.errors import MeshError

_TYPES = {
    **{"char": "i1", "uchar": "u1", "short": "i2", "ushort": "u2", "int": "i4", "uint": "u4"},
    **{"int8": "i1", "uint8": "u1", "int16": "i2", "uint16": "u2", "int32": "i4", "uint32": "u4"},
    **{"float": "f4", "double": "f8", "float32": "f4", "float64": "f8"},
}
_BYTE_ORDERS = {"ascii": None, "binary_little_endian": "<", "binary_big_endian": ">"}
_END = re.compile(rb"^[ \t]*end_header[ \t]*(\r\n|\n|\r)", re.MULTILINE)
POSITION = "x", "y", "z"
NORMAL = "nx", "ny", "nz"
COLOUR = "red", "green", "blue", "alpha"
# What a deformation changes, by the element that has it.
SHAPE = {"vertex": (POSITION, NORMAL), "face": (NORMAL,)}
_FACE_LISTS = ("vertex_indices", "vertex_index")


@dataclass(frozen=True)
class Property:
    """A number, or a list of numbers after its length where `length_type` is given."""

    name: str
    type: str
    length_type: str | None = None


@dataclass(frozen=True)
class Element:
    """`count` rows of the same properties."""

    name: str
    count: int
    properties: tuple[Property, ...]

    def position(self, name: str) -> int:
        """Which property has this name."""
        return [entry.name for entry in self.properties].index(name)

    def has_numbers(self, names: Sequence[str]) -> bool:
        """Whether every name is that of a number."""
        numbers = {entry.name for entry in self.properties if entry.length_type is None}
        return numbers.issuperset(names)


@dataclass(frozen=True)
class Header:
    """`byte_order` is None for text; `end` is where the body starts."""

    byte_order: str | None
    elements: tuple[Element, ...]
    end: int

    @property
    def vertex(self) -> Element:
        """The element that holds the positions."""
        return next(element for element in self.elements if element.name == "vertex")

    @property
    def face(self) -> Element:
        """The element that holds the polygons."""
        return next(element for element in self.elements if element.name == "face")

    @property
    def face_list(self) -> str:
        """The name of the list that holds the vertices of a face."""
        return next(entry.name for entry in self.face.properties if entry.name in _FACE_LISTS)


def read_header(data: bytes, name: str) -> Header:
    """The header of a PLY that holds a surface. Raises MeshError naming the line."""
    if data[:3] != b"ply":
        raise MeshError(f"{name}: not a PLY mesh, expected a file that starts with 'ply'")
    end = _END.search(data)
    if end is None:
        raise MeshError(f"{name}: the file ends inside its header, expected 'end_header'")
    byte_order: str | None = ""
    elements: list[Element] = []
    for number, line in enumerate(data[: end.start()].splitlines(), start=1):
        words = line.decode("utf-8", "replace").split()
        try:
            if words[:1] == ["format"]:
                byte_order = _BYTE_ORDERS[words[1]]
            elif words[:1] == ["element"]:
                elements.append(Element(words[1], _count(words[2]), ()))
            elif words[:1] == ["property"]:
                last = elements.pop()
                properties = (*last.properties, _property(words))
                elements.append(Element(last.name, last.count, properties))
        except (KeyError, IndexError, ValueError) as error:
            line_text = " ".join(words)[:60]
            message = f"expected a PLY header line, got {line_text!r}"
            raise MeshError(f"{name}, line {number}: {message}") from error
    _check(byte_order, elements, name)
    return Header(byte_order, tuple(elements), end.end())


def _count(word: str) -> int:
    if not word.isdecimal():
        raise ValueError(word)
    return int(word)


def _property(words: list[str]) -> Property:
    if words[1] == "list":
        length_type = _TYPES[words[2]]
        if length_type[0] == "f":
            raise ValueError("a list's length is a whole number")
        return Property(words[4], _TYPES[words[3]], length_type)
    return Property(words[2], _TYPES[words[1]])


def _check(byte_order: str | None, elements: list[Element], name: str) -> None:
    """A surface has an element of vertices with x, y, z and one of faces with a list."""
    found = {element.name: element for element in elements}
    if byte_order == "" or len(found) < len(elements):
        raise MeshError(f"{name}: expected one format and each PLY element once")
    vertex, face = (found.get(kind, Element(kind, 0, ())) for kind in ("vertex", "face"))
    if not {"x", "y", "z"} <= {p.name for p in vertex.properties if p.length_type is None}:
        raise MeshError(f"{name}: expected a PLY element 'vertex' with properties x, y, z")
    lists = {p.name for p in face.properties if p.length_type and p.type[0] != "f"}
    if len(lists & set(_FACE_LISTS)) != 1:
        raise MeshError(f"{name}: expected a PLY element 'face' with one list 'vertex_indices'")
    for element in elements:
        if len({entry.name for entry in element.properties}) < len(element.properties):
            raise MeshError(f"{name}: the PLY element {element.name!r} has a property twice")
