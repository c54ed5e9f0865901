"""Small things on the figure: eyes, brows, locks of hair, buttons, buckle, finger nails."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from assets.generator.character.clothes import (
    BELT_HEIGHT,
    BELT_THICKNESS,
    HAIR_THICKNESS,
    SHIRT_THICKNESS,
)
from assets.generator.character.rings import ball, lock
from assets.generator.character.seams import Part, cut_part
from assets.generator.figure import ARM_HEIGHT, FINGERS
from assets.generator.implicit import Field, gradient, project
from assets.generator.primitives import bar, cylinder
from solver.types import FloatArray, IntArray

Surface = tuple[FloatArray, IntArray]
Point = tuple[float, float, float]

EYE_PLACE, EYE_RADIUS = np.array([0.0315, 1.688, 0.0645]), 0.0132
IRIS_RADII = (0.0062, 0.0062, 0.002)
BROW = [(0.016, 1.712, 0.09), (0.033, 1.718, 0.09), (0.052, 1.709, 0.08)]
LOCKS = (-0.044, -0.022, 0.0, 0.022, 0.044)
BUTTONS = np.linspace(1.07, 1.45, 6)
NAIL_RADII = (0.0062, 0.0052, 0.0018)
# Of thumb, index, ..., little finger: a place near the tip and the finger's direction.
THUMB = ((0.858, ARM_HEIGHT - 0.012, 0.080), (0.89, -0.03, 0.45))
NAILS = [THUMB] + [
    ((tip - 0.004, ARM_HEIGHT - 0.003, z1), (0.09, -0.005, z1 - z0)) for z0, z1, tip in FINGERS
]
FINGER_NAMES = ("thumb", "index", "middle", "ring", "little")


def details(field: Field) -> list[Part]:
    """All small things on the figure with this field."""
    pairs = [
        ("eye", "white", _eye()),
        ("iris", "iris", _iris()),
        ("brow", "hair", lock(_on(field, BROW, 0.001), 0.0042, 9, 7)),
    ]
    nails = zip(FINGER_NAMES, NAILS, strict=True)
    pairs += [(f"{name} nail", "nail", _nail(field, *where)) for name, where in nails]
    both = [part for pair in pairs for part in _both(*pair)]
    single = [
        *((f"lock {k + 1}", "hair", _lock(field, x)) for k, x in enumerate(LOCKS)),
        *((f"button {k + 1}", "horn", _button(field, y)) for k, y in enumerate(BUTTONS.tolist())),
        ("buckle", "brass", _buckle(field)),
    ]
    return both + [cut_part(name, material, *surface) for name, material, surface in single]


def _both(name: str, material: str, surface: Surface) -> list[Part]:
    """The part as given, on the figure's left, and its mirror image."""
    V, F = surface
    return [
        cut_part(f"left {name}", material, V, F),
        cut_part(f"right {name}", material, V * [-1, 1, 1], F[:, ::-1]),
    ]


def _on(field: Field, points: Sequence[Point], height: float) -> FloatArray:
    """Points moved to a height above the skin."""
    return project(lambda p: field(p) - height, np.array(points, dtype=float), rounds=8)


def _placed(field: Field, surface: Surface, at: Point, height: float, along: Point) -> Surface:
    """A surface about the origin put above the skin: z on the normal, x as near to `along` as
    can be."""
    V, F = surface
    place = _on(field, [at], height)
    normal = gradient(field, place)[0]
    normal /= np.linalg.norm(normal)
    up = np.cross(normal, along)
    up /= np.linalg.norm(up)
    return place + V @ np.stack((np.cross(up, normal), up, normal)), F


def _eye() -> Surface:
    V, F = ball((EYE_RADIUS,) * 3, 10, 16)
    return V + EYE_PLACE, F


def _iris() -> Surface:
    V, F = ball(IRIS_RADII, 5, 12)
    return V + EYE_PLACE + [0, 0, EYE_RADIUS], F


def _lock(field: Field, x: float) -> Surface:
    """From the crown over the hair to the forehead."""
    path = [(x / 2, 1.81, -0.02), (x, 1.80, 0.04), (1.3 * x + 0.006, 1.765, 0.08)]
    path += [(1.5 * x + 0.014, 1.728, 0.10)]
    return lock(_on(field, path, HAIR_THICKNESS), 0.0105, 12, 8)


def _button(field: Field, height: float) -> Surface:
    V, F = cylinder(0.004, 0.0085, 2)
    at = (0.0, height, 0.12)
    return _placed(field, (V[:, [1, 2, 0]], F), at, SHIRT_THICKNESS + 0.002, (1, 0, 0))


def _buckle(field: Field) -> Surface:
    V, F = bar(0.056, 0.048, 4)
    at = (0.0, BELT_HEIGHT, 0.12)
    return _placed(field, (V * [1, 1, 0.15], F), at, BELT_THICKNESS, (1, 0, 0))


def _nail(field: Field, at: Point, along: Point) -> Surface:
    x, y, z = at
    return _placed(field, ball(NAIL_RADII, 5, 10), (x, y + 0.012, z), 0.0, along)
