"""What the commands do with the mirror."""

from __future__ import annotations

import numpy as np

from app.editor import commands as c
from app.editor.action import Actions, check_name
from app.model.handles import FIRST_HANDLE, FIXED, FREE
from app.model.history import Gesture
from app.workspace.symmetry import AXES, Symmetry, mirrored_name, plane_of
from app.workspace.workspace import Workspace
from solver.types import IntArray

NAMES = ("off", "found", *AXES)


def set_symmetry(work: Workspace, command: c.SetSymmetry) -> None:
    check_name(command.name, NAMES, "mirror")
    if command.name == "off":
        work.symmetry, work.symmetry_name = None, "off"
        return
    work.symmetry, work.symmetry_name = _symmetry(work, command.name), command.name
    mesh = work.document.mesh
    lonely = work.symmetry.lonely(np.flatnonzero(mesh.pieces >= 0))
    rest = f"; {lonely:,} vertices have no partner" if lonely else ""
    work.say(f"What you paint and drag is mirrored{rest}")


def toggle_symmetry(work: Workspace, command: c.ToggleSymmetry) -> None:
    set_symmetry(work, c.SetSymmetry("off" if work.symmetry else "found"))


def mirror_pose(work: Workspace, command: c.MirrorPose) -> None:
    pose, alone = _mirror(work).mirrored(work.document)
    if alone:
        names = ", ".join(handle.name for handle in work.document.handles if handle.key in alone)
        raise c.CommandError(f"nothing mirrors {names}: mirror the regions first")
    with work.edit("Mirror pose") as gesture:
        gesture.change("pose", pose)


def mirror_regions(work: Workspace, command: c.MirrorRegions) -> None:
    symmetry, document = _mirror(work), work.document
    here = np.flatnonzero(document.role != FREE)
    here = here[_same_side(work, symmetry, here)]
    if not len(here):
        raise c.CommandError("nothing is painted on the side of the active handle")
    lonely = symmetry.lonely(here)
    with work.edit("Mirror regions") as gesture:
        _mirror_fixed(work, symmetry, gesture, here)
        for key in np.unique(document.role[here]):
            if key >= FIRST_HANDLE:
                _mirror_handle(work, symmetry, gesture, int(key))
        _mirror_softness(work, symmetry, gesture)
    if lonely:
        work.say(f"{lonely:,} vertices have no partner and were left out")


def _symmetry(work: Workspace, name: str) -> Symmetry:
    plane = plane_of(work.document.mesh, name)
    if plane is None:
        raise c.CommandError("the mesh is not symmetric; choose the mirror x, y or z instead")
    return Symmetry(work.document.mesh, work.neighbours.edges, plane)


def _mirror(work: Workspace) -> Symmetry:
    """The mirror in use, else the one that is found in the mesh."""
    return work.symmetry or _symmetry(work, "found")


def _same_side(work: Workspace, symmetry: Symmetry, vertices: IntArray) -> IntArray:
    """Places of those vertices that are on the side of the active handle, or of most of them."""
    V, plane = work.document.mesh.vertices, symmetry.plane
    away = V @ plane.normal - plane.offset
    active = work.active
    own = vertices if active is None else work.document.vertices_of(active.key)
    side = np.sign(away[own].sum()) or 1.0
    return np.flatnonzero(side * away[vertices] >= 0)


def _mirror_fixed(work: Workspace, symmetry: Symmetry, gesture: Gesture, here: IntArray) -> None:
    image = symmetry.image(here[work.document.role[here] == FIXED])
    gesture.change("role", FIXED, image[work.document.role[image] == FREE])


def _mirror_handle(work: Workspace, symmetry: Symmetry, gesture: Gesture, key: int) -> None:
    """Another handle of the vertices across, where none is there yet and they are free."""
    document = work.document
    handle = document.find(key)
    image = symmetry.image(document.vertices_of(key))
    image = image[document.role[image] == FREE]
    if handle is None or symmetry.handle(document, key) is not None or not len(image):
        return
    other = document.new_handle(mirrored_name(handle.name), handle.pin)
    gesture.change("handles", (*document.handles, other))
    gesture.change("role", other.key, image)
    gesture.change("pose", symmetry.copied(document.pose, document.pose, key, other.key))


def _mirror_softness(work: Workspace, symmetry: Symmetry, gesture: Gesture) -> None:
    document = work.document
    everything = np.flatnonzero(symmetry.partner >= 0)
    here = everything[_same_side(work, symmetry, everything)]
    across = symmetry.partner[here]
    across, first = np.unique(across, return_index=True)
    own = np.isin(across, here)  # on the plane both are one
    source = here[first]
    gesture.change("softness", document.softness[source[~own]], across[~own])
    gesture.change("pinned", document.pinned[source[~own]], across[~own])


SYMMETRY_ACTIONS: Actions = {
    c.SetSymmetry: set_symmetry,
    c.ToggleSymmetry: toggle_symmetry,
    c.MirrorPose: mirror_pose,
    c.MirrorRegions: mirror_regions,
}
