"""What is painted and posed on one side of a mirror plane happens on the other too."""

from __future__ import annotations

import re
from collections.abc import Collection

import numpy as np

from app.latest import Latest
from app.model.document import Document
from app.model.handles import FIRST_HANDLE, Pose
from app.pointing.picking import Hit
from solver.geometry.reflection import Plane, find_plane, partners
from solver.mesh.mesh import Mesh
from solver.types import FloatArray, IntArray

# How far from its mirror image a partner may be, in the longest edges at the vertex.
NEAR = 1.0
AXES = {"x": 0, "y": 1, "z": 2}
# Words that tell the sides of a name apart, each with its opposite.
SIDES = (("left", "right"), ("Left", "Right"), ("LEFT", "RIGHT"), ("l", "r"), ("L", "R"))
SIDE = re.compile(
    r"(?:^|(?<=[ ._-]))(" + "|".join(word for pair in SIDES for word in pair) + r")(?=$|[ ._-])"
)


class Symmetry:
    """Which vertices are mirror images of each other; found once for a plane.

    plane: of the mirror.  partner: (n,) of each vertex, -1 where there is none; of one on the plane
    itself.
    """

    def __init__(self, mesh: Mesh, edges: IntArray, plane: Plane) -> None:
        """edges: (e, 2) of the mesh."""
        V = mesh.vertices
        length = np.linalg.norm(V[edges[:, 0]] - V[edges[:, 1]], axis=1)
        longest = np.zeros(len(V))
        for end in edges.T:
            np.maximum.at(longest, end, length)
        self.plane = plane
        self.partner = partners(V, plane, NEAR * longest)
        self._handles: Latest[dict[int, int | None]] = Latest()

    def image(self, vertices: IntArray) -> IntArray:
        """The partners of vertices (k,), without repetition; those without one are left out."""
        found = np.unique(self.partner[vertices])
        return found[found >= 0]

    def lonely(self, vertices: IntArray) -> int:
        """How many of some vertices have no partner."""
        return int((self.partner[vertices] < 0).sum())

    def hit(self, hit: Hit, positions: FloatArray) -> Hit | None:
        """The point of the surface on screen that mirrors a hit; None where nothing does."""
        partner = int(self.partner[hit.vertex])
        if partner < 0:
            return None
        S = self.plane.matrix[:3, :3]
        beside = S @ (hit.position - positions[hit.vertex])
        return Hit(hit.face, hit.barycentric, positions[partner] + beside, partner, hit.distance)

    def handle(self, document: Document, key: int) -> int | None:
        """The key of the handle that mirrors one, which may be itself; None where there is none.

        It is the one that has most of the images of its vertices; found again where roles differ.
        """
        found = self._handles(document.revision["role"], dict)
        if key not in found:
            found[key] = self._handle(document, key)
        return found[key]

    def _handle(self, document: Document, key: int) -> int | None:
        roles = document.role[self.image(document.vertices_of(key))]
        held = roles[roles >= FIRST_HANDLE]
        if not len(held):
            return None
        counts = np.bincount(held)
        best = int(counts.argmax())
        return best if 2 * counts[best] > len(roles) else None

    def transform(self, T: FloatArray) -> FloatArray:
        """(4, 4) the mirror image of a transform."""
        S = self.plane.matrix
        return np.asarray(S @ T @ S)

    def turn(self, turn: FloatArray) -> FloatArray:
        """(3,) the mirror image of a turn, which goes round the other way."""
        return np.asarray(-self.plane.matrix[:3, :3] @ turn)

    def copied(self, pose: Pose, source: Pose, key: int, other: int) -> Pose:
        """`pose` with handle `other` where the mirror image of handle `key` is in `source`."""
        return pose.moved(other, self.transform(source.of(key)), self.turn(source.turn(key)))

    def followed(self, document: Document, pose: Pose, keys: Collection[int]) -> Pose:
        """The pose with what mirrors handles `keys` where the mirror images of these are."""
        for key in keys:
            other = self.handle(document, key)
            if other is not None and other not in keys:
                pose = self.copied(pose, pose, key, other)
        return pose

    def mirrored(self, document: Document) -> tuple[Pose, list[int]]:
        """The mirror image of the pose, and the keys of moved handles that nothing mirrors."""
        pose, alone = Pose(), []
        for key, T in document.pose.transforms.items():
            partner = self.handle(document, key)
            if partner is not None:
                pose = self.copied(pose, document.pose, key, partner)
            elif not np.array_equal(T, np.eye(4)):
                alone.append(key)
        return pose, alone


def plane_of(mesh: Mesh, name: str) -> Plane | None:
    """The plane that a person names: across an axis, or "found" for what the mesh itself has.

    Across an axis it goes through the origin where the mesh lies on both sides of it, else through
    the middle of the mesh.
    """
    V = mesh.vertices[mesh.pieces >= 0]
    if name not in AXES:
        return find_plane(V)
    axis = AXES[name]
    low, high = V[:, axis].min(), V[:, axis].max()
    middle = 0.5 * (low + high)
    about = abs(middle) < 0.1 * (high - low)
    return Plane(np.eye(3)[axis], 0.0 if about else float(middle))


def mirrored_name(name: str) -> str:
    """The name of the other side: left and right exchanged, else one that says it is mirrored."""
    opposite = dict(SIDES) | {b: a for a, b in SIDES}
    swapped = SIDE.sub(lambda match: opposite[match[1]], name)
    return swapped if swapped != name else f"{name} mirrored"
