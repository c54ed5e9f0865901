"""Draws an Overlay over the scene, on ImGui's list of what lies behind the panel."""

from __future__ import annotations

import numpy as np
import polyscope.imgui as psim

from app.viewpoint.camera import Camera
from app.window.scaling import scaled
from app.workspace.overlay import Label, Outline, Overlay

# A line is bright on a wider dark one, so that it is seen on every colour.
DARK, DARK_WIDTH, BRIGHT_WIDTH = (30, 30, 40, 200), 4.0, 2.0
BESIDE = (16.0, 12.0)  # pixels from what a label is beside
MARGIN = 5.0


def draw_overlay(overlay: Overlay, camera: Camera) -> None:
    """Once a frame."""
    for outline in overlay.outlines:
        _lines(outline, camera)
    for label in overlay.labels:
        _label(label)


def _lines(outline: Outline, camera: Camera) -> None:
    """What is behind the camera is left out."""
    pixels = camera.project(outline.segments.reshape(-1, 3)).reshape(-1, 2, 2)
    ends = pixels[np.isfinite(pixels).all(axis=(1, 2))].tolist()
    draw = psim.GetBackgroundDrawList()
    for color, width in ((DARK, DARK_WIDTH), ((*outline.color, 255), BRIGHT_WIDTH)):
        packed = psim.IM_COL32(*color)
        for start, end in ends:
            draw.AddLine(start, end, packed, scaled(width))


def _label(label: Label) -> None:
    x, y = label.pixel[0] + scaled(BESIDE[0]), label.pixel[1] + scaled(BESIDE[1])
    width, height = psim.CalcTextSize(label.text)
    draw = psim.GetBackgroundDrawList()
    margin = scaled(MARGIN)
    low, high = (x - margin, y - margin), (x + width + margin, y + height + margin)
    draw.AddRectFilled(low, high, psim.IM_COL32(*DARK), margin)
    draw.AddText((x, y), psim.IM_COL32(240, 240, 245, 255), label.text)
