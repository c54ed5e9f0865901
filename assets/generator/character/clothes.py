"""Clothes of the figure: shells of its skin, and bands around it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from assets.generator.character.rings import circle
from assets.generator.character.seams import Part, cut_part
from assets.generator.character.shells import Thickness, shell, slide
from assets.generator.figure import ARM_DEPTH, ARM_HEIGHT, X, Y, Z
from assets.generator.implicit import Field, project
from assets.generator.primitives import regular_triangles
from solver.types import FloatArray, IntArray

HEM, WAIST, ANKLE, SHOE_TOP, CUFF = 0.965, 1.03, 0.115, 0.085, 0.705
BELT_HEIGHT, BELT_THICKNESS = 1.0, 0.0155
SHIRT_THICKNESS = 0.006
NECKLINE = (0.0, 1.0, 0.4)
NECK_LEVEL = 1.512
"""The neckline is where p . NECKLINE = NECK_LEVEL: lower in front."""
HAIR_THICKNESS, HAIR_WAVE, HAIR_WAVES = 0.012, 0.003, 11

# Rows of a band: place in half widths, height above the skin in thicknesses.
PROFILE = np.array([[-1.0, 0.5], [-0.7, 1.0], [0.0, 1.04], [0.7, 1.0], [1.0, 0.5]])


def _even(thickness: float) -> Thickness:
    return lambda p: np.full(len(p), thickness)


def _sole(p: FloatArray) -> FloatArray:
    """Thicker below than above."""
    return 0.009 + 0.009 * np.clip(1 - p[:, Y] / 0.02, 0, 1)


def _waves(p: FloatArray) -> FloatArray:
    """Ridges from the crown down, none at the crown itself."""
    x, z = p[:, X], p[:, Z] + 0.015
    away = np.clip((np.hypot(x, z) - 0.02) / 0.05, 0, 1)
    return HAIR_THICKNESS + HAIR_WAVE * away * np.cos(HAIR_WAVES * np.arctan2(x, z))


@dataclass(frozen=True)
class Shell:
    """outside: negative where the skin is covered.  thickness: between the skin and the shell."""

    name: str
    material: str
    outside: Field
    thickness: Thickness


@dataclass(frozen=True)
class Band:
    """A strip around the solid, in the plane through `centre` with this normal.

    radius: about that of the solid there.  around: how many vertices a round has.
    """

    name: str
    material: str
    centre: tuple[float, float, float]
    normal: tuple[float, float, float]
    radius: float
    half_width: float
    thickness: float
    around: int


def _neckline(p: FloatArray) -> FloatArray:
    return np.asarray(p @ NECKLINE - NECK_LEVEL)


def _shirt(p: FloatArray) -> FloatArray:
    return np.max([HEM - p[:, Y], np.abs(p[:, X]) - CUFF, _neckline(p)], axis=0)


SHELLS = [
    Shell("shirt", "cotton", _shirt, _even(SHIRT_THICKNESS)),
    Shell("trousers", "denim", lambda p: np.maximum(p[:, Y] - WAIST, ANKLE - p[:, Y]), _even(0.01)),
    Shell("left shoe", "leather", lambda p: np.maximum(p[:, Y] - SHOE_TOP, -p[:, X]), _sole),
    Shell("right shoe", "leather", lambda p: np.maximum(p[:, Y] - SHOE_TOP, p[:, X]), _sole),
    Shell("hair", "hair", lambda p: 1.715 + 0.45 * p[:, Z] - p[:, Y], _waves),
]
ALONG, UP = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)
ARM = ARM_HEIGHT, ARM_DEPTH
BANDS = [
    Band("left cuff", "cotton", (0.69, *ARM), ALONG, 0.05, 0.022, 0.0105, 32),
    Band("right cuff", "cotton", (-0.69, *ARM), ALONG, 0.05, 0.022, 0.0105, 32),
    Band("collar", "cotton", (0.0, NECK_LEVEL + 0.01, -0.015), NECKLINE, 0.06, 0.014, 0.01, 40),
    Band("belt", "leather", (0.0, BELT_HEIGHT, 0.0), UP, 0.14, 0.02, BELT_THICKNESS, 56),
]


def clothes(field: Field, V: FloatArray, F: IntArray) -> list[Part]:
    """All that is worn on the figure with this field and mesh."""
    shells = [
        cut_part(one.name, one.material, *shell(field, V, F, one.outside, one.thickness))
        for one in SHELLS
    ]
    return shells + [cut_part(one.name, one.material, *band(field, one)) for one in BANDS]


def band(field: Field, strip: Band) -> tuple[FloatArray, IntArray]:
    """The surface of a strip, with rims that tuck in."""
    normal = np.asarray(strip.normal) / np.linalg.norm(strip.normal)
    one = np.cross(normal, np.eye(3)[np.abs(normal).argmin()])
    one /= np.linalg.norm(one)
    ring = strip.radius * circle(strip.around) @ [one, np.cross(normal, one)]
    across = strip.half_width * PROFILE[:, :1, None] * normal
    start = (np.asarray(strip.centre) + ring + across).reshape(-1, 3)
    height = (strip.thickness * PROFILE[:, 1]).repeat(strip.around)
    plane = start @ normal

    def above(p: FloatArray) -> FloatArray:
        return field(p) - height

    V = slide(above, lambda p: p @ normal - plane, project(above, start, rounds=8))
    index = np.arange(len(V)).reshape(-1, strip.around)
    return V, regular_triangles(np.concatenate((index, index[:, :1]), axis=1))[:, ::-1]
