"""What is drawn over the scene, as data: lines of constant width, filled shapes, words."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from app.viewpoint.camera import Pixel
from solver.types import FloatArray

Color = tuple[int, int, int]  # RGB, 0 to 255

PAINTING, ERASING, HOVERED = (255, 255, 255), (255, 90, 70), (255, 255, 255)


@dataclass(frozen=True, eq=False)
class Outline:
    """Lines over the scene, seen through whatever is before them. segments: (k, 2, 3) their ends.

    They show where a tool acts: the rim of the brush, the loop of a selection.
    width: in pixels.  opacity: 1 hides what is below.
    """

    segments: FloatArray
    color: Color
    width: float = 2.0
    opacity: float = 1.0

    @staticmethod
    def through(corners: FloatArray, color: Color, closed: bool = True) -> Outline:
        """A line through corners (k, 3). closed: the last meets the first."""
        ends = np.roll(corners, -1, axis=0)
        segments = np.stack([corners, ends], axis=1)
        return Outline(segments if closed else segments[:-1], color)


@dataclass(frozen=True, eq=False)
class Fill:
    """A filled convex shape over the scene. corners: (k, 3), in their order around it."""

    corners: FloatArray
    color: Color


@dataclass(frozen=True)
class Label:
    """Words beside a pixel."""

    text: str
    pixel: Pixel


@dataclass(frozen=True, eq=False)
class Overlay:
    """Everything over the scene at one moment."""

    outlines: tuple[Outline, ...] = ()
    labels: tuple[Label, ...] = ()
    fills: tuple[Fill, ...] = ()

    def over(self, other: Overlay) -> Overlay:
        """This one and another, which lies below it."""
        return Overlay(
            other.outlines + self.outlines, other.labels + self.labels, other.fills + self.fills
        )


NOTHING = Overlay()
