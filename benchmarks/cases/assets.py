"""Deformations of the meshes that come with the tool, and the survey's where it is there."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np

from app.model.session.reading import read_session
from assets.generator.elbow import SOFT_REACH
from assets.generator.figure import ARM_DEPTH, ARM_HEIGHT, ELBOW
from assets.generator.primitives import cylinder
from benchmarks.cases import survey
from benchmarks.cases.case import Case
from solver import load_mesh
from solver.geometry.bounding_box import diagonal
from solver.geometry.motions import rotation_about
from solver.geometry.topology import Topology
from solver.measure.sections import Limb
from solver.softness.falloff import falloff
from solver.types import FloatArray, IntArray

ASSETS = Path(__file__).resolve().parents[2] / "assets"


def all_cases() -> Iterator[Case]:
    data = survey.MESHES / "bs08"
    if data.is_dir():
        yield from (survey.survey_case(data, name) for name in survey.TITLES)
    else:
        print(f"The survey's data are not in {data}: its two cases are left out.\n")
    yield bent_cylinder()
    yield twisted_bar()
    yield lifted_plane()
    yield bent_cactus()
    yield cactus_branch()
    yield folded_arm()
    yield folded_mannequin()


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
    T = rotation_about(normal, degrees, end)
    T[:3, 3] += first + there - end
    return T


def twisted_bar(degrees: float = 135.0) -> Case:
    V, F = _asset("bar")
    fixed, handle = np.flatnonzero(V[:, 0] < -1.6), np.flatnonzero(V[:, 0] > 1.6)
    T = rotation_about([1, 0, 0], degrees)
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
    lean = rotation_about([0, 0, 1], 30, [0, 0.9, 0])
    bend = rotation_about([0, 0, 1], -90, [0.62, 1.1, 0.05])
    return Case("cactus, branches bent", V, F, fixed, [top, tip], [lean, bend])


def folded_arm(degrees: float = 120.0) -> Case:
    """The arm alone, folded at its elbow, softness around that (hinge)."""
    V, F = _asset("arm")
    joint, axis = 0.3705, np.zeros(2)
    fixed, hand = np.flatnonzero(V[:, 0] < 0.12), np.flatnonzero(V[:, 0] > 0.66)
    softness = falloff((V[:, 0] - joint) / (SOFT_REACH * diagonal(V)))
    T = rotation_about([0, 0, 1], degrees, [joint, 0, 0])
    limb = _limb(V, F, axis, (0.15, 0.63), 49)
    title = f"arm, folded {degrees:.0f}"
    return Case(title, V, F, fixed, [hand], [T], softness, limb=limb, joint=joint)


def folded_mannequin(degrees: float = 120.0) -> Case:
    """The default session's arm, folded at its elbow."""
    V, F = _asset("mannequin")
    data = read_session(ASSETS / "mannequin-elbow.json").data
    softness = np.array(data["softness"])
    joint, axis = ELBOW, np.array([ARM_HEIGHT, ARM_DEPTH])
    limb = _limb(V, F, axis, (0.28, 0.74), 47)
    T = rotation_about([0, 0, 1], degrees, [joint, *axis])
    fixed, hand = np.array(data["fixed"]), np.array(data["handles"][0]["vertices"])
    title = f"mannequin's arm, folded {degrees:.0f}"
    return Case(title, V, F, fixed, [hand], [T], softness, limb=limb, joint=joint)


def _asset(name: str) -> tuple[FloatArray, IntArray]:
    mesh = load_mesh(ASSETS / f"{name}.obj")
    return mesh.vertices, mesh.faces


def _limb(
    V: FloatArray, F: IntArray, axis: FloatArray, span: tuple[float, float], count: int
) -> Limb:
    """axis: (2,) y and z of the limb.  span: x from where to where.  count: of the sections."""
    near = np.linalg.norm(V[:, 1:] - axis, axis=1) < 0.5 * (span[1] - span[0])
    edges = Topology(F, len(V)).edges
    return Limb(V, edges[near[edges].all(axis=1)], np.linspace(*span, count))
