"""The rows of a binary PLY file, one element after another."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from solver.errors import MeshError
from solver.mesh.formats.narrowing import narrowed
from solver.mesh.formats.ply.body import Body, Lists
from solver.mesh.formats.ply.header import Element, Header
from solver.mesh.progress import Progress
from solver.types import BoolArray, FloatArray, IntArray


class Layout(NamedTuple):
    """Where each property of each row starts, in bytes, and its length: (rows, properties) both."""

    starts: IntArray
    lengths: IntArray


class BinaryBody(Body):
    """Rows of bytes: numbers are read from where they start, all rows of a property at once."""

    def __init__(self, data: bytes, name: str, header: Header, progress: Progress) -> None:
        self._data, self._bytes = data, np.frombuffer(data, dtype=np.uint8)
        self._name, self._at, self._progress = name, header.end, progress
        self._endian: Literal["little", "big"] = "big" if header.byte_order == ">" else "little"

    def columns(self, element: Element, names: Sequence[str]) -> FloatArray:
        layout = self._take(element)
        result = np.empty((element.count, len(names)))
        for column, k in enumerate(map(element.position, names)):
            kind = element.properties[k].type
            with np.errstate(invalid="ignore"):  # a float32 may be no number, of any kind
                result[:, column] = self._gather(layout.starts[:, k], layout.lengths[:, k], kind)
        return result

    def lists(self, element: Element, name: str) -> Lists:
        layout = self._take(element)
        k = element.position(name)
        starts, lengths = layout.starts[:, k], layout.lengths[:, k]
        entries = self._gather(starts, lengths, element.properties[k].type)
        return lengths, entries.astype(np.int64)

    def skip(self, element: Element) -> None:
        self._take(element)

    def replaced(
        self, element: Element, names: Sequence[str], values: FloatArray, changed: BoolArray
    ) -> bytes:
        layout = self._take(element)
        result = self._bytes.copy()
        for column, k in enumerate(map(element.position, names)):
            kind = np.dtype(element.properties[k].type)
            rows = changed[:, column]
            stored = narrowed(values[rows, column], kind.newbyteorder(self._endian))
            at = layout.starts[rows, k][:, None] + np.arange(kind.itemsize)
            result[at] = stored.view(np.uint8).reshape(-1, kind.itemsize)
        return result.tobytes()

    def _take(self, element: Element) -> Layout:
        if not (element.count and element.properties):
            empty = np.zeros((0, len(element.properties)), dtype=np.int64)
            return Layout(empty, empty)
        layout = self._equal_rows(element) or self._walk(element)
        self._progress(self._at / len(self._data))
        return layout

    def _equal_rows(self, element: Element) -> Layout | None:
        """The layout where every row has the lengths of the first, else None."""
        lists, end = self._list_lengths(element, 1)
        first, stride = self._layout(element, lists), end - self._at
        if self._at + element.count * stride > len(self._data):
            return None
        starts = first.starts + stride * np.arange(element.count)[:, None]
        for k, entry in enumerate(element.properties):
            if entry.length_type is not None:
                at = starts[:, k] - int(entry.length_type[1])
                found = self._gather(at, np.ones_like(at), entry.length_type)
                if (found != first.lengths[0, k]).any():
                    return None
        self._at += element.count * stride
        return Layout(starts, np.repeat(first.lengths, element.count, axis=0))

    def _walk(self, element: Element) -> Layout:
        """The layout of rows of different lengths."""
        lists, end = self._list_lengths(element, element.count)
        layout = self._layout(element, lists)
        self._at = end
        return layout

    def _list_lengths(self, element: Element, rows: int) -> tuple[list[int], int]:
        """The length of every list in the next rows, and where these end.

        Row by row, for each starts where the one before ends.
        """
        data, endian, at = self._data, self._endian, self._at
        lists, rest = _gaps(element)
        lengths = []
        for _ in range(rows):
            for gap, width, signed, size in lists:
                at += gap + width
                length = int.from_bytes(data[at - width : at], endian, signed=signed)
                lengths.append(length)
                at += length * size if length >= 0 else len(data)
            at += rest
            if at > len(data):
                raise MeshError(
                    f"{self._name}: the file ends early or is damaged, expected {element.count} "
                    f"rows of {element.name!r}"
                )
        return lengths, at

    def _layout(self, element: Element, lists: list[int]) -> Layout:
        """Of the next rows, which have lists of these lengths."""
        head = np.array([int(e.length_type[1]) if e.length_type else 0 for e in element.properties])
        size = np.array([int(entry.type[1]) for entry in element.properties])
        count = np.count_nonzero(head)
        lengths = np.ones((len(lists) // count if count else 1, len(head)), dtype=np.int64)
        lengths[:, head > 0] = np.reshape(lists, (-1, count)) if count else 1
        taken = head + lengths * size
        ends = self._at + np.cumsum(taken).reshape(taken.shape)
        return Layout(ends - taken + head, lengths)

    def _gather(self, starts: IntArray, lengths: IntArray, kind: str) -> NDArray[Any]:
        """All numbers of lists that start at these bytes, one after another."""
        size = int(kind[1])
        first = np.repeat(starts - size * (np.cumsum(lengths) - lengths), lengths)
        at = first + size * np.arange(len(first))
        stored = np.dtype(kind).newbyteorder(self._endian)
        return np.asarray(self._bytes[at[:, None] + np.arange(size)].view(stored)[:, 0])


def _gaps(element: Element) -> tuple[list[tuple[int, int, bool, int]], int]:
    """For each list the bytes before it, those of its length, whether that has a sign, and those
    of an entry; and the bytes after the last list."""
    lists, gap = [], 0
    for entry in element.properties:
        if entry.length_type is None:
            gap += int(entry.type[1])
        else:
            kind = entry.length_type
            lists.append((gap, int(kind[1]), kind[0] == "i", int(entry.type[1])))
            gap = 0
    return lists, gap
