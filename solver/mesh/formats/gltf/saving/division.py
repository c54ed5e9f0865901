"""A surface divided by the objects or groups of the file that it comes from."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from solver.mesh.formats.format import DeformedSurface
from solver.types import IntArray


@dataclass(frozen=True, eq=False)
class Share:
    """What of a surface becomes one mesh of a file.

    name: empty for none.  vertices: (k,) of the surface.  faces: (m, 3) triangles over those.
    """

    name: str
    vertices: IntArray
    faces: IntArray


def divide(surface: DeformedSurface) -> list[Share]:
    """The surface by its groups, in the order of their vertices; one share where it has none.

    Vertices keep their order as far as groups leave it. One that several groups use is in each, one
    that no face uses goes with the vertex before it.
    """
    count, F = len(surface.positions), surface.triangles
    groups = surface.groups
    if groups is None:
        return [Share("", np.arange(count), F)]
    group = groups.of_polygon[surface.polygon_of_triangle]
    owned = _members(_owners(group, F, count))
    shares = []
    for number, own in _members(group).items():
        faces = F[own]
        vertices = np.union1d(faces, owned.get(number, faces))
        name = groups.names[number] if number >= 0 else ""
        shares.append(Share(name, vertices, np.searchsorted(vertices, faces)))
    return sorted(shares, key=lambda share: int(share.vertices[0]))


def _members(group: IntArray) -> dict[int, IntArray]:
    """For each number in `group` where it stands, in order."""
    order = np.argsort(group, kind="stable")
    numbers, first = np.unique(group[order], return_index=True)
    return dict(zip(numbers.tolist(), np.split(order, first[1:]), strict=True))


def _owners(group: IntArray, F: IntArray, count: int) -> IntArray:
    """(n,) for a vertex without a face the group that it goes with, else one that names it."""
    owner = np.full(count, -2)
    owner[F.ravel()] = np.repeat(group, 3)
    known = np.flatnonzero(owner > -2)
    before = np.searchsorted(known, np.arange(count), side="right") - 1
    return owner[known[np.maximum(before, 0)]]
