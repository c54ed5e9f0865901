"""The rows of a PLY file that is text: one a line."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import NamedTuple, TypeVar

import numpy as np

from solver.errors import MeshError
from solver.mesh.formats.ply.body import Body, Lists
from solver.mesh.formats.ply.header import Element, Header
from solver.mesh.formats.text.blocks import numbers, whole_numbers
from solver.mesh.formats.text.file import Flaw, TextFile
from solver.mesh.formats.text.lines import LineQueue, Lines, first_failing
from solver.mesh.formats.text.splice import Replacement, spliced
from solver.mesh.progress import Progress
from solver.types import BoolArray, FloatArray, IntArray

Found = TypeVar("Found")


class Cells(NamedTuple):
    """One property in some lines: its first word in each and how many it has there, (l,)."""

    first: IntArray
    size: IntArray


class TextBody(Body):
    """Reads some thousands of lines at a time."""

    def __init__(self, data: bytes, name: str, header: Header, progress: Progress) -> None:
        self._data, self._name, self._start = data, name, header.end
        self._file = TextFile(name, data)
        self._queue = LineQueue(self._file.blocks(header.end, progress=progress))

    def columns(self, element: Element, names: Sequence[str]) -> FloatArray:
        chosen = [element.position(name) for name in names]
        parts = [
            np.stack([found[k] for k in chosen], axis=1) for _, found in self._rows(element, _read)
        ]
        return np.concatenate([np.empty((0, len(names))), *parts])

    def lists(self, element: Element, name: str) -> Lists:
        k = element.position(name)
        none = np.empty(0, dtype=np.int64)
        sizes, entries = [none], [none]
        for lines, found in self._rows(element, _read):
            sizes.append(_cells(lines, element)[k].size)
            entries.append(found[k].astype(np.int64))
        return np.concatenate(sizes), np.concatenate(entries)

    def skip(self, element: Element) -> None:
        for _ in self._lines(element):
            pass

    def widened(self, element: Element, names: Sequence[str]) -> bytes:
        """A number in a text has no type of its own: no row changes, and `rest` has them all."""
        return b""

    def rest(self) -> bytes:
        return self._data[self._start :]

    def replaced(
        self, element: Element, names: Sequence[str], values: FloatArray, changed: BoolArray
    ) -> bytes:
        return b"".join(spliced(self._data, self._replacements(element, names, values, changed)))

    def _replacements(
        self, element: Element, names: Sequence[str], values: FloatArray, changed: BoolArray
    ) -> Iterator[Replacement]:
        # Columns as they lie in the file.
        order = np.argsort([element.position(name) for name in names])
        chosen = [element.position(names[k]) for k in order]
        done = 0
        for lines, cells in self._rows(element, _cells):
            rows = slice(done, done + len(lines))
            done = rows.stop
            these = changed[rows][:, order]
            words = np.stack([cells[k].first for k in chosen], axis=1)[these]
            starts, stops = lines.block.places(words), lines.block.ends(words)
            yield Replacement(starts, stops, values[rows][:, order][these])

    def _rows(
        self, element: Element, read: Callable[[Lines, Element], Found]
    ) -> Iterator[tuple[Lines, Found]]:
        """The lines of the element and what `read` finds in them."""
        flaw = None
        for lines in self._lines(element):
            if flaw is None:
                try:
                    yield lines, read(lines, element)
                except (ValueError, OverflowError):
                    bad = first_failing(lines, lambda some: read(some, element))
                    names = " ".join(entry.name for entry in element.properties)
                    flaw = Flaw(0, int(lines.places[bad]), f"expected {element.name!r}: {names}")
        if flaw is not None:
            raise self._file.error(flaw)

    def _lines(self, element: Element) -> Iterator[Lines]:
        found = 0
        for lines in self._queue.take(element.count):
            found += len(lines)
            yield lines
        if found < element.count:
            raise MeshError(
                f"{self._name}: the file ends early, expected {element.count} lines of "
                f"{element.name!r}, got {found}"
            )


def _cells(lines: Lines, element: Element) -> list[Cells]:
    """Where every property of the element lies. Raises ValueError or OverflowError."""
    at, end = lines.first, lines.first + lines.count
    cells = []
    for entry in element.properties:
        size = np.ones_like(at)
        if entry.length_type is not None:
            _check(end - at >= 1)
            size, at = whole_numbers(lines.block.joined(at, at)), at + 1
        _check((size >= 0) & (size <= end - at))
        cells.append(Cells(at, size))
        at = at + size
    return cells


def _read(lines: Lines, element: Element) -> list[FloatArray | IntArray]:
    """The numbers of every property, one after another. Raises ValueError or OverflowError."""
    result = []
    for entry, (first, size) in zip(element.properties, _cells(lines, element), strict=True):
        filled = size > 0
        text = lines.block.joined(first[filled], (first + size - 1)[filled])
        read = whole_numbers if entry.length_type and entry.type[0] != "f" else numbers
        result.append(read(text))
    return result


def _check(fits: BoolArray) -> None:
    if not fits.all():
        raise ValueError("a line is too short")
