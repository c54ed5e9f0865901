"""The deformations on which shape quality is judged."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

import igl
import numpy as np

from app.model.session import read_session
from assets.primitives import cylinder
from benchmarks.quality_metrics import Limb
from benchmarks.survey import CASES, DEFAULT, PUBLISHED
from solver import Deformer, load_mesh
from solver.types import BoolArray, FloatArray, IntArray

ASSETS = Path(__file__).resolve().parents[1] / "assets"
ARAP_ITERATIONS = 100
# The soft band of an arm and the band in which its bend is looked for, half-widths in diagonals.
SOFT_REACH, BAND = 0.08, 0.1


@dataclass(frozen=True)
class Case:
    """One deformation: handles[h] moves by transforms[h], `fixed` stays.

    published: results of other methods by name. limb, joint: of a folded arm.
    """

    name: str
    V: FloatArray
    F: IntArray
    fixed: IntArray
    handles: list[IntArray]
    transforms: list[FloatArray]
    softness: FloatArray | None = None
    published: dict[str, FloatArray] = field(default_factory=dict)
    limb: Limb | None = None
    joint: float = 0.0

    @property
    def free(self) -> BoolArray:
        free = np.ones(len(self.V), dtype=bool)
        free[np.concatenate((self.fixed, *self.handles))] = False
        return free

    @property
    def diagonal(self) -> float:
        return float(np.linalg.norm(np.ptp(self.V, axis=0)))

    def deformer(self, **options: object) -> Deformer:
        return Deformer(self.V, self.F, self.fixed, self.handles, self.softness, **options)  # type: ignore[arg-type]

    def targets(self) -> tuple[IntArray, FloatArray]:
        """The constrained vertices and where they go."""
        goals = [self.V[self.fixed]]
        goals += [move(T, self.V[h]) for T, h in zip(self.transforms, self.handles, strict=True)]
        return np.concatenate((self.fixed, *self.handles)), np.concatenate(goals)

    def arap(self, iterations: int = ARAP_ITERATIONS) -> FloatArray:
        """libigl's as-rigid-as-possible, spokes and rims, from the biharmonic result."""
        held, goals = self.targets()
        data = igl.ARAPData()
        data.max_iter = iterations
        data.energy = igl.ARAPEnergyType.ARAP_ENERGY_TYPE_SPOKES_AND_RIMS
        igl.arap_precomputation(self.V, self.F, 3, held.astype(np.int32), data)
        X: FloatArray = igl.arap_solve(goals, data, self.harmonic())
        return X

    def harmonic(self, order: int = 2) -> FloatArray:
        """k-harmonic displacements."""
        held, goals = self.targets()
        D: FloatArray = igl.harmonic(self.V, self.F, held, goals - self.V[held], order)
        return self.V + D


def move(T: FloatArray, p: FloatArray) -> FloatArray:
    return np.asarray(p @ T[:3, :3].T + T[:3, 3])


def turn(axis: list[float], degrees: float, centre: list[float]) -> FloatArray:
    """(4, 4) the rotation about an axis through `centre`."""
    u = np.asarray(axis) / np.linalg.norm(axis)
    W = np.cross(np.eye(3), u)  # W v = u x v
    a = np.radians(degrees)
    T = np.eye(4)
    T[:3, :3] = R = np.eye(3) + np.sin(a) * W + (1 - np.cos(a)) * W @ W
    T[:3, 3] = np.asarray(centre) - R @ centre
    return T


def all_cases() -> Iterator[Case]:
    data = DEFAULT / "bs08"
    if data.is_dir():
        yield from (survey_case(data, name) for name in CASES)
    else:
        print(f"The survey's data are not in {data}: its two cases are left out.\n")
    yield bent_cylinder()
    yield twisted_bar()
    yield lifted_plane()
    yield bent_cactus()
    yield cactus_branch()
    yield folded_arm()
    yield mannequin()


def survey_case(folder: Path, name: str) -> Case:
    mesh = load_mesh(folder / f"00-{name}-original.off")
    status = np.loadtxt(folder / f"{name}.sel", comments="#").astype(np.int64)
    T = np.loadtxt(folder / f"{name}.def", comments="#").reshape(4, 4)
    known = {key: load_mesh(folder / f.format(name)).vertices for key, f in PUBLISHED.items()}
    fixed, handle = np.flatnonzero(status == 0), np.flatnonzero(status == 2)
    title = f"survey's {CASES[name]}"
    return Case(title, mesh.vertices, mesh.faces, fixed, [handle], [T], published=known)


def bent_cylinder(degrees: float = 120.0, rings: int | None = None) -> Case:
    """One end turned as if the axis had become an arc of its own length.

    rings: of triangles on the caps, for another resolution than the asset's 7.
    """
    V, F = cylinder(rings=rings) if rings else _asset("cylinder")
    fixed, handle = np.flatnonzero(V[:, 0] < -1.6), np.flatnonzero(V[:, 0] > 1.6)
    T = _arc([-1.6, 0, 0], [1.6, 0, 0], [0, 1, 0], degrees)
    return Case(f"cylinder, bend {degrees:.0f}", V, F, fixed, [handle], [T])


def _arc(start: list[float], end: list[float], side: list[float], degrees: float) -> FloatArray:
    """What carries the end of a beam that becomes an arc of its own length, towards `side`."""
    a = np.radians(degrees)
    first, axis = np.asarray(start, dtype=float), np.subtract(end, start)
    length = np.linalg.norm(axis)
    normal = np.cross(axis, side)
    there = np.sin(a) / a * axis + (1 - np.cos(a)) / a * length * np.asarray(side)
    T = turn(normal.tolist(), degrees, end)
    T[:3, 3] += first + there - end
    return T


def twisted_bar(degrees: float = 135.0) -> Case:
    V, F = _asset("bar")
    fixed, handle = np.flatnonzero(V[:, 0] < -1.6), np.flatnonzero(V[:, 0] > 1.6)
    T = turn([1, 0, 0], degrees, [0, 0, 0])
    return Case(f"bar, twist {degrees:.0f}", V, F, fixed, [handle], [T])


def lifted_plane() -> Case:
    """A border stays, a disc in the middle is lifted and not turned."""
    V, F = _asset("bumpy_plane")
    border = np.flatnonzero(np.abs(V[:, [0, 2]]).max(axis=1) > 0.93)
    middle = np.flatnonzero(np.hypot(V[:, 0], V[:, 2]) < 0.2)
    T = np.eye(4)
    T[1, 3] = 0.8
    return Case("bumpy plane, lifted", V, F, border, [middle], [T])


def bent_cactus() -> Case:
    """The top of the trunk turned by 70 degrees; both arms are free."""
    V, F = _asset("cactus")
    fixed, top = np.flatnonzero(V[:, 1] < 0.2), np.flatnonzero(V[:, 1] > 1.85)
    T = _arc([0, 0.2, 0], [0, 1.85, 0], [1, 0, 0], 70)
    return Case("cactus, trunk bent 70", V, F, fixed, [top], [T])


def cactus_branch() -> Case:
    """The tip of an arm turned outward by 90 degrees, with the trunk's top leaning away."""
    V, F = _asset("cactus")
    fixed = np.flatnonzero(V[:, 1] < 0.2)
    top = np.flatnonzero((V[:, 1] > 1.85) & (np.abs(V[:, 0]) < 0.3))
    tip = np.flatnonzero((V[:, 1] > 1.4) & (V[:, 0] > 0.4))
    lean, bend = turn([0, 0, 1], 30, [0, 0.9, 0]), turn([0, 0, 1], -90, [0.62, 1.1, 0.05])
    return Case("cactus, branches bent", V, F, fixed, [top, tip], [lean, bend])


def folded_arm(degrees: float = 120.0) -> Case:
    """The arm alone, folded at its elbow, softness around that (hinge)."""
    V, F = _asset("arm")
    joint, axis = 0.3705, np.zeros(2)
    fixed, hand = np.flatnonzero(V[:, 0] < 0.12), np.flatnonzero(V[:, 0] > 0.66)
    reach = SOFT_REACH * np.linalg.norm(np.ptp(V, axis=0))
    u = np.clip((V[:, 0] - joint) / reach, -1, 1)
    T = turn([0, 0, 1], degrees, [joint, 0, 0])
    limb = Limb(V, F, axis, (0.15, 0.63), 49)
    title = f"arm, folded {degrees:.0f}"
    return Case(title, V, F, fixed, [hand], [T], (1 - u * u) ** 2, limb=limb, joint=joint)


def mannequin(degrees: float = 120.0) -> Case:
    """The default session's arm, folded at its elbow."""
    V, F = _asset("mannequin")
    data = read_session(ASSETS / "mannequin-elbow.json").data
    softness = np.array(data["softness"])
    joint, axis = 0.465, np.array([1.425, -0.006])
    limb = Limb(V, F, axis, (0.28, 0.74), 47)
    T = turn([0, 0, 1], degrees, [joint, *axis])
    fixed, hand = np.array(data["fixed"]), np.array(data["handles"][0]["vertices"])
    title = f"mannequin's arm, folded {degrees:.0f}"
    return Case(title, V, F, fixed, [hand], [T], softness, limb=limb, joint=joint)


def _asset(name: str) -> tuple[FloatArray, IntArray]:
    mesh = load_mesh(ASSETS / f"{name}.obj")
    return mesh.vertices, mesh.faces
