"""Draws an Overlay over the scene, on ImGui's list of what lies behind the panel."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import polyscope.imgui as psim

from app.scene.overlay import Fill, Label, Outline, Overlay
from app.viewpoint.camera import Camera
from app.window.scaling import scaled

# A line is bright on a wider dark one, so that it is seen on every colour.
DARK, DARK_RIM = (30, 30, 40, 200), 2.0
BESIDE = (16.0, 12.0)  # pixels from what a label is beside
MARGIN = 5.0


def draw_overlay(overlay: Overlay, camera: Camera) -> None:
    """Once a frame."""
    for outline in overlay.outlines:
        _lines(outline, camera)
    for fill in overlay.fills:
        _fill(fill, camera)
    for label in overlay.labels:
        _label(label)


def _lines(outline: Outline, camera: Camera) -> None:
    """What is behind the camera is left out."""
    pixels = camera.project(outline.segments.reshape(-1, 3)).reshape(-1, 2, 2)
    ends = pixels[np.isfinite(pixels).all(axis=(1, 2))].tolist()
    draw = psim.GetBackgroundDrawList()
    rim = outline.width + DARK_RIM
    for color, width in ((DARK, rim), ((*outline.color, 255), outline.width)):
        packed = psim.IM_COL32(*color[:3], round(color[3] * outline.opacity))
        for start, end in ends:
            draw.AddLine(start, end, packed, scaled(width))


def _fill(fill: Fill, camera: Camera) -> None:
    """Nothing where some of it is behind the camera."""
    pixels = camera.project(fill.corners)
    if not np.isfinite(pixels).all():
        return
    first, *others = pixels.tolist()
    draw, color = psim.GetBackgroundDrawList(), psim.IM_COL32(*fill.color, 255)
    for second, third in pairwise(others):
        draw.AddTriangleFilled(first, second, third, color)


def _label(label: Label) -> None:
    x, y = label.pixel[0] + scaled(BESIDE[0]), label.pixel[1] + scaled(BESIDE[1])
    width, height = psim.CalcTextSize(label.text)
    draw = psim.GetBackgroundDrawList()
    margin = scaled(MARGIN)
    low, high = (x - margin, y - margin), (x + width + margin, y + height + margin)
    draw.AddRectFilled(low, high, psim.IM_COL32(*DARK), margin)
    draw.AddText((x, y), psim.IM_COL32(240, 240, 245, 255), label.text)
