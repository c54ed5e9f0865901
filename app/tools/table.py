"""The tools, as a table: what each does with a press, what it shows and what it can be told."""

from __future__ import annotations

from app.tools.gizmo.begin import begin_gizmo
from app.tools.press import begin_drag, drag_cursor
from app.tools.role_strokes import paint_fixed, paint_handle
from app.tools.select_handle import begin_select
from app.tools.softness_strokes import paint_softness
from app.tools.tool import Tool, brush_cursor, first_of

TOOLS = {
    "navigate": Tool("Navigate", "1"),
    "fixed": Tool("Fixed", "2", paint_fixed, brush_cursor, options=("brush radius",), map="roles"),
    "handle": Tool(
        "Handle",
        "3",
        paint_handle,
        brush_cursor,
        options=("brush radius", "new handle"),
        map="roles",
    ),
    "softness": Tool(
        "Softness",
        "4",
        paint_softness,
        brush_cursor,
        options=("brush radius", "softness brush", "whole softness"),
        map="softness",
    ),
    "drag": Tool(
        "Drag",
        "5",
        first_of(begin_gizmo, begin_select, begin_drag),
        drag_cursor,
        options=("turns by itself", "keep", "gizmo", "place"),
        map="roles",
        keeps_heat=True,
        hint="Drag a handle or the surface, click to pin",
    ),
}
