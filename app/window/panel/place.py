"""Where the active handle is, as numbers that can be typed or dragged."""

from __future__ import annotations

import numpy as np
import polyscope.imgui as psim

from app.editor import commands as c
from app.editor.editor import Editor
from app.model.handles import rotation_of
from app.telling import readable
from app.window.panel.widgets import BUTTON_COLUMN, REST_OF_LINE, button_column
from app.window.scaling import scaled
from solver.geometry.motions import euler_angles

DEGREES_A_PIXEL = 0.5
PIXELS_A_DIAGONAL = 500.0
LARGE = 1e4  # of a diagonal: no room for decimals
EXACT = psim.ImGuiSliderFlags_NoRoundToFormat

Triple = tuple[float, float, float]


class PlaceRows:
    """Three numbers for the pivot's position, three for the rotation.

    While a field is in use the angles stay as they were given: a rotation has several sets of
    them, and near 90 degrees about y those that are computed would jump.
    """

    def __init__(self) -> None:
        self._angles: Triple | None = None

    def __call__(self, editor: Editor, asked: list[c.Command]) -> None:
        """Both rows and a button; nothing where there is no handle to place."""
        active, pivot = editor.active, editor.pivot
        if active is None or pivot is None:
            return
        self._position(editor.document.diagonal, (pivot[0], pivot[1], pivot[2]), asked)
        transform = editor.document.pose.of(active.key)
        x, y, z = euler_angles(rotation_of(transform)) + 0.0  # no minus before a zero
        self._rotation(self._angles or (x, y, z), asked)
        button_column()
        if psim.Button("reset", REST_OF_LINE):
            asked.append(c.ResetHandle(active.key))
        psim.SetItemTooltip(readable(f"{active.name} back to rest"))

    def _position(self, diagonal: float, now: Triple, asked: list[c.Command]) -> None:
        # As many decimals as tell thousandths of the mesh apart.
        decimals = int(np.clip(np.ceil(3 - np.log10(max(diagonal, 1e-30))), 0, 9))
        form = f"%.{decimals}f" if diagonal < LARGE else "%.4g"
        fields = _fields("m", now, diagonal / PIXELS_A_DIAGONAL, form)
        for axis, (value, changed, _) in enumerate(fields):
            if changed:
                asked.append(c.SetPosition(axis, value))
        psim.SetItemTooltip("Where the pivot is; drag, or Ctrl+click and type")
        psim.NewLine()

    def _rotation(self, now: Triple, asked: list[c.Command]) -> None:
        fields = _fields("r", now, DEGREES_A_PIXEL, "%.4g")
        angles = list(now)
        for axis, (value, changed, _) in enumerate(fields):
            if changed:
                angles[axis] = value
                asked.append(c.SetRotation(axis, (angles[0], angles[1], angles[2])))
        used = any(used for _, _, used in fields)
        self._angles = (angles[0], angles[1], angles[2]) if used else None
        psim.SetItemTooltip("Degrees about x, y and z; drag, or Ctrl+click and type")


def _fields(name: str, values: Triple, speed: float, form: str) -> list[tuple[float, bool, bool]]:
    """Each number as it is now, whether it was changed, and whether its field is in use."""
    found = []
    width = (scaled(BUTTON_COLUMN) - 4 * psim.GetStyle().ItemSpacing[0]) / 3
    for axis, value in zip("xyz", values, strict=True):
        psim.SetNextItemWidth(width)
        field = f"##{name}{axis}", value, speed, 0.0, 0.0, f"{axis} {form}", EXACT
        changed, new = psim.DragFloat(*field)
        # The widget's numbers have seven digits: what was typed is the shortest with these.
        found.append((float(f"{new:.7g}"), bool(changed), bool(psim.IsItemActive())))
        psim.SameLine()
    return found
