"""The mannequin's left arm: what is held, where it is soft, and how it is posed."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from solver import Deformer, Mesh, fundamental_forms
from solver.geometry.motions import rotation_about
from solver.softness.falloff import falloff
from solver.types import BoolArray, FloatArray, IntArray

# Along x, in world units: where the fixed part ends, the elbow is, and the hand begins.
SHOULDER, ELBOW, WRIST = 0.25, 0.465, 0.755
JOINT = np.array([ELBOW, 1.425, -0.006])  # on the axis of the arm
REACH = 0.1  # from the elbow to the end of the soft part, world units
UP, FOLD_AXIS = 1, 2  # the arm folds upwards, about z


@dataclass(frozen=True)
class Gains:
    """What multiplies E_f and E_x where the arm is fully soft; step: all of the soft part is."""

    bending: float = 1.0
    stretching: float = 1.0
    step: bool = False


class Arm:
    """The default mesh with its body fixed and its left hand a handle."""

    def __init__(self, mesh: Mesh) -> None:
        self.mesh = mesh
        self.V, self.F = mesh.vertices, mesh.faces
        x = self.V[:, 0]
        self.fixed: IntArray = np.flatnonzero(x < SHOULDER)
        self.hand: IntArray = np.flatnonzero(x > WRIST)
        self.free: BoolArray = (x >= SHOULDER) & (x <= WRIST)

    @cached_property
    def edges(self) -> IntArray:
        """(e, 2)."""
        return fundamental_forms(self.V, self.F).edges

    def softness(self, x: FloatArray, step: bool = False) -> FloatArray:
        """At places x along the arm: 1 at the elbow, 0 beyond its reach; C1, or a step."""
        u = (x - ELBOW) / REACH
        return np.where(np.abs(u) < 1, 1.0, 0.0) if step else falloff(u)

    def edge_gains(self, gains: Gains) -> tuple[IntArray, FloatArray, FloatArray]:
        """What Deformer takes: gains set edge by edge, as the paper does."""
        s = self.softness(self.V[self.edges, 0].mean(axis=1), gains.step)
        return self.edges, gains.bending**s, gains.stretching**s

    def deformer(self, gains: Gains, bending_length: float) -> Deformer:
        """With those gains and the hand as a handle."""
        return Deformer(
            self.V,
            self.F,
            self.fixed,
            [self.hand],
            bending_length=bending_length,
            edge_gains=self.edge_gains(gains),
        )


def turn(degrees: float, centre: FloatArray) -> FloatArray:
    """(4, 4): the hand up and in, about the fold's axis through `centre`."""
    return rotation_about(np.eye(3)[FOLD_AXIS], degrees, centre)
