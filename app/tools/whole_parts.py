"""A double click: the whole part under the cursor, or the group of the file that it belongs to."""

from __future__ import annotations

import numpy as np

from app.tools.marks import Mark, Marks
from app.viewpoint.events import Input
from app.workspace.interaction import Interaction
from app.workspace.workspace import Workspace
from solver.mesh.mesh import Mesh
from solver.types import BoolArray

# From the fourth click on the place has been double-clicked before.
AGAIN = 4


def begin_part(work: Workspace, press: Input, marks: Marks) -> Interaction | None:
    """The connected piece under the cursor; its group where that has been taken, or erased."""
    hit = work.under(press)
    if hit is None:
        return None
    pieces = work.document.mesh.pieces
    part = pieces == pieces[hit.vertex]
    done = marks.marked(work) != press.shift
    if press.clicks >= AGAIN or done[part].all():
        part |= group_of(work.document.mesh, hit.vertex)
    return Mark(work, press, marks, np.flatnonzero(part & work.parts.visible))


def group_of(mesh: Mesh, vertex: int) -> BoolArray:
    """(n,) the vertices of the object or group of the file that a vertex is in; none without."""
    members = np.zeros(len(mesh.vertices), dtype=bool)
    if mesh.groups is None:
        return members
    corners = mesh.outlines.corners
    group = np.repeat(mesh.groups.of_polygon, mesh.outlines.sizes)
    own = group[corners == vertex]
    members[corners[np.isin(group, own[own >= 0])]] = True
    return members
