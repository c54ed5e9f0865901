"""The regions painted so far, and the handles by name."""

from __future__ import annotations

import polyscope.imgui as psim

from app.editor import commands as c
from app.editor.editor import Editor
from app.model.handles import Handle
from app.window.panel.widgets import BUTTON_COLUMN, REST_OF_LINE, disabled, swatch
from app.workspace.color_maps import (
    ACTIVE_COLOR,
    FIXED_COLOR,
    OTHER_COLOR,
    SELECTED_COLOR,
    SOFT_COLOR,
)
from solver.types import FloatArray


def regions(editor: Editor, asked: list[c.Command]) -> None:
    """Fixed, soft, and a row for each handle."""
    document = editor.document
    psim.SeparatorText("Regions")
    _row("fixed", FIXED_COLOR, len(document.fixed), c.ClearFixed(), asked)
    soft = int((document.softness > 0).sum())
    _row("soft", SOFT_COLOR, soft, c.ClearSoftness(), asked)
    for handle in document.handles:
        psim.PushID(str(handle.key))
        selected = handle in editor.selected
        swatch(_color(editor, handle))
        if psim.RadioButton("##active", selected):
            choose = c.SelectHandle if psim.GetIO().KeyCtrl else c.ActivateHandle
            asked.append(choose(handle.key))
        psim.SetItemTooltip("Paint and drag this handle; Ctrl+click to move several together")
        psim.SameLine()
        psim.SetNextItemWidth(110.0)
        _, name = psim.InputText("##name", handle.name)
        if name.strip() and name != handle.name:
            asked.append(c.RenameHandle(handle.key, name))
        psim.SameLine()
        psim.Text(f"{len(document.vertices_of(handle.key)):,}")
        psim.SameLine(BUTTON_COLUMN)
        if psim.Button("remove", REST_OF_LINE):
            asked.append(c.RemoveHandle(handle.key))
        psim.PopID()


def _color(editor: Editor, handle: Handle) -> FloatArray:
    if handle == editor.active:
        return ACTIVE_COLOR
    return SELECTED_COLOR if handle in editor.selected else OTHER_COLOR


def _row(
    label: str,
    color: FloatArray,
    count: int,
    clear: c.Command,
    asked: list[c.Command],
) -> None:
    swatch(color)
    psim.Text(f"{label}  {count:,}")
    psim.SameLine(BUTTON_COLUMN)
    with disabled(count == 0):
        if psim.Button(f"clear##{label}", REST_OF_LINE):
            asked.append(clear)
