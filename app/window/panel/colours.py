"""Which map the surface is coloured by, and what its colours mean."""

from __future__ import annotations

import numpy as np
import polyscope.imgui as psim

from app.editor import commands as c
from app.editor.editor import Editor
from app.window.scaling import scaled
from app.workspace.color_maps import MAPS, Scale

BAR_WIDTH, BAR_STEPS = 84.0, 42


def colours(editor: Editor, asked: list[c.Command]) -> None:
    """The map, its legend and rms."""
    names = list(MAPS)
    labels = [MAPS[name].label for name in names]
    psim.SetNextItemWidth(-1.0)
    changed, index = psim.Combo("##map", names.index(editor.map), labels)
    if changed:
        asked.append(c.SetMap(names[index]))
    shown = MAPS[editor.map]
    if shown.scale is not None:
        _legend(shown.scale)
        if shown.measure is not None:
            psim.SameLine()
            psim.Text(f"rms {shown.scale.text(editor.heat.rms, '.1f')}")
            psim.SetItemTooltip("Over the part that can move, against the rest shape")


def _legend(scale: Scale) -> None:
    """The lowest value, the colours in between, the highest value."""
    psim.Text(scale.text(scale.low))
    psim.SameLine()
    x, y = psim.GetCursorScreenPos()
    width, height = scaled(BAR_WIDTH), psim.GetTextLineHeight()
    step = width / BAR_STEPS
    values = np.linspace(scale.low, scale.high, BAR_STEPS)
    draw = psim.GetWindowDrawList()
    for number, rgb in enumerate((255 * scale(values)).astype(int)):
        left = x + number * step
        corner = left + step, y + height
        draw.AddRectFilled((left, y + 2.0), corner, psim.IM_COL32(*map(int, rgb), 255))
    psim.Dummy((width, height))
    psim.SameLine()
    psim.Text(scale.text(scale.high))
