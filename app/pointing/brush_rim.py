"""The rim of a brush: where on the surface a dab would end."""

from __future__ import annotations

import numpy as np

from app.pointing.brush import Neighbours
from app.pointing.picking import Hit
from app.scene.overlay import Color, Outline
from app.viewpoint.camera import Camera
from solver.geometry.circles import circle
from solver.geometry.cross_products import area_vectors
from solver.geometry.crossings import crossed_triangles
from solver.types import FloatArray, IntArray

SEGMENTS = 48  # of the circle where the brush is smaller than a triangle
FEWEST = 6  # segments of a rim that can be seen as one


def brush_rim(
    neighbours: Neighbours,
    positions: FloatArray,
    hit: Hit,
    corners: FloatArray,
    radius: float,
    camera: Camera,
    color: Color,
) -> Outline:
    """The border of what `Neighbours.dab` takes, on the side of the surface that is seen.

    Between vertices it runs at exactly `radius` from the hit. A brush that ends within the
    triangles around the hit is a circle in the plane of its triangle, corners (3, 3).
    """
    reached, _ = neighbours.dab(positions, hit, radius)
    alone = np.linalg.norm(positions[reached[0]] - hit.position) >= radius
    inside = np.zeros(len(positions), dtype=bool)
    inside[reached] = True
    crossed = crossed_triangles(neighbours.faces_around(reached), inside)
    if alone or len(crossed) < FEWEST:
        return Outline.through(_circle(hit.position, corners, radius, camera), color)
    normals = area_vectors(positions, crossed)
    towards = positions[crossed[:, 0]] - camera.position
    seen = crossed[(normals * towards).sum(axis=1) < 0]
    return Outline(_border(positions, seen, hit.position, radius), color)


def _border(X: FloatArray, crossed: IntArray, centre: FloatArray, radius: float) -> FloatArray:
    """(k, 2, 3) a segment for each triangle that the border crosses."""
    a, b, c = (X[corner] for corner in crossed.T)
    return np.stack([_meet(a, end, centre, radius) for end in (b, c)], axis=1)


def _meet(a: FloatArray, b: FloatArray, centre: FloatArray, radius: float) -> FloatArray:
    """(k, 3) where edges pass through the sphere about the centre; else their middle."""
    d, e = b - a, a - centre
    A, B = (d * d).sum(axis=1), (d * e).sum(axis=1)
    C = (e * e).sum(axis=1) - radius**2
    with np.errstate(invalid="ignore", divide="ignore"):
        root = np.sqrt(B**2 - A * C)
        near, far = (-B - root) / A, (-B + root) / A
    t = np.where((near >= 0) & (near <= 1), near, far)
    t = np.where((t >= 0) & (t <= 1), t, 0.5)
    return a + t[:, None] * d


def _circle(centre: FloatArray, corners: FloatArray, radius: float, camera: Camera) -> FloatArray:
    """(SEGMENTS, 3) in the plane of a triangle with corners (3, 3)."""
    normal = np.cross(corners[1] - corners[0], corners[2] - corners[0])
    # A face without area has no plane: the circle faces the person.
    if not np.linalg.norm(normal) > 0:
        normal = camera.forward
    return circle(centre, normal, radius, SEGMENTS)
