"""OFF files: polygons with float64 positions, as text."""

from __future__ import annotations

import re

import numpy as np

from solver.errors import MeshError
from solver.mesh.formats.format import DeformedSurface, FileContent
from solver.mesh.formats.text import Text, points, split_lines
from solver.mesh.polygons import Polygons

# Texture coordinates, colours and normals come after the position and are ignored.
_HEADER = re.compile(rb"(ST)?C?N?OFF")


def read_off(data: bytes, name: str) -> FileContent:
    """Vertices and polygons. Raises MeshError naming the line."""
    lines = split_lines(name, data, "an OFF mesh")
    text = Text(name, lines, [line.split(b"#", 1)[0] for line in lines])
    at = [i for i, line in enumerate(text.bare) if line.strip()]
    first = text.bare[at[0]].split() if at else [b""]
    if not _HEADER.fullmatch(first[0]):
        raise text.error(at[0] if at else 0, "expected an OFF file that starts with 'OFF'")
    # The counts may follow the keyword on its line.
    same_line = len(first) > 1
    n, m = _counts(text, at[0] if same_line else at[min(1, len(at) - 1)], first[1:])
    at = at[1:] if same_line else at[2:]
    if len(at) < n + m:
        raise MeshError(
            f"{name}: the file ends early, expected {n} vertices and {m} faces, got {len(at)} lines"
        )
    return FileContent(points(text, at[:n], 0), _faces(text, at[n : n + m], n))


def write_off(surface: DeformedSurface) -> bytes:
    """Numbers have the shortest text that reads back the same float64."""
    X, polygons = surface.positions, surface.polygons
    head = b"OFF\n%d %d 0\n" % (len(X), len(polygons.sizes))
    vertices = [b"%a %a %a\n" % tuple(row) for row in X.tolist()]
    faces = [" ".join(map(str, [len(face), *face])) + "\n" for face in polygons.tolist()]
    return head + b"".join(vertices) + "".join(faces).encode()


def _counts(text: Text, line: int, words: list[bytes]) -> tuple[int, int]:
    """Vertices and faces, from `words` or else from the line."""
    try:
        n, m = map(int, (words or text.bare[line].split())[:2])
    except ValueError:
        n = m = -1
    if n < 0 or m < 0:
        raise text.error(line, "expected the numbers of vertices and faces")
    return n, m


def _faces(text: Text, at: list[int], n: int) -> Polygons:
    sizes, corners = [], []
    for line in at:
        row = text.bare[line].split()
        try:
            size = int(row[0])
            face = list(map(int, row[1 : size + 1]))
        except ValueError:
            size, face = 0, []
        if size < 3 or len(face) < size:
            raise text.error(line, "expected a count of at least three and that many vertices")
        if min(face) < 0 or max(face) >= n:
            wrong = next(v for v in face if not 0 <= v < n)
            raise text.error(line, f"the face names vertex {wrong}, but they go from 0 to {n - 1}")
        sizes.append(size)
        corners += face
    return Polygons(np.array(sizes, dtype=np.int64), np.array(corners, dtype=np.int64))
