"""The settings: material, bending length, pose."""

from __future__ import annotations

import polyscope.imgui as psim

from app.editor import commands as c
from app.editor.editor import Editor
from app.model.settings import LARGE
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
from solver.softness.material import PRESETS, Material, resolve_material

SMALLEST_GAIN, LARGEST_GAIN = 0.01, 10.0
SHORTEST_BEND, LONGEST_BEND = 1e-3, 0.3
HIGHEST_RIGID = 10


def softness_warnings(editor: Editor, asked: list[c.Command]) -> None:
    """What is wrong with the softness, and a button that mends most of it."""
    warnings = editor.warnings
    psim.PushTextWrapPos(scaled(BUTTON_COLUMN - 8.0))
    for warning in warnings:
        psim.TextColored(BUSY_COLOR, warning)
    psim.PopTextWrapPos()
    if warnings:
        button_column()
        if psim.Button("Smooth", REST_OF_LINE):
            asked.append(c.SmoothSoftness())


def soft_parts(editor: Editor, asked: list[c.Command]) -> None:
    """Preset, gains, bending length and orientation."""
    document = editor.document
    names = [*PRESETS, "custom"]
    material = document.material
    chosen = names.index("custom" if isinstance(material, Material) else material)
    changed, index = psim.Combo("material", chosen, names)
    gains = resolve_material(material)
    if changed:
        asked.append(c.SetMaterial(gains if names[index] == "custom" else names[index]))
    if not psim.TreeNode("gains, bending length, orientation"):
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
    changed, on = psim.Checkbox("handles hold orientation", document.orientation)
    if changed:
        asked.append(c.SetSetting("orientation", on))
    psim.TreePop()


def pose(editor: Editor, asked: list[c.Command]) -> None:
    """Rigid level, reset, undo and redo."""
    document = editor.document
    moved, rigid = psim.SliderInt("rigid", document.rigid, 0, HIGHEST_RIGID)
    psim.SetItemTooltip(
        "0: linear, shrinks in large turns. 1: keeps lengths. 4: best for large bends"
    )
    if moved:
        asked.append(c.SetSetting("rigid", rigid))
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
                psim.SetItemTooltip(entries[-1].label)
        psim.SameLine()
    psim.NewLine()
