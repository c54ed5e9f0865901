"""What the lines of an OBJ file say: vertices, normals, faces."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from solver.mesh.formats.obj.corners import corner_numbers
from solver.mesh.formats.text.file import Flaw
from solver.mesh.formats.text.lines import Lines, first_failing
from solver.mesh.formats.text.points import finite_points, read_any
from solver.types import FloatArray, IntArray

_RARE = {"materials": b"usemtl", "lines": b"l", "points": b"p"}
_KEYWORDS = b"v", b"vt", b"vn", b"f", b"g", b"o", b"s"


@dataclass(frozen=True, eq=False)
class Rows:
    """What lines say, in their order.

    at: for each keyword, the bytes of the file where its lines start with it.
    points, normals: (n, 3) of `v` and (k, 3) of `vn` lines, NaN for normals that are unreadable.
    sizes: (p,) corners of each `f` line.  vertex_numbers, normal_numbers: (sum,) of each corner as
    written, 0 for no normal.
    rare: how many there are of what few files have.
    Where there are flaws, the arrays of their kind of line are incomplete.
    """

    at: Mapping[bytes, IntArray]
    points: FloatArray
    normals: FloatArray
    sizes: IntArray
    vertex_numbers: IntArray
    normal_numbers: IntArray
    flaws: list[Flaw]
    rare: Mapping[str, int]

    @classmethod
    def concatenate(cls, parts: Sequence[Rows]) -> Rows:
        return cls(
            {keyword: np.concatenate([p.at[keyword] for p in parts]) for keyword in _KEYWORDS},
            np.concatenate([p.points for p in parts]),
            np.concatenate([p.normals for p in parts]),
            np.concatenate([p.sizes for p in parts]),
            np.concatenate([p.vertex_numbers for p in parts]),
            np.concatenate([p.normal_numbers for p in parts]),
            [flaw for p in parts for flaw in p.flaws],
            sum((Counter(p.rare) for p in parts), Counter()),
        )


def read_rows(lines: Lines) -> Rows:
    """The rows of one block."""
    by_keyword = {keyword: lines.starting_with(keyword) for keyword in _KEYWORDS}
    at = {keyword: found.places for keyword, found in by_keyword.items()}
    points, flaws = finite_points(by_keyword[b"v"], 1)
    normals, faces = read_any(by_keyword[b"vn"], 1), by_keyword[b"f"]
    sizes = faces.count - 1
    vertex_numbers = normal_numbers = np.empty(0, dtype=np.int64)
    small = faces[np.flatnonzero(sizes < 3)]
    try:
        if len(small):
            flaws.append(Flaw(2, int(small.places[0]), "a face needs at least three corners"))
        else:
            vertex_numbers, normal_numbers = _corners(faces)
    except (ValueError, OverflowError):
        at_fault = int(faces.places[first_failing(faces, _corners)])
        flaws.append(Flaw(3, at_fault, "expected corners v, v/vt, v//vn or v/vt/vn"))
    rare = {words: len(lines.starting_with(keyword)) for words, keyword in _RARE.items()}
    rare["colours"] = len(coloured_lines(by_keyword[b"v"]))
    return Rows(at, points, normals, sizes, vertex_numbers, normal_numbers, flaws, rare)


def coloured_lines(vertices: Lines) -> IntArray:
    """Which `v` lines have three numbers behind their position: a colour, by common use."""
    return np.flatnonzero(vertices.count == 7)


def _corners(faces: Lines) -> tuple[IntArray, IntArray]:
    return corner_numbers(faces.block.joined(faces.first + 1, faces.first + (faces.count - 1)))
