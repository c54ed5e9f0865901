"""A perspective camera as numbers, from pixels to rays and from points to pixels."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from solver.types import FloatArray

Pixel = tuple[float, float]  # x to the right and y down, from the top left corner

FIELD_OF_VIEW = np.radians(45.0)  # vertical
FIT = 1.15  # how much larger than the mesh a framed view is


@dataclass(frozen=True, eq=False)
class Ray:
    """A half-line. origin: (3,) world position. direction: (3,) of unit length."""

    origin: FloatArray
    direction: FloatArray

    def at(self, distance: float) -> FloatArray:
        """The point `distance` along the ray, (3,)."""
        return self.origin + distance * self.direction


@dataclass(frozen=True, eq=False)
class Camera:
    """position: (3,). forward, up: (3,) unit and orthogonal. fov: vertical, in radians.

    size: (width, height) of the picture in pixels, origin at its top left corner.
    """

    position: FloatArray
    forward: FloatArray
    up: FloatArray
    fov: float
    size: tuple[float, float]

    @staticmethod
    def look_at(
        position: ArrayLike, target: ArrayLike, fov: float, size: tuple[float, float]
    ) -> Camera:
        """A camera upright about the y axis."""
        eye = np.asarray(position, dtype=np.float64)
        forward = _unit(np.asarray(target, dtype=np.float64) - eye)
        right = _unit(np.cross(forward, [0.0, 1.0, 0.0]))
        return Camera(eye, forward, np.cross(right, forward), fov, size)

    @staticmethod
    def framing(positions: FloatArray, size: tuple[float, float], inset: float = 0.0) -> Camera:
        """From the front, the whole of `positions` (n, 3), right of `inset` pixels of panel."""
        low, high = positions.min(axis=0), positions.max(axis=0)
        wide, tall, deep = high - low
        width, height = size
        # Height of the view, in world units, at the front of the bounding box.
        view = max(FIT * max(tall, wide * height / max(width - inset, 1.0)), 1e-9)
        target = 0.5 * (low + high) - [0.5 * inset / height * view, 0.0, 0.0]
        distance = 0.5 * view / np.tan(0.5 * FIELD_OF_VIEW) + 0.5 * deep
        return Camera.look_at(target + [0.0, 0.0, distance], target, FIELD_OF_VIEW, size)

    @property
    def right(self) -> FloatArray:
        """(3,) unit, towards the right of the picture."""
        return np.cross(self.forward, self.up)

    @property
    def _focal_length(self) -> float:
        """Distance, in pixels, at which one unit is one pixel."""
        return 0.5 * self.size[1] / float(np.tan(0.5 * self.fov))

    def ray(self, pixel: Pixel) -> Ray:
        """The ray through a pixel."""
        x, y = pixel[0] - 0.5 * self.size[0], 0.5 * self.size[1] - pixel[1]
        direction = self._focal_length * self.forward + x * self.right + y * self.up
        return Ray(self.position, _unit(direction))

    def project(self, points: FloatArray) -> FloatArray:
        """Pixels (k, 2) of points (k, 3); NaN for points behind the camera."""
        away = points - self.position
        depth = away @ self.forward
        scale = self._focal_length / np.where(depth > 0, depth, np.nan)
        x = 0.5 * self.size[0] + scale * (away @ self.right)
        y = 0.5 * self.size[1] - scale * (away @ self.up)
        return np.column_stack([x, y])

    def units_per_pixel(self, point: FloatArray) -> float:
        """World length that one pixel covers at the depth of `point`."""
        return float((point - self.position) @ self.forward) / self._focal_length


def rays_between(before: Ray, now: Ray, count: int) -> Iterator[Ray]:
    """`count` rays from `before` (left out) to `now` (the last), evenly spread."""
    for t in np.arange(1, count) / count:
        direction = (1 - t) * before.direction + t * now.direction
        origin = (1 - t) * before.origin + t * now.origin
        yield Ray(origin, direction / np.linalg.norm(direction))
    yield now


def _unit(vector: FloatArray) -> FloatArray:
    return vector / np.linalg.norm(vector)
