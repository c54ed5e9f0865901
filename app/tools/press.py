"""What a press with the drag tool takes: a handle, bare surface, or nothing, and then why."""

from __future__ import annotations

from app.model.handles import FIXED
from app.scene.overlay import HOVERED, Outline, Overlay
from app.tools.drag import Drag
from app.tools.gizmo.begin import gizmo_cursor
from app.tools.grab import Grab
from app.tools.tool import brush_cursor
from app.viewpoint.events import Input
from app.workspace.interaction import HeldPress, Interaction
from app.workspace.nearby import near_handle
from app.workspace.workspace import Workspace

NEAR_HANDLE = 10.0  # pixels beside a handle that still count


def begin_drag(work: Workspace, press: Input) -> Interaction | None:
    """A drag of the handle at the cursor, which becomes the active one, else a soft grab."""
    near = near_handle(work, press, NEAR_HANDLE)
    if near is not None:
        key, point = near
        work.chosen.activate(key, alone=False)
        return Drag(work, press, key, point)
    hit = work.under(press)
    if hit is None:
        return None
    if work.document.role[hit.vertex] == FIXED:
        work.say("This is fixed and stays where it is: grab beside it, or free it (2, with Shift)")
        return HeldPress()
    return Grab(work, press, hit)


def drag_cursor(work: Workspace, frame: Input) -> Overlay:
    """The gizmo, and the outline of the handle or the rim of the region that a press would take."""
    gizmo, part = gizmo_cursor(work, frame)
    if work.interaction is not None or frame.down or part is not None:
        return gizmo
    near = near_handle(work, frame, NEAR_HANDLE)
    if near is not None:
        border = work.regions.borders(work.document).of(near[0])
        return gizmo.over(Overlay((Outline(work.positions[border], HOVERED),)))
    hit = work.under(frame)
    if hit is None or work.document.role[hit.vertex] == FIXED:
        return gizmo
    return gizmo.over(brush_cursor(work, frame))
