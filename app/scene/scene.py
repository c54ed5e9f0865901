"""What is drawn, as data: a surface with colours, dots on it, lines over it.

Whoever draws a Scene needs to know nothing else, and whoever makes one no graphics library.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from app.scene.looks import PLAIN, Looks
from app.scene.overlay import NOTHING, Overlay
from app.scene.shading import Shaded
from app.scene.twin import Twin
from solver.types import FloatArray, IntArray

DOT_RADIUS = 0.16  # in edges of the mesh: dots never hide the colours between them


@dataclass(frozen=True, eq=False)
class Dots:
    """Small spheres. centres: (k, 3). radius: in world units."""

    centres: FloatArray
    radius: float


@dataclass(frozen=True, eq=False)
class Lines:
    """Thin tubes on the surface. nodes: (k, 3). edges: (e, 2). colors: (e, 3) RGB in [0, 1].

    radius: in world units.
    """

    nodes: FloatArray
    edges: IntArray
    colors: FloatArray
    radius: float


@dataclass(frozen=True, eq=False)
class Scene:
    """What the view shows at one moment.

    What has not changed since the last scene is the same object, so that the view can tell by
    identity: arrays are never written in place once they are part of a scene.

    shaded: the polygons that are drawn; another one is another surface, seen afresh.
    positions: (n, 3) of the mesh's vertices.  colors: (n, 3) RGB in [0, 1] of them.
    dots: what is pinned.  looks: how the surface is drawn.
    ghost: (n, 3) of its vertices where it is seen through, None where it is not.
    twin: what stands beside it.
    lines: the borders of what is held.  overlay: what is drawn over it.
    """

    shaded: Shaded
    positions: FloatArray
    colors: FloatArray
    dots: Dots | None = None
    looks: Looks = PLAIN
    ghost: FloatArray | None = None
    twin: Twin | None = None
    lines: Lines | None = None
    overlay: Overlay = NOTHING


def dot_radius(vertices: FloatArray, edges: IntArray) -> float:
    """Of dots on vertices (n, 3) joined by edges (e, 2): small where the mesh is fine."""
    ends = vertices[edges]
    lengths = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
    return DOT_RADIUS * float(lengths.mean()) if len(lengths) else 0.0
