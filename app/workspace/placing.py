"""How handles are placed exactly: about which point they turn, along which axes they move."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from app.latest import Latest
from app.model.document import Document
from app.model.handles import FREE, rotation_of
from app.viewpoint.camera import Camera
from solver.geometry.motions import moved
from solver.types import FloatArray, IntArray

AXES = ("world", "local", "view")
PIVOTS = ("centre", "joint", "point", "free")


@dataclass(frozen=True)
class Placing:
    """What a person chose.

    gizmo: whether it shows.  axes: one of AXES, local ones turn with the active handle.
    pivot: one of PIVOTS; the joint is where a handle borders on what is free; free: about the
        centre, and then to where the surface takes it.
    points: the point picked for a handle, (3,) at rest, by its key and the rest shape's number.
    """

    gizmo: bool = True
    axes: str = "world"
    pivot: str = "centre"
    points: Mapping[tuple[int, int], FloatArray] = field(default_factory=dict)


class Pivots:
    """Finds the pivot of handles; what that takes at rest is found again where that differs."""

    def __init__(self, edges: IntArray) -> None:
        """edges: (e, 2) of the mesh."""
        self._edges = edges
        self._anchors: Latest[list[tuple[int, int, FloatArray]]] = Latest()

    def of(self, document: Document, keys: Sequence[int], placing: Placing) -> FloatArray | None:
        """(3,) the common pivot of handles where they are now, the active one first.

        Where the active one has no picked point, or none of them a joint, it is the centre.
        None where they have no vertices.
        """
        rest = document.surface_number
        if keys and placing.pivot == "point" and (keys[0], rest) in placing.points:
            return moved(document.pose.of(keys[0]), placing.points[keys[0], rest])
        joint = placing.pivot == "joint"
        version = rest, document.revision["role"], tuple(keys), joint
        anchors = self._anchors(version, lambda: self._found(document, keys, joint))
        if not anchors:
            return None
        count = sum(count for _, count, _ in anchors)
        means = (k * moved(document.pose.of(key), mean) for key, k, mean in anchors)
        return np.asarray(sum(means) / count)

    def _found(
        self, document: Document, keys: Sequence[int], joint: bool
    ) -> list[tuple[int, int, FloatArray]]:
        """For each handle that has some: its key, how many vertices, and their mean at rest."""
        rest = document.rest_positions
        sets = {key: self._joint(document.role, key) for key in keys} if joint else {}
        if not any(map(len, sets.values())):
            sets = {key: document.vertices_of(key) for key in keys}
        return [(key, len(own), rest[own].mean(axis=0)) for key, own in sets.items() if len(own)]

    def _joint(self, role: IntArray, key: int) -> IntArray:
        """The vertices of a handle with a free neighbour."""
        own, free = role[self._edges] == key, role[self._edges] == FREE
        return np.unique(self._edges[own & free[:, ::-1]])


def axes_of(name: str, transform: FloatArray, camera: Camera) -> FloatArray:
    """(3, 3) rows x, y, z of one of AXES, for a handle with this transform (4, 4)."""
    if name == "local":
        return rotation_of(transform).T
    if name == "view":
        return np.stack([camera.right, camera.up, -camera.forward])
    return np.eye(3)
