"""The settings: material, bending length, pose."""

from __future__ import annotations

import polyscope.imgui as psim

from app.editor import commands as c
from app.editor.editor import Editor
from app.model.settings import LARGE, LEVELS
from app.telling import readable
from app.window.panel.poses import rest_menu
from app.window.panel.widgets import (
    BUSY_COLOR,
    BUTTON_COLUMN,
    REST_OF_LINE,
    button_column,
    disabled,
    halves,
    logarithmic,
)
from app.window.scaling import scaled
from app.window.shortcuts import WindowAction
from solver.softness.material import PRESETS, Material, resolve_material

SMALLEST_GAIN, LARGEST_GAIN = 0.01, 10.0
SHORTEST_BEND, LONGEST_BEND = 1e-3, 0.3
HIGHEST_RIGID = 10
SHAPE_TIP = (
    "linear: quickest, shrinks in large turns\n"
    "keeps lengths: one step of rotations, good for moderate bends\n"
    "best shape: rounds until it has settled"
)


def softness_warnings(editor: Editor, asked: list[c.Command]) -> None:
    """What is wrong with the softness; a click shows where, a button mends that place."""
    for number, warning in enumerate(editor.warnings):
        psim.PushID(number)
        psim.PushTextWrapPos(scaled(BUTTON_COLUMN - 8.0))
        psim.TextColored(BUSY_COLOR, warning.text)
        psim.PopTextWrapPos()
        psim.SetItemTooltip("Click to see where")
        if psim.IsItemClicked():
            asked.append(c.FrameVertices(tuple(warning.vertices.tolist())))
        button_column()
        if psim.Button("Smooth", REST_OF_LINE):
            asked.append(c.SmoothSoftness(tuple(warning.vertices.tolist())))
        psim.SetItemTooltip("Even the softness out there, and nowhere else")
        psim.PopID()


def soft_parts(editor: Editor, asked: list[c.Command]) -> None:
    """Preset, gains, bending length and orientation."""
    document = editor.document
    names = [*PRESETS, "custom"]
    material = document.material
    chosen = names.index("custom" if isinstance(material, Material) else material)
    changed, index = psim.Combo("material", chosen, names)
    psim.SetItemTooltip("What fully soft parts are like; rigid ones are the same in all")
    gains = resolve_material(material)
    if changed:
        asked.append(c.SetMaterial(gains if names[index] == "custom" else names[index]))
    if psim.Button("Learn from a pose ..."):
        asked.append(WindowAction("learn"))
    psim.SetItemTooltip("Find the softness with which the mesh takes a shape that another file has")
    if not psim.TreeNode("gains, bending length, rounds"):
        return
    for label in halves("bending", "stretching"):
        moved, gain = logarithmic(
            f"##{label}", getattr(gains, label), SMALLEST_GAIN, LARGEST_GAIN, f"{label} %.3g"
        )
        psim.SetItemTooltip(f"How much of the {label} stiffness is left where all is soft")
        if moved:
            asked.append(c.SetMaterial(Material(**{**vars(gains), label: gain})))
    moved, length = logarithmic("bend length", document.bending_length, SHORTEST_BEND, LONGEST_BEND)
    psim.SetItemTooltip("How far a bend spreads, in diagonals of the mesh")
    if moved:
        asked.append(c.SetSetting("bending_length", length))
    moved, rigid = psim.SliderInt("rounds", document.rigid, 0, HIGHEST_RIGID)
    psim.SetItemTooltip("0 is linear, 1 keeps lengths, 4 is the best shape; more change little")
    if moved:
        asked.append(c.SetSetting("rigid", rigid))
    changed, on = psim.Checkbox("handles hold orientation", document.orientation)
    psim.SetItemTooltip("Handles and fixed parts hold the slope of the surface at their border too")
    if changed:
        asked.append(c.SetSetting("orientation", on))
    psim.TreePop()


def pose(editor: Editor, asked: list[c.Command]) -> None:
    """What shape, reset, undo and redo, the rest shape."""
    document = editor.document
    names, levels = list(LEVELS), list(LEVELS.values())
    if document.rigid not in levels:
        names, levels = [*names, f"{document.rigid} rounds"], [*levels, document.rigid]
    changed, index = psim.Combo("shape", levels.index(document.rigid), names)
    psim.SetItemTooltip(SHAPE_TIP)
    if changed:
        asked.append(c.SetSetting("rigid", levels[index]))
    if len(document.role) > LARGE:
        psim.SameLine()
        changed, exact = psim.Checkbox("exact", document.coarse_count is None)
        psim.SetItemTooltip("Frames on every triangle: slower, hardly better")
        if changed:
            asked.append(c.SetSetting("coarse", not exact))
    if psim.Button("Reset pose"):
        asked.append(c.ResetPose())
    psim.SetItemTooltip("Every handle back to rest (Ctrl+R)")
    psim.SameLine()
    for label, command, entries in (
        ("Undo", c.Undo(), editor.history.done),
        ("Redo", c.Redo(), editor.history.undone),
    ):
        with disabled(not entries):
            if psim.Button(label):
                asked.append(command)
            if entries:
                psim.SetItemTooltip(readable(entries[-1].label))
        psim.SameLine()
    rest_menu(editor, asked)
