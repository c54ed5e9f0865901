"""A PLY file with room for a deformed shape: whole numbers hold no bend and no turned normal."""

from __future__ import annotations

import re

from solver.mesh.formats.ply.header import SHAPE, Element, read_header
from solver.mesh.formats.ply.read import PlySource

_TYPE = re.compile(rb"(property[ \t]+)\S+")


def widened(source: PlySource) -> PlySource:
    """The same file, in which positions and normals that were whole numbers are float64."""
    whole = {element.name: _whole_numbers(element) for element in source.header.elements}
    if not any(whole.values()):
        return source
    body = source.body()
    parts = [body.widened(element, whole[element.name]) for element in source.header.elements]
    data = b"".join([_head(source, whole), *parts, body.rest()])
    return PlySource(data, read_header(data, ""))


def _whole_numbers(element: Element) -> list[str]:
    """The properties of vertices and faces that a deformation changes and that are no floats."""
    if element.name not in SHAPE:
        return []
    return [
        name
        for names in SHAPE[element.name]
        if element.has_numbers(names)
        for name in names
        if element.properties[element.position(name)].type[0] != "f"
    ]


def _head(source: PlySource, whole: dict[str, list[str]]) -> bytes:
    lines, element = [], ""
    for line in source.data[: source.header.end].splitlines(keepends=True):
        words = line.decode("utf-8", "replace").split()
        if words[:1] == ["element"]:
            element = words[1]
        elif words[:1] == ["property"] and words[-1] in whole.get(element, []):
            line = _TYPE.sub(rb"\1double", line, count=1)
        lines.append(line)
    return b"".join(lines)
