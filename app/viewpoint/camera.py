"""A perspective camera as numbers, from pixels to rays and from points to pixels."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike

from solver.types import FloatArray

Pixel = tuple[float, float]  # x to the right and y down, from the top left corner

FIELD_OF_VIEW = np.radians(45.0)  # vertical


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

    def placed(self, position: FloatArray) -> Camera:
        """The same camera elsewhere."""
        return replace(self, position=position)

    def resized(self, size: tuple[float, float]) -> Camera:
        """The same camera in a window of another size."""
        return self if size == self.size else replace(self, size=size)

    @property
    def right(self) -> FloatArray:
        """(3,) unit, towards the right of the picture."""
        return np.cross(self.forward, self.up)

    @property
    def _focal_length(self) -> float:
        """Distance, in pixels, at which one unit is one pixel."""
        return 0.5 * self.size[1] / float(np.tan(0.5 * self.fov))

    @property
    def pixel_angle(self) -> float:
        """The angle of a pixel in the middle of the picture, in radians."""
        return 1.0 / self._focal_length

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

    def depth(self, point: FloatArray) -> float:
        """How far a point is along the direction of view."""
        return float((point - self.position) @ self.forward)

    def at_depth(self, pixel: Pixel, depth: float) -> FloatArray:
        """(3,) the point under a pixel that is so far along the direction of view."""
        return self.all_at_depth(np.array([pixel]), depth)[0]

    def all_at_depth(self, pixels: FloatArray, depth: float) -> FloatArray:
        """(k, 3) the points under pixels (k, 2) that are so far along the direction of view."""
        x, y = ((pixels - 0.5 * np.array(self.size)) * (depth / self._focal_length)).T
        across = x[:, None] * self.right - y[:, None] * self.up
        return self.position + depth * self.forward + across

    def units_per_pixel(self, point: FloatArray) -> float:
        """World length that one pixel covers at the depth of `point`."""
        return self.depth(point) / self._focal_length


def rays_between(before: Ray, now: Ray, count: int) -> Iterator[Ray]:
    """`count` rays from `before` (left out) to `now` (the last), evenly spread."""
    for t in np.arange(1, count) / count:
        direction = (1 - t) * before.direction + t * now.direction
        origin = (1 - t) * before.origin + t * now.origin
        yield Ray(origin, direction / np.linalg.norm(direction))
    yield now


def _unit(vector: FloatArray) -> FloatArray:
    return vector / np.linalg.norm(vector)
