"""What a tool can be told: OPTIONS is the table that a tool's row names its options from."""

from __future__ import annotations

from collections.abc import Callable

import polyscope.imgui as psim

from app.editor import commands as c
from app.editor.editor import Editor
from app.tools.marking_shapes import SHAPES
from app.tools.softness_strokes import SOFTNESS_MODES
from app.window.panel.place import PlaceRows
from app.window.panel.widgets import REST_OF_LINE, disabled, halves, logarithmic
from app.window.scaling import scaled
from app.workspace.placing import AXES, PIVOTS

PICK_WIDTH = 44.0
NAMED = {"point": "picked point", "free": "place follows"}
TIPS = {
    "axes": "What the gizmo's axes are: the world's, the handle's own, or those of the view",
    "pivot": "What a handle turns about: its centre, its border to what is free, a point; "
    "or it turns, and the surface takes it along",
}
BRUSH_RADII = 0.005, 0.3
RADIUS_WIDTH = 140.0
CHANGE_BUTTONS = (
    ("+", "grow", "Grow what is marked by a ring of edges (Ctrl+Keypad +)"),
    ("-", "shrink", "Shrink it by a ring of edges (Ctrl+Keypad -)"),
    ("border", "smooth", "Smooth the border, and keep the area"),
    ("invert", "invert", "Mark what is free instead (Ctrl+I)"),
    ("all else", "everything else", "Mark everything that is still free"),
    ("clear", "clear", "Mark nothing"),
)


def marking(editor: Editor, asked: list[c.Command]) -> None:
    """What a press marks with, and whether a loop takes what is hidden."""
    chosen = editor.marking
    for number, (name, shape) in enumerate(SHAPES.items()):
        if number:
            psim.SameLine()
        if psim.RadioButton(name, chosen.shape == name):
            asked.append(c.SetMarking(shape=name))
            if name == "limb":
                asked.append(c.FindLimbs())
        psim.SetItemTooltip(shape.tip)
    if not SHAPES[chosen.shape].loops:
        return
    for number, (label, through) in enumerate((("visible only", False), ("through", True))):
        if number:
            psim.SameLine()
        if psim.RadioButton(label, chosen.through == through):
            asked.append(c.SetMarking(through=through))
    psim.SetItemTooltip("Also what lies behind the surface that is seen")


def brush_radius(editor: Editor, asked: list[c.Command]) -> None:
    """A slider, in diagonals of the mesh or heights of the window, where a brush is in the hand."""
    if editor.marking.shape != "brush":
        return
    psim.SetNextItemWidth(scaled(RADIUS_WIDTH))
    moved, radius = logarithmic("##radius", editor.brush.radius, *BRUSH_RADII, "radius %.3f")
    psim.SetItemTooltip("Of the brush: Ctrl+wheel, or the keys [ and ]")
    if moved:
        asked.append(c.SetBrush(radius=radius))
    psim.SameLine()
    changed, on_screen = psim.Checkbox("same on screen", editor.brush.on_screen)
    psim.SetItemTooltip("The brush keeps its size on screen when the camera comes closer")
    if changed:
        asked.append(c.SetBrush(on_screen=on_screen))


def change_marks(editor: Editor, asked: list[c.Command]) -> None:
    """A line of buttons that change what is marked, without a stroke."""
    for number, (label, name, tip) in enumerate(CHANGE_BUTTONS):
        if number:
            psim.SameLine()
        if psim.SmallButton(label):
            asked.append(c.ChangeMarks(name))
        psim.SetItemTooltip(tip)


def new_handle(editor: Editor, asked: list[c.Command]) -> None:
    """A button."""
    if psim.Button("New handle"):
        asked.append(c.AddHandle())
    psim.SetItemTooltip("Strokes from now on paint another handle")


def softness_brush(editor: Editor, asked: list[c.Command]) -> None:
    """What a stroke does, to what value and how strongly."""
    brush = editor.brush
    for number, mode in enumerate(SOFTNESS_MODES):
        if number:
            psim.SameLine()
        if psim.RadioButton(mode, brush.mode == mode):
            asked.append(c.SetBrush(mode=mode))
    for label in halves("value", "strength"):
        with disabled(label == "value" and brush.mode == "smooth"):
            moved, share = psim.SliderFloat(
                f"##{label}", getattr(brush, label), 0.0, 1.0, f"{label} %.2f"
            )
        if moved:
            asked.append(c.SetBrush(**{label: share}))


def whole_softness(editor: Editor, asked: list[c.Command]) -> None:
    """What is done to the field at once, without a stroke."""
    pinned = bool(editor.document.pinned.any())
    for label, command, usable, tip in (
        ("Fill", c.FillSoftness(), pinned, "Keep what is pinned (dots), blend everything between"),
        ("Smooth all", c.SmoothSoftness(), True, "Even out the whole field"),
        ("Clear pins", c.ClearPins(), pinned, "Pin nothing; the softness stays"),
    ):
        with disabled(not usable):
            if psim.Button(label):
                asked.append(command)
        psim.SetItemTooltip(tip)
        psim.SameLine()
    psim.NewLine()


def turns_by_itself(editor: Editor, asked: list[c.Command]) -> None:
    """Whether a dragged handle takes its best rotation."""
    changed, turn = psim.Checkbox("turns by itself", editor.turn)
    psim.SetItemTooltip("A dragged handle takes the rotation of least energy")
    if changed:
        asked.append(c.SetTurn(turn))


def keep(editor: Editor, asked: list[c.Command]) -> None:
    """Whether a grab of the bare surface leaves a pin."""
    psim.SameLine()
    changed, on = psim.Checkbox("keep", editor.keep)
    psim.SetItemTooltip(
        "What is grabbed of the bare surface stays, as a pin, instead of being let go of (K)"
    )
    if changed:
        asked.append(c.SetKeep(on))


def gizmo(editor: Editor, asked: list[c.Command]) -> None:
    """Whether it shows, its axes, and what handles turn about; on the line of another switch."""
    placing = editor.placing
    psim.SameLine()
    changed, on = psim.Checkbox("gizmo", placing.gizmo)
    psim.SetItemTooltip("Rings turn, arrows move, the circle turns freely. Ctrl: round values")
    if changed:
        asked.append(c.SetPlacing(gizmo=on))
    room = psim.GetContentRegionAvail()[0] - scaled(PICK_WIDTH) - 2 * psim.GetStyle().ItemSpacing[0]
    for field, names in (("axes", AXES), ("pivot", PIVOTS)):
        psim.SetNextItemWidth(0.5 * room)
        labels = [NAMED.get(name, f"{name} {field}") for name in names]
        changed, index = psim.Combo(f"##{field}", names.index(getattr(placing, field)), labels)
        psim.SetItemTooltip(TIPS[field])
        if changed:
            name = names[index]
            asked.append(c.SetPlacing(axes=name) if names is AXES else c.SetPlacing(pivot=name))
        psim.SameLine()
    if psim.Button("pick", REST_OF_LINE):
        asked.append(c.PickPivot())
    psim.SetItemTooltip("Turn about the point of the surface that is clicked next")


OPTIONS: dict[str, Callable[[Editor, list[c.Command]], None]] = {
    "marking": marking,
    "brush radius": brush_radius,
    "change marks": change_marks,
    "new handle": new_handle,
    "softness brush": softness_brush,
    "whole softness": whole_softness,
    "turns by itself": turns_by_itself,
    "keep": keep,
    "gizmo": gizmo,
    "place": PlaceRows(),
}
