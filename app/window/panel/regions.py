"""The regions painted so far, and the handles by name."""

from __future__ import annotations

import polyscope.imgui as psim

from app.editor import commands as c
from app.editor.editor import Editor
from app.window.panel.widgets import (
    BUTTON_COLUMN,
    REST_OF_LINE,
    button_column,
    disabled,
    swatch,
    text_field,
    text_until,
)
from app.window.scaling import scaled
from app.workspace.color_maps import FIXED_COLOR, SOFT_COLOR, handle_color
from solver.types import FloatArray


def regions(editor: Editor, asked: list[c.Command]) -> None:
    """Fixed, soft, and a row for each handle."""
    document = editor.document
    _row("fixed", FIXED_COLOR, len(document.fixed), c.ClearFixed(), asked)
    soft = int((document.softness > 0).sum())
    _row("soft", SOFT_COLOR, soft, c.ClearSoftness(), asked)
    for handle in document.handles:
        psim.PushID(str(handle.key))
        swatch(handle_color(handle.key))
        if psim.RadioButton("##active", handle in editor.selected):
            choose = c.SelectHandle if psim.GetIO().KeyCtrl else c.ActivateHandle
            asked.append(choose(handle.key))
        psim.SetItemTooltip("Paint and drag this handle; Ctrl+click to move several together")
        psim.SameLine()
        count = f"{len(document.vertices_of(handle.key)):,}"
        psim.SetNextItemWidth(_room_before(count))
        _, name = text_field("##name", handle.name)
        if name.strip() and name != handle.name:
            asked.append(c.RenameHandle(handle.key, name))
        psim.SameLine()
        psim.Text(count)
        button_column()
        if psim.Button("remove", REST_OF_LINE):
            asked.append(c.RemoveHandle(handle.key))
        psim.PopID()


def _row(
    label: str,
    color: FloatArray,
    count: int,
    clear: c.Command,
    asked: list[c.Command],
) -> None:
    swatch(color)
    text_until(BUTTON_COLUMN, f"{label}  {count:,}")
    button_column()
    with disabled(count == 0):
        if psim.Button(f"clear##{label}", REST_OF_LINE):
            asked.append(clear)


def _room_before(text: str) -> float:
    """Pixels for a field that is followed by a text and then a button."""
    gaps = 2 * psim.GetStyle().ItemSpacing[0]
    return scaled(BUTTON_COLUMN) - psim.GetCursorPosX() - psim.CalcTextSize(text)[0] - gaps
