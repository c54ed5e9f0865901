"""Text with some of its numbers replaced, every other byte kept, by array operations."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import NamedTuple

import numpy as np

from solver.mesh.formats.text.blocks import Bytes
from solver.types import BoolArray, FloatArray, IntArray

_COMMA = ord(",")
# Numbers at a time: making text of them holds the global lock, which a window needs to draw.
PIECE = 8192


class Replacement(NamedTuple):
    """Numbers (r,) to put at bytes starts[i] to stops[i] of a file, in order."""

    starts: IntArray
    stops: IntArray
    numbers: FloatArray


def spliced(data: bytes, replacements: Iterable[Replacement]) -> Iterator[bytes]:
    """The data with the numbers replaced, piece by piece; replacements come in the file's order.

    Numbers have the shortest text that reads back the same float64.
    """
    done = 0
    for starts, stops, numbers in replacements:
        if len(starts):
            first, last = int(starts[0]), int(stops[-1])
            yield data[done:first]
            yield _replaced(data[first:last], starts - first, stops - first, numbers)
            done = last
    yield data[done:]


def _replaced(data: bytes, starts: IntArray, stops: IntArray, numbers: FloatArray) -> bytes:
    return substituted(data, starts, stops, *_texts(numbers))


def substituted(
    data: bytes, starts: IntArray, stops: IntArray, text: Bytes, lengths: IntArray
) -> bytes:
    """The data with other bytes at starts[i] to stops[i], in order: the next lengths[i] of text."""
    growth = lengths - (stops - starts)
    after = starts + np.cumsum(growth) - growth
    new = _inside(after, after + lengths, len(data) + int(growth.sum()))
    result = np.empty(len(new), dtype=np.uint8)
    result[new] = text
    result[~new] = np.frombuffer(data, dtype=np.uint8)[~_inside(starts, stops, len(data))]
    return result.tobytes()


def _texts(numbers: FloatArray) -> tuple[Bytes, IntArray]:
    """The bytes of all numbers one after another, and how many each has."""
    pieces = (numbers[start : start + PIECE] for start in range(0, len(numbers), PIECE))
    listed = ", ".join(repr(piece.tolist())[1:-1] for piece in pieces).encode()
    commas = np.flatnonzero(np.frombuffer(listed, dtype=np.uint8) == _COMMA)
    ends = np.concatenate([commas, [len(listed)]])
    # Two bytes, a comma and a blank, lie between numbers.
    lengths = np.diff(ends, prepend=-2) - 2
    return np.frombuffer(listed.translate(None, b", "), dtype=np.uint8), lengths


def _inside(starts: IntArray, stops: IntArray, size: int) -> BoolArray:
    """(size,) whether a place lies in one of these ranges, which do not overlap."""
    edges = np.zeros(size + 1, dtype=np.int8)
    edges[starts] = 1
    edges[stops] -= 1  # where the next may start
    return np.cumsum(edges[:-1], dtype=np.int8).view(bool)
