"""What the gizmo looks like, and which part of it is under the cursor."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from app.scene.overlay import Color, Fill, Outline, Overlay
from app.tools.gizmo.freedoms import Freedom, MoveAlong, TurnAbout, TurnFreely
from app.viewpoint.camera import Camera, Pixel
from solver.geometry.circles import circle
from solver.types import FloatArray

RADIUS = 80.0  # pixels, of the rings
# In radii. The middle is left to who presses on the handle itself.
MIDDLE, ARROW, HEAD, BALL = 0.42, 1.5, 0.2, 1.2
DOT = 3.0  # pixels, of the one that marks the pivot
REACH = 8.0  # pixels from a part at which it is under the cursor
CORNERS = 64
FAR = -0.2  # how far behind the pivot, in radii, a ring is still drawn as near
END_ON = 0.95  # cosine between view and axis above which an arrow does not show
FAINT, HALF, PLAIN, WIDE = 0.25, 0.5, 2.0, 4.0
X_COLOR, Y_COLOR, Z_COLOR = (235, 70, 75), (115, 200, 60), (70, 130, 255)
AXIS_COLORS = {"x": X_COLOR, "y": Y_COLOR, "z": Z_COLOR}
BALL_COLOR, HOVERED_BALL = (200, 200, 205), (255, 255, 255)
LINE_PIECES = 64  # of the line along an axis: those behind the camera are left out


@dataclass(frozen=True, eq=False)
class Part:
    """One thing to press on. near: (k, 2, 3) lines that can be pressed.  far: those hidden behind.

    rank: of two under the cursor the lower one is meant.  head: (3, 3) the corners of an arrow's.
    """

    freedom: Freedom
    rank: int
    near: FloatArray
    far: FloatArray
    head: FloatArray | None = None

    def color(self, hovered: bool) -> Color:
        """As it is drawn."""
        return axis_color(self.freedom, hovered)


def axis_color(freedom: Freedom, bright: bool = False) -> Color:
    """x red, y green, z blue, anything else grey."""
    base = AXIS_COLORS.get(freedom.name)
    if base is None:
        return HOVERED_BALL if bright else BALL_COLOR
    red, green, blue = ((c + 255) // 2 + 20 if bright else c for c in base)
    return min(red, 255), min(green, 255), min(blue, 255)


class Gizmo:
    """At a pivot (3,), along axes (3, 3) rows x, y, z, of constant size as a camera sees it."""

    def __init__(self, pivot: FloatArray, axes: FloatArray, camera: Camera) -> None:
        self._pivot, self._camera = pivot, camera
        self._size = RADIUS * camera.units_per_pixel(pivot)
        self._towards = (camera.position - pivot) / np.linalg.norm(camera.position - pivot)
        named = list(zip("xyz", axes, strict=True))
        self.parts: tuple[Part, ...] = (
            *(self._arrow(name, axis) for name, axis in named if self._seen_along(axis)),
            *(self._ring(name, axis) for name, axis in named),
            self._ball(),
        )
        self._overlays: dict[Part | None, Overlay] = {}

    def under(self, pixel: Pixel) -> Part | None:
        """The part under a pixel, None for none."""
        lines, middle = self._pixels
        if not np.hypot(*(pixel - middle)) > MIDDLE * RADIUS:
            return None
        away = [
            (part.rank, _distance(ends, pixel), part)
            for part, ends in zip(self.parts, lines, strict=True)
        ]
        near = [found for found in away if found[1] <= REACH]
        return min(near, key=lambda found: found[:2])[2] if near else None

    def overlay(self, hovered: Part | None = None) -> Overlay:
        """All parts, what is far first, the hovered one bright and last; the same object again."""
        if hovered not in self._overlays:
            self._overlays[hovered] = self._drawn(hovered)
        return self._overlays[hovered]

    def _drawn(self, hovered: Part | None) -> Overlay:
        order = sorted(self.parts, key=lambda part: (part is hovered, -part.rank))
        far = (Outline(p.far, p.color(False), PLAIN, FAINT) for p in order if len(p.far))
        near = (
            Outline(p.near, p.color(p is hovered), WIDE if p is hovered else PLAIN) for p in order
        )
        heads = (Fill(p.head, p.color(p is hovered)) for p in order if p.head is not None)
        return Overlay((*far, *near), fills=(*heads, self._dot()))

    @cached_property
    def _pixels(self) -> tuple[list[FloatArray], FloatArray]:
        """(k, 2, 2) the near lines of each part as they are seen, and (2,) the pivot."""
        near = [part.near.reshape(-1, 3) for part in self.parts]
        lines = [self._camera.project(points).reshape(-1, 2, 2) for points in near]
        return lines, self._camera.project(self._pivot[None])[0]

    def _seen_along(self, axis: FloatArray) -> bool:
        return abs(float(axis @ self._towards)) < END_ON

    def _arrow(self, name: str, axis: FloatArray) -> Part:
        start, neck, tip = self._pivot + self._size * np.outer((MIDDLE, ARROW - HEAD, ARROW), axis)
        side = np.cross(axis, self._towards)
        side *= 0.4 * HEAD * self._size / np.linalg.norm(side)
        shaft = np.array([[start, neck], [neck, tip]])
        head = np.array([neck + side, neck - side, tip])
        return Part(MoveAlong(self._pivot, axis, name), 0, shaft, shaft[:0], head)

    def _ring(self, name: str, axis: FloatArray) -> Part:
        circle = _circle(self._pivot, axis, self._size)
        depth = (circle.mean(axis=1) - self._pivot) @ self._towards
        near = depth >= FAR * self._size
        return Part(TurnAbout(self._pivot, axis, name), 1, circle[near], circle[~near])

    def _ball(self) -> Part:
        circle = _circle(self._pivot, self._towards, BALL * self._size)
        return Part(TurnFreely(self._pivot, self._towards), 2, circle, circle[:0])

    def _dot(self) -> Fill:
        """Where the pivot is."""
        circle = _circle(self._pivot, self._towards, DOT / RADIUS * self._size)
        return Fill(circle[:: CORNERS // 16, 0], BALL_COLOR)


def _distance(lines: FloatArray, pixel: Pixel) -> float:
    """Pixels to the nearest of lines (k, 2, 2); infinite where all are behind the camera."""
    start, end = np.moveaxis(lines, 1, 0)
    along = end - start
    length2 = np.maximum((along**2).sum(axis=1), 1e-12)
    t = np.clip(((pixel - start) * along).sum(axis=1) / length2, 0, 1)
    away = np.linalg.norm(pixel - start - t[:, None] * along, axis=1)
    return float(np.nanmin(away, initial=np.inf))


def axis_line(freedom: Freedom, pivot: FloatArray, reach: float) -> Iterator[Outline]:
    """The line along an axis, so far both ways; that of the view would be but a point."""
    if freedom.axis is not None and freedom.name in AXIS_COLORS:
        corners = pivot + np.linspace(-reach, reach, LINE_PIECES)[:, None] * freedom.axis
        color = axis_color(freedom)
        yield replace(Outline.through(corners, color, closed=False), opacity=HALF)


def turn_circle(freedom: Freedom, pivot: FloatArray, camera: Camera) -> Iterator[Outline]:
    """The ring of what turns about an axis; nothing where it does not."""
    if isinstance(freedom, TurnAbout):
        circle = _circle(pivot, freedom.axis, RADIUS * camera.units_per_pixel(pivot))
        yield Outline(circle, axis_color(freedom, True), WIDE)


def _circle(pivot: FloatArray, axis: FloatArray, radius: float) -> FloatArray:
    """(CORNERS, 2, 3) the segments of a circle about an axis."""
    corners = circle(pivot, axis, radius, CORNERS)
    return np.stack([corners, np.roll(corners, -1, axis=0)], axis=1)
