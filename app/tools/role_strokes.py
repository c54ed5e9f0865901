"""What strokes of the fixed and the handle brush leave on the vertices they touch: roles."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from app.model.document import Document
from app.model.handles import FIRST_HANDLE, FIXED, FREE
from app.model.history import Gesture
from app.tools.marks import Marks, Paint
from app.workspace.symmetry import mirrored_name
from app.workspace.workspace import Workspace
from solver.geometry.procrustes import rigid_motion
from solver.types import BoolArray, FloatArray, IntArray


class RolePaint:
    """Gives vertices a role; the last stroke wins."""

    def __init__(self, label: str, role: int) -> None:
        self.label = label
        self._role = role

    def dab(self, gesture: Gesture, vertices: IntArray, weights: FloatArray) -> None:
        """All vertices the brush touches."""
        gesture.change("role", self._role, vertices)

    def finish(self, gesture: Gesture) -> None:
        """Nothing is left to do."""


class RoleEraser:
    """Frees the vertices whose role `erases` says so."""

    def __init__(
        self, document: Document, label: str, erases: Callable[[IntArray], BoolArray]
    ) -> None:
        self.label = label
        self._document = document
        self._erases = erases

    def dab(self, gesture: Gesture, vertices: IntArray, weights: FloatArray) -> None:
        """Only the vertices with a role to erase."""
        gesture.change("role", FREE, vertices[self._erases(self._document.role[vertices])])

    def finish(self, gesture: Gesture) -> None:
        """Nothing is left to do."""


class HandlePaint(RolePaint):
    """Paints a handle. One that had no vertices starts where the surface is, not where it was."""

    def __init__(self, work: Workspace, key: int) -> None:
        document = work.document
        handle = document.find(key)
        assert handle is not None
        super().__init__(f"Paint {handle.name}", key)
        self._work = work
        self._handle = handle
        self._starts = len(document.vertices_of(key)) == 0

    def finish(self, gesture: Gesture) -> None:
        """Fit the transform of a new handle to the surface on screen."""
        if not self._starts:
            return
        document = self._work.document
        vertices = document.vertices_of(self._handle.key)
        shown = self._work.positions[vertices]
        transform = rigid_motion(document.rest_positions[vertices], shown)
        pose = document.pose.moved(self._handle.key, transform)
        if pose != document.pose:
            gesture.change("pose", pose)


def _fixed_paint(work: Workspace, erase: bool, gesture: Gesture) -> Paint:
    if erase:
        return RoleEraser(work.document, "Erase fixed", lambda role: role == FIXED)
    return RolePaint("Paint fixed", FIXED)


def _handle_paint(work: Workspace, erase: bool, gesture: Gesture) -> Paint:
    """Adds to the active handle, or makes one; an eraser frees the vertices of any."""
    if erase:
        return RoleEraser(work.document, "Erase handle", lambda role: role >= FIRST_HANDLE)
    handle = work.active
    if handle is None or handle.pin:  # a pin stays the spot that it is
        handle = work.document.new_handle()
        gesture.change("handles", (*work.document.handles, handle))
    work.chosen.activate(handle.key)
    return HandlePaint(work, handle.key)


def _handle_across(work: Workspace, gesture: Gesture, meets: bool) -> Paint | None:
    """The handle across the mirror, or a new one; the same where both sides meet."""
    handle = work.active
    if work.symmetry is None or handle is None:
        return None
    key = work.symmetry.handle(work.document, handle.key)
    if key is None and not meets:
        other = work.document.new_handle(mirrored_name(handle.name))
        gesture.change("handles", (*work.document.handles, other))
        key = other.key
    return None if key is None or key == handle.key else HandlePaint(work, key)


def _in_handle(work: Workspace) -> BoolArray:
    role = work.document.role
    return np.zeros(len(role), dtype=bool) if work.active is None else role == work.active.key


def _free(work: Workspace) -> BoolArray:
    return np.asarray(work.document.role == FREE)


FIXED_MARKS = Marks(_fixed_paint, lambda work: work.document.role == FIXED, _free)
HANDLE_MARKS = Marks(_handle_paint, _in_handle, _free, _handle_across)
