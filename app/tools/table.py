"""The tools, as a table: what each does with a press, what it shows and what it can be told."""

from __future__ import annotations

from app.tools.press import begin_drag, drag_cursor
from app.tools.role_strokes import paint_fixed, paint_handle
from app.tools.softness_strokes import paint_softness
from app.tools.tool import Tool, brush_cursor

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
        begin_drag,
        drag_cursor,
        options=("turns by itself", "keep"),
        map="roles",
        keeps_heat=True,
        hint="Drag a handle or the surface, click to pin",
    ),
}
