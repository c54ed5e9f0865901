"""The tools, as a table: what each does with a press, what it shows and what it can be told."""

from __future__ import annotations

from app.model.handles import FIRST_HANDLE, FIXED
from app.model.history import Gesture
from app.tools.drag import Drag
from app.tools.softness_strokes import SOFTNESS_MODES, SoftnessEraser
from app.tools.strokes import HandlePaint, Paint, RoleEraser, RolePaint, Stroke
from app.tools.tool import Tool, brush_rim, on_surface
from app.workspace.events import Input
from app.workspace.picking import Hit
from app.workspace.workspace import Interaction, Workspace


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
    handle = document.find(int(document.role[hit.vertex]))
    if handle is None:
        return None
    work.activate(handle.key)
    return Drag(work, press, hit, handle)


TOOLS = {
    "navigate": Tool("Navigate", "1"),
    "fixed": Tool(
        "Fixed", "2", on_surface(_fixed), brush_rim, options=("brush radius",), map="roles"
    ),
    "handle": Tool(
        "Handle",
        "3",
        on_surface(_handle),
        brush_rim,
        options=("brush radius", "new handle"),
        map="roles",
    ),
    "softness": Tool(
        "Softness",
        "4",
        on_surface(_softness),
        brush_rim,
        options=("brush radius", "softness brush", "whole softness"),
        map="softness",
    ),
    "drag": Tool(
        "Drag",
        "5",
        on_surface(_drag),
        options=("turns by itself",),
        map="roles",
        keeps_heat=True,
        hint="Press on a handle and drag",
    ),
}
