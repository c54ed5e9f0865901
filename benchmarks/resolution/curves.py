"""A limb at many resolutions, bent by its end: how much of the bend lies within its soft band."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from benchmarks.cases.limbs import SoftLimb, limb
from solver import Deformer
from solver.geometry.motions import rotation_about
from solver.types import FloatArray

SIZES = (32, 20), (64, 44), (128, 88)  # (along, around)
FINEST = 192, 128
TRIANGULATIONS = "right", "alternating", "irregular"
BEND = 60.0
GRABBED = np.array([3.5, 0.0, 0.0])
# (material, softness of the band's middle)
HINGE = tuple(("hinge", s) for s in (0.0, 0.25, 0.5, 0.75, 1.0))
MATERIALS = (*HINGE, ("paper", 1.0), ("clay", 1.0))


@dataclass(frozen=True)
class Curve:
    """What one mesh does, a value for each of MATERIALS.

    linear, rigid: percent of the bend within the band, the tip turned by `pose` at rigid 0 and 1.
    turn: degrees by which the tip turns of itself when `orient` carries it around.
    dragged: percent of that turn within the band.
    """

    name: str
    vertices: int
    linear: FloatArray
    rigid: FloatArray
    turn: FloatArray
    dragged: FloatArray


def measure(name: str, one: SoftLimb, bending_length: float = 0.01) -> Curve:
    """Bend a limb with every material."""
    deformer = Deformer(one.V, one.F, one.root, [one.tip], bending_length=bending_length)
    rows = []
    for material, softness in MATERIALS:
        deformer = deformer.rebind(softness=softness * one.softness, material=material)
        T = rotation_about([0, 0, 1], BEND)
        shares = [one.share(deformer.pose([T], rigid), BEND) for rigid in (0, 1)]
        T = deformer.orient(0, GRABBED, T[:3, :3] @ GRABBED, [np.eye(4)])
        turn = float(np.degrees(np.arctan2(T[1, 0], T[0, 0])))
        rows.append([*shares, turn, one.share(deformer.pose([T]), turn)])
    return Curve(name, len(one.V), *np.transpose(rows))


def curves(shape: str) -> list[Curve]:
    """Every triangulation at every size; the last is the reference."""
    meshes = [(t, *size) for size in SIZES for t in TRIANGULATIONS]
    meshes.append(("alternating", *FINEST))
    return [measure(t, limb(shape, t, *size)) for t, *size in meshes]
