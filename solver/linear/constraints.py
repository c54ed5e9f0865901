"""Hard constraints: which rows of the system are held, and by which handle."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from solver.geometry.topology import components
from solver.linear.rest_surface import RestSurface
from solver.setup import FREE, Setup
from solver.surface.attachments import Attachments
from solver.types import BoolArray, FloatArray, IntArray

# Held points count as lying in one plane when their thickness is below this share of their extent.
PLANAR = 1e-3


@dataclass(frozen=True)
class Constraints:
    """Hard constraints of one bind.

    handles: the vertices of each movable handle.
    row_group: (n + 3m,) FREE, FIXED or 1 + h for each row of U.
    free: the rows to solve for. A body that nothing holds is not among them.
    attachments: those in force.  row_body: (n + 3m,) the number of each row's body: pieces that
    are attached to each other.  held_bodies: (bodies,) whether anything holds that body.
    """

    handles: tuple[IntArray, ...]
    row_group: IntArray
    free: IntArray
    attachments: Attachments
    row_body: IntArray
    held_bodies: BoolArray


def build_constraints(rest: RestSurface, setup: Setup) -> Constraints:
    """Fixed vertices and handles are held; so are their triangles' frames if `orientation`.

    Raises ConstraintError, see Setup.groups.
    """
    group = setup.groups(len(rest.vertices))
    attachments = attachments_in_force(rest, setup)
    body = attached_bodies(rest, attachments)
    held = held_bodies(body, group)
    oriented = group != FREE if setup.orientation else _underdetermined(rest, group)
    face_group = _face_groups(rest, group, oriented)
    row_group = rest.rows(group, face_group)
    row_body = rest.rows(body, body[rest.faces[:, 0]])
    free = np.flatnonzero((row_group == FREE) & held[row_body])
    return Constraints(setup.handles, row_group, free, attachments, row_body, held)


def attachments_in_force(rest: RestSurface, setup: Setup) -> Attachments:
    """Those of the pieces that follow. Raises ConstraintError, see Setup.follows."""
    possible = rest.attachments
    count = int(rest.pieces.max()) + 1
    return possible.where(setup.follows(possible.follower, count))


def held_bodies(body: IntArray, group: IntArray) -> BoolArray:
    """(bodies,) whether a group holds a vertex of each, for the body and group (n,) of each."""
    held = np.zeros(int(body.max()) + 1, dtype=bool)
    held[body[group != FREE]] = True
    return held


def attached_bodies(rest: RestSurface, attachments: Attachments) -> IntArray:
    """(n,) components of vertices, those that are attached to each other taken together."""
    component = rest.topology.vertex_component
    if len(attachments) == 0:
        return component
    ends = np.column_stack([attachments.vertex, rest.faces[attachments.face, 0]])
    return components(component[ends], int(component.max()) + 1)[component]


def _pieces(rest: RestSurface, group: IntArray) -> IntArray:
    """(n,) a number for each group in each component."""
    return np.asarray(rest.topology.vertex_component * (group.max() + 2) + group - FREE)


def _face_groups(rest: RestSurface, group: IntArray, oriented: BoolArray) -> IntArray:
    """(m,) the group that holds each triangle's frame.

    A group holds the triangles whose corners all belong to it. Where it has none in some
    component (a single vertex, a line) it holds the triangles around: a seed vertex with its frame.
    oriented: (n,) the held vertices whose group holds frames at all.
    """
    faces = rest.faces
    corners = group[faces]
    whole = (corners == corners[:, :1]).all(axis=1) & oriented[faces[:, 0]]
    face_group = np.where(whole, corners[:, 0], FREE)
    piece = _pieces(rest, group)
    lacking = oriented & ~np.isin(piece, piece[faces[whole, 0]])
    for vertex in faces.T:
        around = (face_group == FREE) & lacking[vertex]
        face_group = np.where(around, group[vertex], face_group)
    return face_group


def _underdetermined(rest: RestSurface, group: IntArray) -> BoolArray:
    """(n,) the held vertices around which positions alone leave the frames open.

    A flat group leaves its normal open, and frames mirror. Where all that is held in a component
    lies in a plane, on a line or in a point, the rest is free to turn or mirror about it.
    """
    held = np.flatnonzero(group != FREE)
    own = _extents(rest.points[held], _pieces(rest, group)[held])
    together = _extents(rest.points[held], rest.topology.vertex_component[held])
    flat = (own[:, 0] <= PLANAR * own[:, 2]) & (own[:, 1] > PLANAR * own[:, 2])
    result = np.zeros(len(group), dtype=bool)
    result[held] = flat | (together[:, 0] <= PLANAR * together[:, 2])
    return result


def _extents(points: FloatArray, label: IntArray) -> FloatArray:
    """(k, 3) how far the points that share a point's label extend, thinnest direction first."""
    _, label = np.unique(label, return_inverse=True)
    count = np.bincount(label)
    mean = np.column_stack([np.bincount(label, points[:, axis]) for axis in range(3)])
    offset = points - (mean / count[:, None])[label]
    scatter = np.zeros((len(count), 3, 3))
    np.add.at(scatter, label, offset[:, :, None] * offset[:, None, :])
    return np.asarray(np.sqrt(np.linalg.eigvalsh(scatter).clip(min=0.0))[label])
