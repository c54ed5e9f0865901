"""Draws an Overlay over the scene, on ImGui's list of what lies behind the panel."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import polyscope.imgui as psim

from app.scene.overlay import Fill, Label, Outline, Overlay
from app.viewpoint.camera import Camera, Pixel
from app.window.scaling import scaled
from solver.types import FloatArray

# A line is bright on a wider dark one, so that it is seen on every colour.
DARK, DARK_RIM = (30, 30, 40, 200), 2.0
BESIDE = (16.0, 12.0)  # pixels from what a label is beside
MARGIN = 5.0
Strip = list[Pixel]  # the corners of a line


class OverlayDrawer:
    """Draws overlays; where lines are on screen is found again where they or the camera differ."""

    def __init__(self) -> None:
        self._camera: Camera | None = None
        self._strips: dict[Outline, list[Strip]] = {}

    def draw(self, overlay: Overlay, camera: Camera) -> None:
        """Once a frame."""
        known = self._strips if camera is self._camera else {}
        self._strips = {
            outline: known[outline] if outline in known else _strips(outline, camera)
            for outline in overlay.outlines
        }
        self._camera = camera
        for outline, strips in self._strips.items():
            _lines(outline, strips)
        for fill in overlay.fills:
            _fill(fill, camera)
        for label in overlay.labels:
            _label(label)


def _strips(outline: Outline, camera: Camera) -> list[Strip]:
    """The segments as they are seen, those that go on from one to the next as one line.

    What is behind the camera is left out.
    """
    pixels = camera.project(outline.segments.reshape(-1, 3)).reshape(-1, 2, 2)
    pixels = pixels[np.isfinite(pixels).all(axis=(1, 2))]
    if not len(pixels):
        return []
    ends = np.flatnonzero((pixels[:-1, 1] != pixels[1:, 0]).any(axis=1)) + 1
    starts, last = pixels[:, 0].tolist(), pixels[:, 1].tolist()
    return [[*starts[i:j], last[j - 1]] for i, j in pairwise([0, *ends.tolist(), len(pixels)])]


def _lines(outline: Outline, strips: list[Strip]) -> None:
    draw = psim.GetBackgroundDrawList()
    rim = outline.width + DARK_RIM
    for color, width in ((DARK, rim), ((*outline.color, 255), outline.width)):
        packed = psim.IM_COL32(*color[:3], round(color[3] * outline.opacity))
        for strip in strips:
            closed = strip[0] == strip[-1]
            for pixel in strip[closed:]:
                draw.PathLineTo(pixel)
            draw.PathStroke(packed, psim.ImDrawFlags_Closed if closed else 0, scaled(width))


def _fill(fill: Fill, camera: Camera) -> None:
    """Nothing where some of it is behind the camera."""
    pixels = camera.project(fill.corners)
    if not np.isfinite(pixels).all():
        return
    draw, color = psim.GetBackgroundDrawList(), psim.IM_COL32(*fill.color, 255)
    for corner in _clockwise(pixels).tolist():
        draw.PathLineTo(corner)
    draw.PathFillConvex(color)


def _clockwise(corners: FloatArray) -> FloatArray:
    """The order around in which ImGui smooths the rim outwards."""
    x, y = (corners - corners[0]).T
    turns = (x[:-1] * y[1:] - x[1:] * y[:-1]).sum()
    return corners if turns > 0 else corners[::-1]


def _label(label: Label) -> None:
    x, y = label.pixel[0] + scaled(BESIDE[0]), label.pixel[1] + scaled(BESIDE[1])
    width, height = psim.CalcTextSize(label.text)
    draw = psim.GetBackgroundDrawList()
    margin = scaled(MARGIN)
    low, high = (x - margin, y - margin), (x + width + margin, y + height + margin)
    draw.AddRectFilled(low, high, psim.IM_COL32(*DARK), margin)
    draw.AddText((x, y), psim.IM_COL32(240, 240, 245, 255), label.text)
