"""The tools, as a table: what each does with a press, what it shows and what it can be told."""

from __future__ import annotations

from app.tools.gizmo.begin import begin_gizmo
from app.tools.marking_shapes import begin_marking, marking_cursor
from app.tools.press import begin_drag, drag_cursor
from app.tools.role_strokes import FIXED_MARKS, HANDLE_MARKS
from app.tools.select_handle import begin_select
from app.tools.softness_strokes import SOFTNESS_MARKS
from app.tools.tool import Tool, first_of

TOOLS = {
    "navigate": Tool("Navigate", "1"),
    "fixed": Tool(
        "Fixed",
        "2",
        begin_marking(FIXED_MARKS),
        marking_cursor,
        FIXED_MARKS,
        options=("marking", "brush radius", "change marks"),
        map="roles",
    ),
    "handle": Tool(
        "Handle",
        "3",
        begin_marking(HANDLE_MARKS),
        marking_cursor,
        HANDLE_MARKS,
        options=("marking", "brush radius", "change marks", "new handle"),
        map="roles",
    ),
    "softness": Tool(
        "Softness",
        "4",
        begin_marking(SOFTNESS_MARKS),
        marking_cursor,
        SOFTNESS_MARKS,
        options=("marking", "brush radius", "softness brush", "change marks", "whole softness"),
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
