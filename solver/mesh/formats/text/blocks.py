"""Text files in blocks of whole lines, and where the words of a block lie, by array operations.

Lists of a million lines and of their words take tens of times the file's memory, and seconds.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from solver.mesh.progress import Progress
from solver.types import BoolArray, FloatArray, IntArray

Bytes = NDArray[np.uint8]

# Small enough that a block's arrays stay in a processor's cache.
_SIZE = 1 << 20
# What separates words, besides the end of a line.
_BLANKS = bytes.maketrans(b"\t\r\v\f", b"    ")
_NEWLINE, _BLANK, _HASH = b"\n #"


def blocks(data: bytes, start: int, comments: bool, progress: Progress) -> Iterator[Block]:
    """The file from byte `start` on; lines end in a line feed.

    comments: what follows a `#` in its line is left out.
    """
    while start < len(data):
        stop = data.find(b"\n", start + _SIZE) + 1 or len(data)
        text = np.frombuffer(b"\n%b\n" % data[start:stop].translate(_BLANKS), dtype=np.uint8)
        yield Block(start, stop, _without_comments(text) if comments else text)
        start = stop
        progress(start / len(data))


@dataclass(frozen=True, eq=False)
class Block:
    """Bytes `start` to `stop` of a file; in `text` a line feed comes before and after them."""

    start: int
    stop: int
    text: Bytes

    @cached_property
    def _blank(self) -> BoolArray:
        return blank(self.text)

    @cached_property
    def word_starts(self) -> IntArray:
        """(w,) where in `text` each word starts."""
        return np.flatnonzero(self._blank[:-1] & ~self._blank[1:]) + 1

    @cached_property
    def word_stops(self) -> IntArray:
        """(w,) the blank after each word."""
        return np.flatnonzero(~self._blank[:-1] & self._blank[1:]) + 1

    @cached_property
    def first_words(self) -> IntArray:
        """(l,) the first word of each line that has one."""
        return self._lines[0]

    @cached_property
    def word_counts(self) -> IntArray:
        """(l,) how many words each of these lines has."""
        return self._lines[1]

    @cached_property
    def _lines(self) -> tuple[IntArray, IntArray]:
        ends = np.flatnonzero(self.text == _NEWLINE)
        first = np.searchsorted(self.word_starts, ends)
        count = np.diff(first)
        filled = count > 0
        return first[:-1][filled], count[filled]

    def places(self, words: IntArray) -> IntArray:
        """Where in the file these words start."""
        return self.word_starts[words] + (self.start - 1)

    def ends(self, words: IntArray) -> IntArray:
        """Where in the file these words end."""
        return self.word_stops[words] + (self.start - 1)

    def joined(self, first: IntArray, last: IntArray) -> bytes:
        """The words first[i] .. last[i] of each i, in the order of the file, with their blanks."""
        edges = np.zeros(len(self.text) + 1, dtype=np.int8)
        edges[self.word_starts[first]] = 1
        # A range stops after the blank behind it, where the next may start.
        edges[self.word_stops[last] + 1] -= 1
        return self.text[np.cumsum(edges[:-1], dtype=np.int8).view(bool)].tobytes()


def blank(text: Bytes) -> BoolArray:
    """Which bytes of a block's text separate words."""
    return np.asarray((text == _BLANK) | (text == _NEWLINE))


def numbers(text: bytes) -> FloatArray:
    """Every word as a number, as `float` reads it. Raises ValueError."""
    return np.fromiter(map(float, text.split()), dtype=np.float64)


def whole_numbers(text: bytes) -> IntArray:
    """Every word as a whole number, as `int` reads it. Raises ValueError, OverflowError."""
    if not text.translate(None, b"0123456789 \n"):
        found = np.fromstring(text, dtype=np.int64, sep=" ")
        # Larger ones have been cut to what fits.
        if found.max(initial=0) < 10**18:
            return found
    return np.fromiter(map(int, text.split()), dtype=np.int64)


def _without_comments(text: Bytes) -> Bytes:
    hashes = np.flatnonzero(text == _HASH)
    if not hashes.size:
        return text
    ends = np.flatnonzero(text == _NEWLINE)
    line, first = np.unique(np.searchsorted(ends, hashes), return_index=True)
    edges = np.zeros(len(text), dtype=np.int8)
    edges[hashes[first]] = 1
    edges[ends[line]] = -1
    return np.where(np.cumsum(edges, dtype=np.int8).view(bool), np.uint8(_BLANK), text)
