"""The rows of a binary PLY file, one element after another."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from solver.errors import MeshError
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
            stored = values[rows, column].astype(kind.newbyteorder(self._endian))
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
        starts, lengths, end = self._row(element, self._at)
        stride = end - self._at
        if self._at + element.count * stride > len(self._data):
            return None
        rows = np.arange(element.count, dtype=np.int64)[:, None]
        layout = Layout(
            np.array(starts) + stride * rows, np.tile(lengths, (element.count, 1)).astype(np.int64)
        )
        for k, entry in enumerate(element.properties):
            if entry.length_type is not None:
                at = layout.starts[:, k] - np.dtype(entry.length_type).itemsize
                if (self._gather(at, np.ones_like(at), entry.length_type) != lengths[k]).any():
                    return None
        self._at += element.count * stride
        return layout

    def _walk(self, element: Element) -> Layout:
        """The layout of rows of different lengths, found row by row."""
        starts, lengths = [], []
        for _ in range(element.count):
            row_starts, row_lengths, self._at = self._row(element, self._at)
            starts.append(row_starts)
            lengths.append(row_lengths)
        return Layout(np.array(starts, dtype=np.int64), np.array(lengths, dtype=np.int64))

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
