"""What a folded arm is judged by: sections, inner side, kinks, strain and volume."""

from __future__ import annotations

import numpy as np

from app.figures.arm import ELBOW, FOLD_AXIS, JOINT, REACH, SHOULDER, UP, WRIST, Arm
from solver.measure.distortion import Distortion
from solver.types import BoolArray, FloatArray, IntArray

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
        self._places = x
        self._sections = [Section(arm.V, limb, place) for place in x]
        self._solid = Solid(arm)
        self._rest = self._sizes(arm.V)
        hinges = self._change.hinges
        self._bent: BoolArray = np.asarray(arm.free[hinges].any(axis=1))
        away = np.abs(arm.V[hinges, 0].mean(axis=1) - ELBOW)
        self._rim: BoolArray = self._bent & (np.abs(away - REACH) < MARGIN)
        centre = arm.V[arm.F].mean(axis=1)
        elbow = np.abs(centre[:, 0] - ELBOW) < REACH / 2
        self._inner: BoolArray = elbow & (centre[:, UP] > JOINT[UP] + INNER)
        self._areas = _areas(arm.V, arm.F)

    def __call__(self, X: FloatArray) -> Numbers:
        """All of MEANING."""
        width, depth, area = (self._sizes(X) / self._rest).T
        at = int(np.abs(self._places - ELBOW).argmin())
        soft = np.abs(self._places - ELBOW) < REACH
        areas, moved = _areas(X, self._arm.F), self._arm.free[self._arm.F].any(axis=1)
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
        width, depth, area = self._rest[int(np.abs(self._places - ELBOW).argmin())]
        return {
            "elbow_width": float(width),
            "elbow_depth": float(depth),
            "elbow_section": float(area),
            "volume": self._solid.volume(self._arm.V),
        }

    def _sizes(self, X: FloatArray) -> FloatArray:
        """(k, 3): width, depth and area of each section."""
        line = np.gradient(
            np.array([section.ring(X).mean(axis=0) for section in self._sections]), axis=0
        )
        line /= np.linalg.norm(line, axis=1, keepdims=True)
        pairs = zip(self._sections, line, strict=True)
        return np.array([section.size(X, along) for section, along in pairs])

    def _share(self, X: FloatArray) -> float:
        normals = np.array([section.vector_area(X) for section in self._sections])
        inside = np.flatnonzero(np.abs(self._places - ELBOW) <= REACH)
        total = _angle(normals[0], normals[-1])
        return _angle(normals[inside[0]], normals[inside[-1]]) / total if total > 0 else 0.0


class Section:
    """The ring where the plane at a place along x cuts the limb at rest."""

    def __init__(self, V: FloatArray, edges: IntArray, place: float) -> None:
        height = V[edges, 0] - place
        cut = height[:, 0] * height[:, 1] < 0
        share = height[cut, 0] / (height[cut, 0] - height[cut, 1])
        points = _between(V, edges[cut], share)
        y, z = (points - points.mean(axis=0))[:, 1:].T
        order = np.argsort(np.arctan2(z, y))
        self._edges, self._share = edges[cut][order], share[order]

    def ring(self, X: FloatArray) -> FloatArray:
        """(k, 3): where it has gone, in order around the limb."""
        return _between(X, self._edges, self._share)

    def vector_area(self, X: FloatArray) -> FloatArray:
        """(3,): normal times area of the ring."""
        ring = self.ring(X)
        ring = ring - ring.mean(axis=0)
        return 0.5 * np.cross(ring, np.roll(ring, -1, axis=0)).sum(axis=0)

    def size(self, X: FloatArray, along: FloatArray) -> tuple[float, float, float]:
        """Width, depth and area, seen along the unit vector `along` (3,)."""
        ring, axis = self.ring(X), np.eye(3)[FOLD_AXIS]
        across = np.cross(along, axis)
        across /= np.linalg.norm(across)
        area = abs(float(self.vector_area(X) @ along))
        return float(np.ptp(ring @ across)), float(np.ptp(ring @ axis)), area


class Solid:
    """The arm between shoulder and wrist, closed at both ends by fans."""

    def __init__(self, arm: Arm) -> None:
        faces = arm.F[arm.free[arm.F].any(axis=1)]
        sides = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
        keys = sides @ [len(arm.V), 1]
        rim = sides[~np.isin(keys, sides[:, ::-1] @ [len(arm.V), 1])]
        far = arm.V[rim[:, 0], 0] > ELBOW
        self._rims = [rim[~far], rim[far]]
        caps = [
            np.column_stack([end[:, ::-1], np.full(len(end), len(arm.V) + number)])
            for number, end in enumerate(self._rims)
        ]
        self._faces = np.concatenate([faces, *caps])

    def volume(self, X: FloatArray) -> float:
        """Of the solid in a pose X (n, 3)."""
        Y = np.vstack([X, *(X[end[:, 0]].mean(axis=0) for end in self._rims)])
        a, b, c = (Y[corner] for corner in self._faces.T)
        return float(np.einsum("ij,ij->", a, np.cross(b, c)) / 6)


def _between(X: FloatArray, edges: IntArray, share: FloatArray) -> FloatArray:
    return X[edges[:, 0]] + share[:, None] * (X[edges[:, 1]] - X[edges[:, 0]])


def _areas(X: FloatArray, F: IntArray) -> FloatArray:
    a, b, c = (X[corner] for corner in F.T)
    return 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1)


def _angle(u: FloatArray, v: FloatArray) -> float:
    return float(np.arctan2(np.linalg.norm(np.cross(u, v)), u @ v))
