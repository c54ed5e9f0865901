"""How a camera moves: it turns about a point, shifts with the cursor, goes towards it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from scipy.spatial.transform import Rotation

from app.viewpoint.camera import Camera, Pixel
from solver.types import FloatArray

ORBIT = np.pi  # radians for a way as long as the window is high
STEEPEST = np.radians(89.0)  # straight from above there is no upright picture
STEP = 0.85  # of the distance that is left after a notch of the wheel


def orbited(camera: Camera, pivot: FloatArray, way: Pixel, up: FloatArray) -> Camera:
    """Turned about a point, which keeps its pixel, as the cursor moves by `way` pixels.

    up: (3,) unit, the axis that stays upright.
    """
    side, rise = (-ORBIT * pixels / camera.size[1] for pixels in way)
    elevation = float(np.arcsin(np.clip(camera.forward @ up, -1, 1)))
    rise = float(np.clip(elevation + rise, -STEEPEST, STEEPEST)) - elevation
    turn = Rotation.from_rotvec(side * up) * Rotation.from_rotvec(rise * camera.right)
    return replace(
        camera,
        position=pivot + turn.apply(camera.position - pivot),
        forward=turn.apply(camera.forward),
        up=turn.apply(camera.up),
    )


def panned(camera: Camera, point: FloatArray, pixel: Pixel) -> Camera:
    """Shifted across the direction of view so that a point is seen at a pixel."""
    there = camera.at_depth(pixel, camera.depth(point))
    return camera.placed(camera.position + point - there)


def zoomed(camera: Camera, point: FloatArray, notches: float, nearest: float) -> Camera:
    """Closer to a point, which keeps its pixel, by notches of the wheel; farther where negative.

    nearest: how close the camera may come.
    """
    away = camera.position - point
    factor = max(STEP**notches, nearest / max(float(np.linalg.norm(away)), nearest))
    return camera.placed(point + factor * away)
