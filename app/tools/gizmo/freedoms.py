"""What a handle is free to do while it is placed: turn about or move along something.

A value, (3,), says how far: degrees as a rotation vector, or a shift in world units.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import numpy as np

from app.tools.gizmo.measures import angle_about, distance_along, shift_between, turn_between
from app.viewpoint.camera import Camera, Pixel
from solver.geometry.motions import motion, rotation
from solver.types import FloatArray

SNAP_DEGREES = 15.0


class Freedom(Protocol):
    """One way to move. name: of its axis, empty without one.  unit: written behind a number."""

    @property
    def name(self) -> str: ...

    @property
    def unit(self) -> str: ...

    @property
    def axis(self) -> FloatArray | None:
        """(3,) unit, None where it has none."""

    @property
    def exact(self) -> Freedom:
        """The one with an axis, which a typed number is for."""

    def way(self, camera: Camera, before: Pixel, now: Pixel) -> FloatArray | None:
        """The value from one pixel to another; None where that cannot be told."""

    def snapped(self, value: FloatArray, step: float) -> FloatArray:
        """The nearest round value. step: of distances."""

    def motion(self, value: FloatArray) -> FloatArray:
        """T, (4, 4)."""

    def size(self, value: FloatArray) -> str:
        """How far, as it is written beside the cursor, without a unit."""


@dataclass(frozen=True, eq=False)
class TurnAbout:
    """About an axis (3,) through the pivot (3,), right-handed."""

    pivot: FloatArray
    axis: FloatArray
    name: str
    unit: str = "°"

    @property
    def exact(self) -> Freedom:
        return self

    def way(self, camera: Camera, before: Pixel, now: Pixel) -> FloatArray | None:
        angle = angle_about(camera, self.pivot, self.axis, before, now)
        return None if angle is None else angle * self.axis

    def snapped(self, value: FloatArray, step: float) -> FloatArray:
        return _round(float(value @ self.axis), SNAP_DEGREES) * self.axis

    def motion(self, value: FloatArray) -> FloatArray:
        return motion(rotation(self.axis, float(value @ self.axis)), centre=self.pivot)

    def size(self, value: FloatArray) -> str:
        return f"{value @ self.axis:.1f}"


@dataclass(frozen=True, eq=False)
class TurnFreely:
    """As a ball about the pivot (3,). towards: (3,) unit, to the viewer."""

    pivot: FloatArray
    towards: FloatArray
    name: str = ""
    unit: str = "°"
    axis: None = None

    @property
    def exact(self) -> Freedom:
        return TurnAbout(self.pivot, self.towards, "view")

    def way(self, camera: Camera, before: Pixel, now: Pixel) -> FloatArray:
        return turn_between(camera, before, now)

    def snapped(self, value: FloatArray, step: float) -> FloatArray:
        angle = float(np.linalg.norm(value))
        return value * (_round(angle, SNAP_DEGREES) / angle if angle else 0.0)

    def motion(self, value: FloatArray) -> FloatArray:
        angle = float(np.linalg.norm(value))
        return motion(rotation(value, angle), centre=self.pivot) if angle else np.eye(4)

    def size(self, value: FloatArray) -> str:
        return f"{np.linalg.norm(value):.1f}"


@dataclass(frozen=True, eq=False)
class MoveAlong:
    """Along an axis (3,) through the pivot (3,)."""

    pivot: FloatArray
    axis: FloatArray
    name: str
    unit: str = ""

    @property
    def exact(self) -> Freedom:
        return self

    def way(self, camera: Camera, before: Pixel, now: Pixel) -> FloatArray | None:
        distance = distance_along(camera, self.pivot, self.axis, before, now)
        return None if distance is None else distance * self.axis

    def snapped(self, value: FloatArray, step: float) -> FloatArray:
        return _round(float(value @ self.axis), step) * self.axis

    def motion(self, value: FloatArray) -> FloatArray:
        return motion(np.eye(3), shift=value)

    def size(self, value: FloatArray) -> str:
        return f"{value @ self.axis:.4g}"


@dataclass(frozen=True, eq=False)
class MoveAcross:
    """Across the direction of view, as deep as the pivot (3,).

    across: (2, 3) unit, right and up of the view.  first: what a typed number moves along.
    """

    pivot: FloatArray
    across: FloatArray
    first: MoveAlong
    name: str = ""
    unit: str = ""
    axis: None = None

    @property
    def exact(self) -> Freedom:
        return self.first

    def way(self, camera: Camera, before: Pixel, now: Pixel) -> FloatArray:
        return shift_between(camera, self.pivot, before, now)

    def snapped(self, value: FloatArray, step: float) -> FloatArray:
        return np.asarray(step * np.rint(self.across @ value / step) @ self.across)

    def motion(self, value: FloatArray) -> FloatArray:
        return motion(np.eye(3), shift=value)

    def size(self, value: FloatArray) -> str:
        return f"{np.linalg.norm(value):.4g}"


def round_step(length: float) -> float:
    """The 1, 2 or 5 times a power of ten that is nearest to a hundredth of a length."""
    aim = length / 100
    power = 10.0 ** np.floor(np.log10(aim))
    return float(min((k * power for k in (1, 2, 5, 10)), key=lambda s: abs(np.log(s / aim))))


def _round(value: float, step: float) -> float:
    return step * float(np.rint(value / step))
