"""Text with some of its numbers replaced, every other byte kept, by array operations."""

from __future__ import annotations

import numpy as np

from solver.types import BoolArray, FloatArray, IntArray

# A comment and a backslash that continues a line end a word too.
_BLANKS = bytes.maketrans(b"\t\r\v\f\n\\#", b"       ")
_BLANK, _COMMA = b" ,"


def replace_words(data: bytes, at: IntArray, values: FloatArray) -> bytes:
    """Put the rows of `values` (l, k) in place of the k words after the one at each byte of `at`.

    data: starts and ends with a word.  Numbers have the shortest text that reads back the same.
    """
    bare = np.frombuffer(b" %b " % data.translate(_BLANKS), dtype=np.uint8)
    blank = bare == _BLANK
    starts = np.flatnonzero(blank[:-1] & ~blank[1:])
    stops = np.flatnonzero(~blank[:-1] & blank[1:])
    k = values.shape[1]
    words = (np.searchsorted(starts, at)[:, None] + np.arange(1, k + 1)).ravel()
    starts, stops = starts[words], stops[words]
    text, lengths = _texts(values)
    growth = lengths - (stops - starts)
    after = starts + np.cumsum(growth) - growth
    new = _inside(after, after + lengths, len(data) + int(growth.sum()))
    result = np.empty(len(new), dtype=np.uint8)
    result[new] = text
    result[~new] = np.frombuffer(data, dtype=np.uint8)[~_inside(starts, stops, len(data))]
    return result.tobytes()


def _texts(values: FloatArray) -> tuple[FloatArray, IntArray]:
    """The bytes of all numbers one after another, and how many each has."""
    listed = repr(values.ravel().tolist()).encode()[1:-1]
    commas = np.flatnonzero(np.frombuffer(listed, dtype=np.uint8) == _COMMA)
    ends = np.concatenate([commas, [len(listed)]])
    # Two bytes, a comma and a blank, lie between numbers.
    lengths = np.diff(ends, prepend=-2) - 2
    return np.frombuffer(listed.translate(None, b", "), dtype=np.uint8), lengths


def _inside(starts: IntArray, stops: IntArray, size: int) -> BoolArray:
    """(size,) whether a place lies in one of these ranges, which do not touch."""
    edges = np.zeros(size + 1, dtype=np.int8)
    edges[starts] = 1
    edges[stops] = -1
    return np.cumsum(edges[:-1], dtype=np.int8).view(bool)
