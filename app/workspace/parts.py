"""The parts of what is open: the connected pieces of the mesh, and which of them are hidden."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass

import numpy as np

from solver.mesh.mesh import Mesh
from solver.types import BoolArray, IntArray

NO_PIECE = -1  # of a vertex that no polygon has, see Mesh.pieces


@dataclass(frozen=True)
class Part:
    """number: of the piece, as in Mesh.pieces.  count: of its vertices."""

    number: int
    name: str
    count: int


class Parts:
    """The parts of a mesh. A hidden one is neither seen, picked nor painted; it still follows.

    hidden: their numbers.  visible: (n,) the vertices of what is seen.
    faces: the triangles that are seen.  seen: (p,) the polygons of the file, None for all.
    """

    def __init__(self, mesh: Mesh) -> None:
        self._mesh = mesh
        self.all = _parts(mesh)
        self.hidden: frozenset[int] = frozenset()
        self._hide(self.hidden)

    def show(self, number: int, on: bool) -> None:
        """Show a part again, or hide it."""
        self._hide(self.hidden - {number} if on else self.hidden | {number})

    def name(self, number: int) -> str:
        """What a piece is called; empty for none."""
        return self.all[number].name if 0 <= number < len(self.all) else ""

    @property
    def framed(self) -> IntArray:
        """The vertices of all that is seen; where everything is hidden, of the whole mesh."""
        seen = self.visible
        return np.flatnonzero(seen if seen.any() else self._mesh.pieces != NO_PIECE)

    def _hide(self, hidden: frozenset[int]) -> None:
        self.hidden = hidden
        self.visible: BoolArray = ~np.isin(self._mesh.pieces, [NO_PIECE, *hidden])
        self.faces: IntArray = self._mesh.faces[self.visible[self._mesh.faces[:, 0]]]
        outlines = self._mesh.outlines
        first = outlines.corners[outlines.starts]
        self.seen: BoolArray | None = self.visible[first] if hidden else None


def _parts(mesh: Mesh) -> tuple[Part, ...]:
    counts = np.bincount(mesh.pieces[mesh.pieces >= 0])
    names = _names(mesh, len(counts))
    return tuple(Part(*row) for row in zip(range(len(counts)), names, counts.tolist(), strict=True))


def _names(mesh: Mesh, count: int) -> list[str]:
    """The object or group of the file that each piece is in, with its number where not alone."""
    names = [""] * count
    if mesh.groups is not None:
        piece = mesh.pieces[mesh.outlines.corners[mesh.outlines.starts]]
        _, first = np.unique(piece, return_index=True)
        # Polygons of no group have -1, the place of the last entry.
        known = [*mesh.groups.names, ""]
        names = [known[group] for group in mesh.groups.of_polygon[first].tolist()]
    shared = Counter(names)
    return [
        name if name and shared[name] == 1 else f"{name or 'piece'} {number + 1}"
        for number, name in enumerate(names)
    ]
