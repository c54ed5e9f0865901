"""The rows of a PLY file, text or binary: what both kinds can do."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence

from solver.mesh.formats.ply.header import Element
from solver.types import BoolArray, FloatArray, IntArray

Lists = tuple[IntArray, IntArray]


class Body(ABC):
    """Goes through the elements in turn, in the order of the header; every call takes one.

    Raises MeshError where the rows of an element are not as the header says.
    """

    @abstractmethod
    def columns(self, element: Element, names: Sequence[str]) -> FloatArray:
        """(rows, names) the named numbers of every row."""

    @abstractmethod
    def lists(self, element: Element, name: str) -> Lists:
        """The named list of every row: lengths, and all entries one after another."""

    @abstractmethod
    def skip(self, element: Element) -> None:
        """Pass over the element."""

    @abstractmethod
    def widened(self, element: Element, names: Sequence[str]) -> bytes:
        """The rows of the element, with float64 for the named numbers."""

    @abstractmethod
    def rest(self) -> bytes:
        """What follows the last element that was taken."""

    @abstractmethod
    def replaced(
        self, element: Element, names: Sequence[str], values: FloatArray, changed: BoolArray
    ) -> bytes:
        """The file with `values` for those of the named numbers that `changed` tells.

        Both are (rows, names).
        """
