"""What begins a placement: a press on the gizmo, or a key."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from app.scene.overlay import NOTHING, Overlay
from app.tools.gizmo.freedoms import TurnAbout, TurnFreely
from app.tools.gizmo.placement import Placement, free_freedom
from app.tools.gizmo.shape import Gizmo, Part
from app.viewpoint.camera import Camera
from app.viewpoint.events import Input
from app.workspace.interaction import Interaction
from app.workspace.placing import axes_of
from app.workspace.workspace import Workspace
from solver.types import FloatArray


def begin_gizmo(work: Workspace, press: Input) -> Interaction | None:
    """What the part of the gizmo under the cursor does, as long as the button is down."""
    pivot, gizmo = work.pivot, _gizmo(work, press.camera)
    part = gizmo.under(press.pixel) if gizmo is not None and press.pixel is not None else None
    if pivot is None or part is None:
        return None
    kind = "Turn" if isinstance(part.freedom, TurnAbout | TurnFreely) else "Move"
    return Placement(work, kind, part.freedom, pivot, press.pixel, modal=False)


def begin_operator(work: Workspace, kind: str) -> Interaction | None:
    """A placement that follows the cursor without a button. kind: of Placement.

    None where nothing is selected that has vertices.
    """
    pivot = work.pivot
    if pivot is None:
        return None
    camera = work.viewpoint.camera
    start = None if work.last_input is None else work.last_input.pixel
    freedom = free_freedom(kind, pivot, camera, _axes(work, camera))
    return Placement(work, kind, freedom, pivot, start, modal=True)


def gizmo_cursor(work: Workspace, frame: Input) -> tuple[Overlay, Part | None]:
    """The gizmo, and what of it is under the cursor, which is bright; nothing during a drag."""
    gizmo = _gizmo(work, work.viewpoint.camera)
    if gizmo is None or work.interaction is not None:
        return NOTHING, None
    if frame.pixel is None or frame.down or frame.alt:
        return gizmo.overlay(), None
    part = gizmo.under(frame.pixel)
    return gizmo.overlay(part), part


def _gizmo(work: Workspace, camera: Camera) -> Gizmo | None:
    """None where it is switched off, there is nothing to place, or the camera is past it.

    Nor for a pin: it is there to be dragged, and the next may be put right beside it.
    """
    active = work.active
    shows = work.placing.gizmo and active is not None and not active.pin
    pivot = work.pivot if shows else None
    if pivot is None or camera.depth(pivot) <= 0:
        return None
    return _gizmo_at(tuple(pivot.tolist()), _axes(work, camera).tobytes(), camera)


@lru_cache(maxsize=1)
def _gizmo_at(pivot: tuple[float, ...], axes: bytes, camera: Camera) -> Gizmo:
    """The same object as long as camera and handle rest."""
    return Gizmo(np.array(pivot), np.frombuffer(axes).reshape(3, 3), camera)


def _axes(work: Workspace, camera: Camera) -> FloatArray:
    transform = work.document.pose.of(work.selected[0].key)
    return axes_of(work.placing.axes, transform, camera)
