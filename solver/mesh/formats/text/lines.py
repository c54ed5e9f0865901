"""Lines of a text file with their words, some thousands at a time."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass

import numpy as np

from solver.mesh.formats.text.blocks import Block
from solver.types import BoolArray, IntArray


@dataclass(frozen=True, eq=False)
class Lines:
    """Lines of one block that have words: the first word of each and how many it has, (l,)."""

    block: Block
    first: IntArray
    count: IntArray

    @classmethod
    def of(cls, block: Block) -> Lines:
        """Every line but the empty ones."""
        return cls(block, block.first_words, block.word_counts)

    def __len__(self) -> int:
        return len(self.first)

    def __getitem__(self, chosen: slice | IntArray) -> Lines:
        return Lines(self.block, self.first[chosen], self.count[chosen])

    @property
    def places(self) -> IntArray:
        """(l,) the bytes of the file where their first words start."""
        return self.block.places(self.first)

    def starting_with(self, keyword: bytes) -> Lines:
        """Those whose first word is this."""
        stops = self.block.word_stops[self.first]
        same = stops - self.block.word_starts[self.first] == len(keyword)
        return self[np.flatnonzero(same & self._begins(keyword))]

    def beginning_with(self, letters: bytes) -> Lines:
        """Those whose first word begins with these."""
        return self[np.flatnonzero(self._begins(letters))]

    def _begins(self, letters: bytes) -> BoolArray:
        at = self.block.word_starts[self.first]
        same = np.ones(len(self), dtype=bool)
        for k, letter in enumerate(letters):
            # A shorter word ends in a blank, so that only letters after a difference are cut off.
            same &= self.block.text[np.minimum(at + k, len(self.block.text) - 1)] == letter
        return same

    def words(self, i: int) -> list[bytes]:
        """All words of line i."""
        start = self.block.word_starts[self.first[i]]
        stop = self.block.word_stops[self.first[i] + self.count[i] - 1]
        return self.block.text[start:stop].tobytes().split()


class LineQueue:
    """The lines of blocks, without empty ones, that are taken one after another."""

    def __init__(self, blocks: Iterable[Block]) -> None:
        self._lines = map(Lines.of, blocks)
        self._left: Lines | None = None

    def take(self, count: int) -> Iterator[Lines]:
        """The next `count` lines, one or more at a time; fewer where the file ends."""
        while count > 0:
            lines = self._left or next(self._lines, None)
            if lines is None:
                return
            taken, self._left = lines[:count], lines[count:]
            count -= len(taken)
            if taken:
                yield taken


def first_failing(lines: Lines, read: Callable[[Lines], object]) -> int:
    """The first of the lines that `read` does not take, where it does not take all of them."""
    good, bad = 0, len(lines)
    while bad - good > 1:
        middle = (good + bad) // 2
        try:
            read(lines[:middle])
            good = middle
        except (ValueError, OverflowError):
            bad = middle
    return good
