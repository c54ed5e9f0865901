"""How the scene is looked at: shading, pictures of it, and how large the interface is drawn."""

from __future__ import annotations

import polyscope.imgui as psim

from app.editor import commands as c
from app.editor.editor import Editor
from app.model.preferences import PreferencesFile
from app.scene.looks import SHADINGS
from app.viewpoint.viewpoint import SIDES, UPS
from app.window.panel.widgets import CHOSEN_COLOR, halves, shares
from app.window.shortcuts import SetInterface, WindowAction
from app.window.studio import Studio

SWITCHES = (
    ("edges", "edges", "Draw the edges of the polygons"),
    ("rest", "rest shape", "See the rest shape through the surface"),
    ("beside", "beside", "See the rest shape beside the surface: before and after"),
)
SMOOTH, FLAT, FILE = SHADINGS
SHADING_TIPS = {
    SMOOTH: "Shade over all edges",
    FLAT: "Shade each polygon flat",
    FILE: "Smooth but for the hard edges that the file has",
}
PICTURES = (
    ("Picture", "picture", "Save what is seen as a PNG beside the mesh"),
    ("Turntable", "turntable", "Save one turn around it as a GIF beside the mesh"),
    ("Record", "record", "Save what happens from now on as a GIF beside the mesh"),
)
SCALES = (None, 0.75, 1.0, 1.25, 1.5, 1.75, 2.0, 2.5, 3.0)


class LookingRows:
    """The rows, which know what pictures are being taken and what a person prefers."""

    def __init__(self, studio: Studio, preferences: PreferencesFile) -> None:
        self._studio = studio
        self._preferences = preferences

    def draw(self, editor: Editor, asked: list[c.Command]) -> None:
        """What was pressed goes into `asked`."""
        for number, (name, label, tip) in enumerate(SWITCHES):
            if number:
                psim.SameLine()
            changed, on = psim.Checkbox(label, getattr(editor.looks, name))
            psim.SetItemTooltip(tip)
            if changed:
                asked.append(c.SetLooks(**{name: on}))
        _shading(editor, asked)
        for (label, name, tip), (_, size) in zip(
            PICTURES, shares(*(row[0] for row in PICTURES)), strict=True
        ):
            running = name == "record" and self._studio.recording is not None
            if running:
                label, tip = f"Stop {self._studio.recording:.0f} s###Record", "Save the recording"
                psim.PushStyleColor(psim.ImGuiCol_Button, CHOSEN_COLOR)
            if psim.Button(label, size):
                asked.append(WindowAction(name))
            if running:
                psim.PopStyleColor(1)
            psim.SetItemTooltip(tip)
        _camera(editor, asked)
        self._interface(asked)

    def _interface(self, asked: list[c.Command]) -> None:
        scale = self._preferences.values.interface_scale
        scales = SCALES if scale in SCALES else (*SCALES, scale)
        labels = [f"{100 * s:.0f} %" if s is not None else "as the screen" for s in scales]
        changed, index = psim.Combo("interface size", scales.index(scale), labels)
        if changed:
            asked.append(SetInterface(scales[index]))


def _shading(editor: Editor, asked: list[c.Command]) -> None:
    """One of the ways that there are for this mesh."""
    hard = editor.document.mesh.smooth_corners is not None
    chosen = editor.looks.shading if hard or editor.looks.shading != FILE else SMOOTH
    for name in SHADINGS if hard else (SMOOTH, FLAT):
        if name != SMOOTH:
            psim.SameLine()
        if psim.RadioButton("as in the file" if name == FILE else name, chosen == name):
            asked.append(c.SetLooks(shading=name))
        psim.SetItemTooltip(SHADING_TIPS[name])


def _camera(editor: Editor, asked: list[c.Command]) -> None:
    """From which side, and which axis is upright."""
    for label in halves("##side", "##up"):
        if label == "##side":
            if psim.BeginCombo(label, "view from ..."):
                for side in SIDES:
                    if psim.Selectable(side):
                        asked.append(c.ViewFrom(side))
                psim.EndCombo()
            continue
        names = list(UPS)
        at = names.index(editor.viewpoint.up_name)
        changed, index = psim.Combo(label, at, [f"{name} is up" for name in names])
        if changed:
            asked.append(c.SetUp(names[index]))
