"""The tools, as a table: what pressing on the surface begins with each of them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from app.model.document import FIRST_HANDLE, FIXED
from app.model.history import Gesture
from app.tools.drag import Drag
from app.tools.softness_strokes import SOFTNESS_MODES, SoftnessEraser
from app.tools.strokes import HandlePaint, Paint, RoleEraser, RolePaint, Stroke
from app.workspace.events import Input
from app.workspace.picking import Hit
from app.workspace.workspace import Interaction, Workspace

Begin = Callable[[Workspace, Input, Hit], Interaction | None]


@dataclass(frozen=True)
class Tool:
    """key: on the keyboard. paints: shows the brush.

    begin: what a press on the surface starts; None leaves the press to the camera.
    map: the one of color_maps.MAPS that shows what the tool does, None to leave it as it is.
    """

    label: str
    key: str
    begin: Begin | None = None
    paints: bool = False
    map: str | None = None


def _fixed(work: Workspace, press: Input, hit: Hit) -> Interaction:
    paint: Paint = RolePaint("Paint fixed", FIXED)
    if press.shift:
        paint = RoleEraser(work.document, "Erase fixed", lambda role: role == FIXED)
    return Stroke(work, press, hit, Gesture(work.document), paint)


def _handle(work: Workspace, press: Input, hit: Hit) -> Interaction:
    gesture = Gesture(work.document)
    if press.shift:
        eraser = RoleEraser(work.document, "Erase handle", lambda role: role >= FIRST_HANDLE)
        return Stroke(work, press, hit, gesture, eraser)
    handle = work.active
    if handle is None:
        handle = work.document.new_handle()
        gesture.change("handles", (*work.document.handles, handle))
    work.activate(handle.key)
    return Stroke(work, press, hit, gesture, HandlePaint(work, handle.key))


def _softness(work: Workspace, press: Input, hit: Hit) -> Interaction:
    paint = SoftnessEraser(work) if press.shift else SOFTNESS_MODES[work.brush.mode](work)
    return Stroke(work, press, hit, Gesture(work.document), paint)


def _drag(work: Workspace, press: Input, hit: Hit) -> Interaction | None:
    document = work.document
    handle = document.handle_of_role(int(document.role[hit.vertex]))
    if handle is None:
        return None
    work.activate(handle.key)
    return Drag(work, press, hit, handle)


TOOLS = {
    "navigate": Tool("Navigate", "1"),
    "fixed": Tool("Fixed", "2", _fixed, paints=True, map="roles"),
    "handle": Tool("Handle", "3", _handle, paints=True, map="roles"),
    "softness": Tool("Softness", "4", _softness, paints=True, map="softness"),
    "drag": Tool("Drag", "5", _drag, map="roles"),
}
