"""What is near the cursor, where it is not exactly under it."""

from __future__ import annotations

from itertools import product

import numpy as np

from app.model.handles import FIRST_HANDLE
from app.pointing.picking import Hit
from app.viewpoint.events import Input
from app.workspace.workspace import Workspace
from solver.types import FloatArray

RINGS, SPOKES = (1 / 3, 2 / 3, 1.0), 8
# Of the way from the eye to a vertex: what is so near to it lies not before it.
BEFORE = 0.98


def near_handle(work: Workspace, frame: Input, reach: float) -> tuple[int, FloatArray] | None:
    """The key of the handle at the cursor, within `reach` pixels, and the point (3,) of it there.

    One exactly under the cursor, else the nearest of the vertices that are seen.
    """
    if frame.pixel is None:
        return None
    document, hit = work.document, work.under(frame)
    if hit is not None and document.role[hit.vertex] >= FIRST_HANDLE:
        return int(document.role[hit.vertex]), hit.position
    seen = work.seen_handles.by(frame.camera, document, work.parts, work.surface)
    nearest = seen.nearest(frame.pixel, reach)
    if nearest is None:
        return None
    point = work.positions[nearest]
    return (int(document.role[nearest]), point) if _seen(work, frame, point) else None


def near_surface(work: Workspace, frame: Input, reach: float) -> Hit | None:
    """The point of the surface under the cursor, else one within `reach` pixels of it."""
    hit = work.under(frame)
    if hit is not None or frame.pixel is None or frame.ray is None:
        return hit
    # Most of the background is far from everything.
    if not work.picker.near(frame.ray, reach * frame.camera.pixel_angle, work.positions):
        return None
    turns = 2 * np.pi * np.arange(SPOKES) / SPOKES
    for share, turn in product(RINGS, turns):
        step = share * reach * np.array([np.cos(turn), np.sin(turn)])
        x, y = frame.pixel + step
        hit = work.pick(frame.camera.ray((float(x), float(y))))
        if hit is not None:
            return hit
    return None


def _seen(work: Workspace, frame: Input, point: FloatArray) -> bool:
    """Whether nothing lies before a point of the surface."""
    ((x, y),) = frame.camera.project(point[None])
    hit = work.pick(frame.camera.ray((float(x), float(y))))
    away = float(np.linalg.norm(point - frame.camera.position))
    return hit is None or hit.distance >= BEFORE * away
