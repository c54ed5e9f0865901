"""The rows of a PLY file, text or binary, one element after another."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from typing import Any, Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from solver.errors import MeshError
from solver.mesh.formats.ply.header import Element, Header
from solver.mesh.formats.text import Text
from solver.types import FloatArray, IntArray

Lists = tuple[IntArray, IntArray]


class Rows(NamedTuple):
    """Where each property of each row starts, in bytes, and its length: (rows, properties) both."""

    starts: IntArray
    lengths: IntArray


class Body(ABC):
    """Reads each element in turn, in the order of the header; every call takes one."""

    @abstractmethod
    def columns(self, element: Element, names: Sequence[str]) -> list[FloatArray]:
        """The named numbers of every row."""

    @abstractmethod
    def lists(self, element: Element, name: str) -> Lists:
        """The named list of every row: lengths, and all entries one after another."""

    @abstractmethod
    def skip(self, element: Element) -> None:
        """Pass over the element."""


class TextBody(Body):
    """One row a line."""

    def __init__(self, data: bytes, name: str, header: Header) -> None:
        lines = data.splitlines(keepends=True)
        self._text = Text(name, lines, lines)
        first = len(data[: header.end].splitlines())
        self._at = [i for i in range(first, len(lines)) if lines[i].strip()]

    def columns(self, element: Element, names: Sequence[str]) -> list[FloatArray]:
        chosen = [element.position(name) for name in names]
        cells = [self._cells(element, line) for line in self._take(element)]
        values = [[row[k][0] for k in chosen] for row in cells]
        return list(np.array(values, dtype=np.float64).reshape(-1, len(names)).T)

    def lists(self, element: Element, name: str) -> Lists:
        chosen = element.position(name)
        found = [self._cells(element, line)[chosen] for line in self._take(element)]
        sizes = np.array([len(entries) for entries in found], dtype=np.int64)
        return sizes, np.array([v for entries in found for v in entries], dtype=np.int64)

    def skip(self, element: Element) -> None:
        self._take(element)

    def _take(self, element: Element) -> list[int]:
        taken, self._at = self._at[: element.count], self._at[element.count :]
        if len(taken) < element.count:
            raise MeshError(
                f"{self._text.name}: the file ends early, expected {element.count} lines of "
                f"{element.name!r}, got {len(taken)}"
            )
        return taken

    def _cells(self, element: Element, line: int) -> list[list[float]]:
        """The numbers of each property of a row, one for a number and all of a list."""
        row, at = self._text.bare[line].split(), 0
        cells = []
        try:
            for entry in element.properties:
                size = 1
                if entry.length_type is not None:
                    size, at = int(row[at]), at + 1
                number = _whole if entry.length_type and entry.type[0] != "f" else float
                cells.append([number(word) for word in row[at : at + size]])
                at += size
                if len(cells[-1]) != size:
                    raise IndexError(at)
        except (ValueError, IndexError) as error:
            names = " ".join(entry.name for entry in element.properties)
            raise self._text.error(line, f"expected {element.name!r}: {names}") from error
        return cells


def _whole(word: bytes) -> int:
    number = int(word)
    if abs(number) >= 2**63:
        raise ValueError(f"{number} does not fit 64 bits")
    return number


class BinaryBody(Body):
    """Rows of bytes: numbers are read from where they start, all rows of a property at once."""

    def __init__(self, data: bytes, name: str, header: Header) -> None:
        self._data, self._bytes = data, np.frombuffer(data, dtype=np.uint8)
        self._name, self._at = name, header.end
        self._endian: Literal["little", "big"] = "big" if header.byte_order == ">" else "little"

    def columns(self, element: Element, names: Sequence[str]) -> list[FloatArray]:
        layout = self._take(element)
        chosen = [element.position(name) for name in names]
        types = [element.properties[k].type for k in chosen]
        found = [
            self._gather(layout.starts[:, k], layout.lengths[:, k], kind)
            for k, kind in zip(chosen, types, strict=True)
        ]
        return [values.astype(np.float64) for values in found]

    def lists(self, element: Element, name: str) -> Lists:
        layout = self._take(element)
        k = element.position(name)
        starts, lengths = layout.starts[:, k], layout.lengths[:, k]
        entries = self._gather(starts, lengths, element.properties[k].type)
        return lengths, entries.astype(np.int64)

    def skip(self, element: Element) -> None:
        self._take(element)

    def _take(self, element: Element) -> Rows:
        if not (element.count and element.properties):
            empty = np.zeros((0, len(element.properties)), dtype=np.int64)
            return Rows(empty, empty)
        return self._equal_rows(element) or self._walk(element)

    def _equal_rows(self, element: Element) -> Rows | None:
        """The layout where every row has the lengths of the first, else None."""
        starts, lengths, end = self._row(element, self._at)
        stride = end - self._at
        if self._at + element.count * stride > len(self._data):
            return None
        rows = np.arange(element.count, dtype=np.int64)[:, None]
        layout = Rows(
            np.array(starts) + stride * rows, np.tile(lengths, (element.count, 1)).astype(np.int64)
        )
        for k, entry in enumerate(element.properties):
            if entry.length_type is not None:
                at = layout.starts[:, k] - np.dtype(entry.length_type).itemsize
                if (self._gather(at, np.ones_like(at), entry.length_type) != lengths[k]).any():
                    return None
        self._at += element.count * stride
        return layout

    def _walk(self, element: Element) -> Rows:
        """The layout of rows of different lengths, found row by row."""
        starts, lengths = [], []
        for _ in range(element.count):
            row_starts, row_lengths, self._at = self._row(element, self._at)
            starts.append(row_starts)
            lengths.append(row_lengths)
        return Rows(np.array(starts, dtype=np.int64), np.array(lengths, dtype=np.int64))

    def _row(self, element: Element, at: int) -> tuple[list[int], list[int], int]:
        """Starts and lengths of the properties of the row at byte `at`, and where it ends."""
        starts, lengths = [], []
        for entry in element.properties:
            length = 1
            if entry.length_type is not None:
                after = at + int(entry.length_type[1])
                signed = entry.length_type[0] == "i"
                length = int.from_bytes(self._data[at:after], self._endian, signed=signed)
                at = after
            starts.append(at)
            lengths.append(length)
            at += length * int(entry.type[1])
            if length < 0 or at > len(self._data):
                raise MeshError(
                    f"{self._name}: the file ends early or is damaged, expected {element.count} "
                    f"rows of {element.name!r}"
                )
        return starts, lengths, at

    def _gather(self, starts: IntArray, lengths: IntArray, kind: str) -> NDArray[Any]:
        """All numbers of lists that start at these bytes, one after another."""
        size = int(kind[1])
        first = np.repeat(starts - size * (np.cumsum(lengths) - lengths), lengths)
        at = first + size * np.arange(len(first))
        stored = np.dtype(kind).newbyteorder(self._endian)
        return np.asarray(self._bytes[at[:, None] + np.arange(size)].view(stored)[:, 0])
