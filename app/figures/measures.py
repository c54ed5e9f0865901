"""What a folded arm is judged by: sections, inner side, kinks, strain and volume."""

from __future__ import annotations

import numpy as np

from app.figures.arm import ELBOW, FOLD_AXIS, JOINT, REACH, SHOULDER, UP, WRIST, Arm
from solver.geometry.cross_products import triangle_areas
from solver.measure.distortion import Distortion
from solver.measure.sections import Limb, Section, angle_between
from solver.measure.volume import CappedSolid
from solver.types import BoolArray, FloatArray

Numbers = dict[str, float]
SECTIONS = 33
MARGIN = 0.02  # world units: half the width of the rim, and what the ends of the arm are left out
INNER = 0.02  # how far above the arm's axis its inner side begins
SHARP = np.pi / 2  # an edge that has bent by more has folded over

MEANING = {
    "elbow_width": "extent of the elbow's section across the centre line, in the plane of the fold",
    "elbow_depth": "its extent along the axis of the fold",
    "elbow_section": "its area, seen along the centre line",
    "narrowest_section": "the smallest such area anywhere in the soft part",
    "widest_section": "the largest width or depth of a section anywhere in the soft part",
    "inner_side": "area of the inner side of the elbow",
    "volume": "of the arm between shoulder and wrist",
    "least_triangle": "area of the triangle that has lost most",
    "strain_rms": "of l'/l - 1, over the edges of the arm",
    "rim_jump": "largest change of a dihedral angle at the rim of the soft part, degrees",
    "largest_jump": "largest change of a dihedral angle anywhere on the arm, degrees",
    "edges_folded_over": "edges that have bent by more than 90 degrees",
    "bend_in_soft_part": "share of the turn between the arm's ends that lies in the soft part",
}


class ArmMeasures:
    """Numbers of a pose X (n, 3) of the arm. Sizes are shares of rest; see MEANING."""

    def __init__(self, arm: Arm) -> None:
        self._arm = arm
        self._change = Distortion(arm.V, arm.F)
        x = np.linspace(SHOULDER + MARGIN, WRIST - MARGIN, SECTIONS)
        x[np.abs(x - ELBOW).argmin()] = ELBOW
        limb = arm.edges[(arm.V[arm.edges, 0] > SHOULDER - MARGIN).all(axis=1)]
        self._limb = Limb(arm.V, limb, x)
        self._away = np.abs(x - ELBOW)
        # Between shoulder and wrist, closed at both ends.
        self._solid = CappedSolid(arm.F[arm.free[arm.F].any(axis=1)], len(arm.V))
        self._rest = self._sizes(arm.V)
        hinges = self._change.hinges
        self._bent: BoolArray = np.asarray(arm.free[hinges].any(axis=1))
        away = np.abs(arm.V[hinges, 0].mean(axis=1) - ELBOW)
        self._rim: BoolArray = self._bent & (np.abs(away - REACH) < MARGIN)
        centre = arm.V[arm.F].mean(axis=1)
        elbow = np.abs(centre[:, 0] - ELBOW) < REACH / 2
        self._inner: BoolArray = elbow & (centre[:, UP] > JOINT[UP] + INNER)
        self._areas = triangle_areas(arm.V, arm.F)

    def __call__(self, X: FloatArray) -> Numbers:
        """All of MEANING."""
        width, depth, area = (self._sizes(X) / self._rest).T
        at, soft = int(self._away.argmin()), self._away < REACH
        areas, moved = triangle_areas(X, self._arm.F), self._arm.free[self._arm.F].any(axis=1)
        jump = self._change.dihedral(X).elements
        values = {
            "elbow_width": width[at],
            "elbow_depth": depth[at],
            "elbow_section": area[at],
            "narrowest_section": area[soft].min(),
            "widest_section": max(width[soft].max(), depth[soft].max()),
            "inner_side": areas[self._inner].sum() / self._areas[self._inner].sum(),
            "volume": self._solid.volume(X) / self._solid.volume(self._arm.V),
            "least_triangle": (areas / self._areas)[moved].min(),
            "strain_rms": self._change.strain(X, self._arm.free).rms,
            "rim_jump": np.degrees(jump[self._rim].max()),
            "largest_jump": np.degrees(jump[self._bent].max()),
            "edges_folded_over": (jump[self._bent] > SHARP).sum(),
            "bend_in_soft_part": self._share(X),
        }
        return {name: float(value) for name, value in values.items()}

    def at_rest(self) -> Numbers:
        """Sizes in world units that the shares refer to."""
        width, depth, area = self._rest[int(self._away.argmin())]
        return {
            "elbow_width": float(width),
            "elbow_depth": float(depth),
            "elbow_section": float(area),
            "volume": self._solid.volume(self._arm.V),
        }

    def _sizes(self, X: FloatArray) -> FloatArray:
        """(k, 3): width, depth and area of each section."""
        line = np.gradient(self._limb.centres(X), axis=0)
        line /= np.linalg.norm(line, axis=1, keepdims=True)
        pairs = zip(self._limb.sections, line, strict=True)
        return np.array([_size(section, X, along) for section, along in pairs])

    def _share(self, X: FloatArray) -> float:
        normals = self._limb.vector_areas(X)
        inside = np.flatnonzero(self._away <= REACH)
        total = angle_between(normals[0], normals[-1])
        bend = angle_between(normals[inside[0]], normals[inside[-1]])
        return bend / total if total > 0 else 0.0


def _size(section: Section, X: FloatArray, along: FloatArray) -> tuple[float, float, float]:
    """Width, depth and area, seen along the unit vector `along` (3,)."""
    ring, axis = section.ring(X), np.eye(3)[FOLD_AXIS]
    across = np.cross(along, axis)
    across /= np.linalg.norm(across)
    area = abs(float(section.vector_area(X) @ along))
    return float(np.ptp(ring @ across)), float(np.ptp(ring @ axis)), area
