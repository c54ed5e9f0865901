"""How far a cursor turns about an axis or moves along one, seen through the camera."""

from __future__ import annotations

import numpy as np

from app.viewpoint.camera import Camera, Pixel, Ray
from app.viewpoint.moves import ORBIT
from solver.types import FloatArray

# Cosine of the angle between view and axis below which a ring is seen so much from its side that
# the cursor's place on it is a guess.
EDGE_ON = 0.2
# Sine of the angle between view and axis below which an axis is but a point on screen.
END_ON = 0.1


def angle_about(
    camera: Camera, pivot: FloatArray, axis: FloatArray, before: Pixel, now: Pixel
) -> float | None:
    """Degrees, right-handed about a unit axis (3,), from one pixel to another; at most 180.

    In the plane across the axis through the pivot; where that is seen from its side, as far as
    the near side of a ring follows the cursor. None where a pixel does not see the plane.
    """
    towards = _unit(camera.position - pivot)
    if abs(float(towards @ axis)) < EDGE_ON:
        return _angle_edge_on(camera, pivot, axis, before, now)
    a, b = (_across(camera.ray(pixel), pivot, axis) for pixel in (before, now))
    if a is None or b is None:
        return None
    return float(np.degrees(np.arctan2(np.cross(a, b) @ axis, a @ b)))


def _angle_edge_on(
    camera: Camera, pivot: FloatArray, axis: FloatArray, before: Pixel, now: Pixel
) -> float:
    """The way along the tangent of the ring's near side, ORBIT for the height of the window."""
    tangent = np.cross(axis, _unit(camera.position - pivot))
    screen = _unit(np.array([tangent @ camera.right, -tangent @ camera.up]))
    way = np.subtract(now, before) @ screen
    return float(np.degrees(ORBIT * way / camera.size[1]))


def turn_between(camera: Camera, before: Pixel, now: Pixel) -> FloatArray:
    """(3,) rotation vector in degrees: a ball's front follows the cursor."""
    x, y = np.subtract(now, before)
    return np.degrees(ORBIT / camera.size[1]) * (x * camera.up + y * camera.right)


def distance_along(
    camera: Camera, pivot: FloatArray, axis: FloatArray, before: Pixel, now: Pixel
) -> float | None:
    """How far the point of the axis (3,) through the pivot moves that is nearest to the cursor.

    Where the axis is seen from its end, away as the cursor goes up. None where a pixel sees it
    from its end.
    """
    if np.linalg.norm(np.cross(axis, _unit(pivot - camera.position))) < END_ON:
        up = before[1] - now[1]
        return float(up * camera.units_per_pixel(pivot) * np.sign(axis @ camera.forward))
    a, b = (_nearest(camera.ray(pixel), pivot, axis) for pixel in (before, now))
    return None if a is None or b is None else b - a


def shift_between(camera: Camera, pivot: FloatArray, before: Pixel, now: Pixel) -> FloatArray:
    """(3,) how far the cursor moves across the direction of view, as deep as the pivot."""
    depth = camera.depth(pivot)
    return camera.at_depth(now, depth) - camera.at_depth(before, depth)


def _across(ray: Ray, pivot: FloatArray, axis: FloatArray) -> FloatArray | None:
    """(3,) from the pivot to where a ray meets the plane across the axis; None if nowhere."""
    slope = float(ray.direction @ axis)
    distance = float((pivot - ray.origin) @ axis) / slope if slope else 0.0
    return ray.at(distance) - pivot if distance > 0 else None


def _nearest(ray: Ray, pivot: FloatArray, axis: FloatArray) -> float | None:
    """Where on the axis the point nearest to a ray is; None where they are nearly parallel."""
    cosine = float(ray.direction @ axis)
    sine2 = 1.0 - cosine**2
    if sine2 < END_ON**2:
        return None
    away = ray.origin - pivot
    return float(away @ axis - cosine * (away @ ray.direction)) / sine2


def _unit(vector: FloatArray) -> FloatArray:
    return np.asarray(vector / np.linalg.norm(vector))
