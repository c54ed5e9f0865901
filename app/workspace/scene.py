"""What is drawn, as data: a surface with colours, dots on it, a line where the cursor is.

Whoever draws a Scene needs to know nothing else, and whoever makes one no graphics library.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from app.workspace.camera import Camera
from app.workspace.picking import Hit
from solver.mesh.mesh import Mesh
from solver.types import FloatArray, IntArray

Color = tuple[int, int, int]  # RGB, 0 to 255

DOT_RADIUS = 0.16  # in edges of the mesh: dots never hide the colours between them
BRUSH_SEGMENTS = 48
PAINTING, ERASING = (255, 255, 255), (255, 90, 70)


@dataclass(frozen=True, eq=False)
class Dots:
    """Small spheres. centres: (k, 3). radius: in world units."""

    centres: FloatArray
    radius: float


@dataclass(frozen=True, eq=False)
class Outline:
    """A line of constant width over the surface. corners: (k, 3). closed: the last meets the first.

    It shows where a tool acts: the rim of the brush, the loop of a selection.
    """

    corners: FloatArray
    color: Color
    closed: bool = True


@dataclass(frozen=True, eq=False)
class Scene:
    """What the view shows at one moment.

    What has not changed since the last scene is the same object, so that the view can tell by
    identity: arrays are never written in place once they are part of a scene.

    mesh: another one is another surface, seen afresh.  polygons: those of it that are drawn.
    positions: (n, 3) of its vertices.  colors: (n, 3) RGB in [0, 1] of its vertices.
    dots: what is pinned.  edges: whether the edges of the polygons are drawn.
    outline: where the tool in the hand would act.
    """

    mesh: Mesh
    polygons: IntArray | list[list[int]]
    positions: FloatArray
    colors: FloatArray
    dots: Dots | None = None
    edges: bool = False
    outline: Outline | None = None


def dot_radius(vertices: FloatArray, edges: IntArray) -> float:
    """Of dots on vertices (n, 3) joined by edges (e, 2): small where the mesh is fine."""
    ends = vertices[edges]
    lengths = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
    return DOT_RADIUS * float(lengths.mean()) if len(lengths) else 0.0


def brush_outline(
    hit: Hit, corners: FloatArray, radius: float, camera: Camera, erasing: bool
) -> Outline:
    """The rim of a brush: a circle around a hit in the plane of its triangle, corners (3, 3)."""
    normal = np.cross(corners[1] - corners[0], corners[2] - corners[0])
    # A face without area has no plane: the circle faces the person.
    if not np.linalg.norm(normal) > 0:
        normal = camera.forward
    one = np.cross(normal, np.eye(3)[np.abs(normal).argmin()])
    one /= np.linalg.norm(one)
    two = np.cross(normal / np.linalg.norm(normal), one)
    angle = np.linspace(0, 2 * np.pi, BRUSH_SEGMENTS, endpoint=False)[:, None]
    rim = hit.position + radius * (np.cos(angle) * one + np.sin(angle) * two)
    return Outline(rim, ERASING if erasing else PAINTING)
