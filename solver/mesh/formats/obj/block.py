"""Reading one block of an OBJ file: its vertices, normals and faces."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from solver.mesh.formats.blocks import Block, numbers
from solver.mesh.formats.obj.corners import corner_numbers, is_corner
from solver.mesh.formats.text import is_point
from solver.types import FloatArray, IntArray

_KEYWORDS = b"v", b"vt", b"vn", b"f", b"g", b"o"


class Flaw(NamedTuple):
    """What is wrong with the line at byte `at`; of several the one with the least rank is told."""

    rank: int
    at: int
    message: str


@dataclass(frozen=True, eq=False)
class Rows:
    """What lines say, in their order.

    at: for each keyword, the bytes of the file where its lines start with it.
    points, normals: (n, 3) of `v` and (k, 3) of `vn` lines, NaN for normals that are unreadable.
    sizes: (p,) corners of each `f` line.  vertex_numbers, normal_numbers: (sum,) of each corner as
    written, 0 for no normal.
    Where there are flaws, the arrays of their kind of line are incomplete.
    """

    at: Mapping[bytes, IntArray]
    points: FloatArray
    normals: FloatArray
    sizes: IntArray
    vertex_numbers: IntArray
    normal_numbers: IntArray
    flaws: list[Flaw]

    @classmethod
    def concatenate(cls, blocks: Sequence[Rows]) -> Rows:
        return cls(
            {keyword: np.concatenate([b.at[keyword] for b in blocks]) for keyword in _KEYWORDS},
            np.concatenate([b.points for b in blocks]),
            np.concatenate([b.normals for b in blocks]),
            np.concatenate([b.sizes for b in blocks]),
            np.concatenate([b.vertex_numbers for b in blocks]),
            np.concatenate([b.normal_numbers for b in blocks]),
            [flaw for b in blocks for flaw in b.flaws],
        )


class BlockReader:
    """Reads the lines of one block."""

    def __init__(self, block: Block) -> None:
        self._block = block
        self._flaws: list[Flaw] = []

    def rows(self) -> Rows:
        block = self._block
        lines = {keyword: block.starting_with(keyword) for keyword in _KEYWORDS}
        at = {keyword: block.places(block.first_words[line]) for keyword, line in lines.items()}
        points = self._points(lines[b"v"])
        normals = self._normals(lines[b"vn"])
        return Rows(at, points, normals, *self._faces(lines[b"f"]), self._flaws)

    def _points(self, lines: IntArray) -> FloatArray:
        points = self._triples(lines)
        if points is None:
            bad = next(line for line in lines if not is_point(self._words(line)[:3]))
            self._flaw(0, bad, "expected three numbers x y z")
            return np.empty((0, 3))
        infinite = np.flatnonzero(~np.isfinite(points).all(axis=1))
        if infinite.size:
            self._flaw(1, lines[infinite[0]], "expected finite coordinates")
        return points

    def _normals(self, lines: IntArray) -> FloatArray:
        normals = self._triples(lines)
        if normals is None:
            rows = [self._words(line)[:3] for line in lines]
            normals = np.array([list(map(float, r)) if is_point(r) else [np.nan] * 3 for r in rows])
        normals[~np.isfinite(normals).all(axis=1)] = np.nan
        return normals

    def _triples(self, lines: IntArray) -> FloatArray | None:
        """(k, 3) the three numbers after the keyword of each line, None if some has none."""
        first = self._block.first_words[lines]
        if (self._block.word_counts[lines] < 4).any():
            return None
        try:
            return numbers(self._block.joined(first + 1, first + 3)).reshape(-1, 3)
        except ValueError:
            return None

    def _faces(self, lines: IntArray) -> tuple[IntArray, IntArray, IntArray]:
        """Sizes, and vertex and normal numbers of the corners."""
        none = np.empty(0, dtype=np.int64)
        first = self._block.first_words[lines]
        sizes = self._block.word_counts[lines] - 1
        small = np.flatnonzero(sizes < 3)
        if small.size:
            self._flaw(2, lines[small[0]], "a face needs at least three corners")
            return sizes, none, none
        try:
            return sizes, *corner_numbers(self._block.joined(first + 1, first + sizes))
        except (ValueError, OverflowError):
            bad = next(line for line in lines if not all(map(is_corner, self._words(line))))
            self._flaw(3, bad, "expected corners v, v/vt, v//vn or v/vt/vn")
            return sizes, none, none

    def _words(self, line: int) -> list[bytes]:
        """The words after the keyword."""
        first, count = self._block.first_words[line], self._block.word_counts[line]
        start, stop = self._block.word_starts[first], self._block.word_stops[first + count - 1]
        return self._block.text[start:stop].tobytes().split()[1:]

    def _flaw(self, rank: int, line: int, message: str) -> None:
        at = int(self._block.places(self._block.first_words[line]))
        self._flaws.append(Flaw(rank, at, message))
