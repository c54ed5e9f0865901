"""The borders of what is held: fixed vertices and handles."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from app.latest import Latest
from app.model.document import Document
from app.model.handles import FIXED
from app.scene.scene import Lines
from solver.types import BoolArray, FloatArray, IntArray

SELECTED, DARK = (1.0, 1.0, 1.0), (0.1, 0.1, 0.13)


@dataclass(frozen=True, eq=False)
class Borders:
    """edges: (k, 2) vertices of the mesh.  role: (k,) FIXED or the handle's key of each."""

    edges: IntArray
    role: IntArray

    def of(self, key: int) -> IntArray:
        """(j, 2) the border of one handle."""
        return self.edges[self.role == key]

    @cached_property
    def drawn(self) -> BoolArray:
        """(k,) all but every other edge of what is fixed, whose border is a broken line."""
        return (self.role != FIXED) | (self.edges.sum(axis=1) % 2 == 0)

    @cached_property
    def nodes(self) -> IntArray:
        """(j,) the vertices of what is drawn, ascending."""
        return np.unique(self.edges[self.drawn])

    @cached_property
    def ends(self) -> IntArray:
        """The drawn edges as places in `nodes`, two each."""
        return np.searchsorted(self.nodes, self.edges[self.drawn])


class Regions:
    """Finds the borders anew when roles have changed.

    An edge is a border where both ends are held alike and the third corner of a triangle is not.
    """

    def __init__(self) -> None:
        self._borders: Latest[Borders] = Latest()

    def borders(self, document: Document) -> Borders:
        """Those of all regions; the same object as long as nothing has changed."""
        return self._borders(document.revision["role"], lambda: _borders(document))


def _borders(document: Document) -> Borders:
    faces = document.mesh.faces
    role = document.role[faces]
    mixed = (role[:, 0] != role[:, 1]) | (role[:, 1] != role[:, 2])
    faces, role = faces[mixed], role[mixed]
    edges, roles = [], []
    for corner in range(3):
        a, b = (corner + 1) % 3, (corner + 2) % 3
        held = (role[:, a] == role[:, b]) & (role[:, a] >= FIXED) & (role[:, corner] != role[:, a])
        edges.append(faces[held][:, [a, b]])
        roles.append(role[held, a])
    return Borders(np.concatenate(edges), np.concatenate(roles))


def border_lines(
    borders: Borders, positions: FloatArray, selected: Sequence[int], radius: float
) -> Lines | None:
    """The borders as drawn: of selected handles white, of other handles dark, of what is fixed
    dark and broken, so that no colour is needed to tell them apart."""
    if not len(borders.nodes):
        return None
    white = np.isin(borders.role[borders.drawn], selected)
    colors = np.where(white[:, None], SELECTED, DARK)
    return Lines(positions[borders.nodes], borders.ends, colors, radius)
