"""What the paper could not do: rotations, softness from a few dabs, a grab anywhere."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from app.figures.arm import ELBOW, JOINT, Arm, turn
from app.figures.figure import Figure, soft
from app.figures.measures import ArmMeasures, Numbers
from app.workspace.color_maps import FIXED_COLOR, viridis
from solver import Deformer, interpolate_softness
from solver.geometry.motions import moved
from solver.geometry.procrustes import rigid_motion
from solver.softness.checks import check_softness
from solver.softness.falloff import falloff
from solver.types import BoolArray, FloatArray

FOLD = 120.0  # degrees
LEVELS = {"13a": 0, "13b": 1, "13c": 4}
BEST = 4  # the highest level in use
# Dabs of the softness brush: place along x, front (1) or back (-1), value.
DABS = ((ELBOW, 1, 1.0), (ELBOW, -1, 1.0), *((x, z, 0.0) for x in (0.34, 0.6) for z in (1, -1)))
DAB_RADIUS = 0.03
GRABBED, GRAB_RADIUS = np.array([0.86, 1.425, 0.0]), 0.11
PULL = np.array([-0.22, 0.34, 0.05])


def beyond_the_paper(arm: Arm) -> Iterator[Figure]:
    """Figures 13 to 15."""
    yield from _levels(arm)
    yield from _dabs(arm)
    yield _grab(arm)


def _levels(arm: Arm) -> Iterator[Figure]:
    measure = ArmMeasures(arm)
    deformer = Deformer(
        arm.V, arm.F, arm.fixed, [arm.hand], arm.softness(arm.V[:, 0]), material="hinge"
    )
    for number, rigid in LEVELS.items():
        X = deformer.pose([turn(FOLD, JOINT)], rigid)
        n = measure(X)
        yield Figure(
            number,
            f"Hinge material, rigid {rigid}",
            f"{FOLD:.0f} degrees, bending x0.1 at the elbow. {n['bend_in_soft_part']:.0%} of the "
            f"bend lies in the soft part, the elbow's section keeps {n['elbow_section']:.0%} of "
            f"its area, the arm {n['volume']:.0%} of its volume; edge strain rms "
            f"{n['strain_rms']:.3f}.",
            X,
            soft(arm),
            "elbow",
            n,
            _settings(rigid, FOLD),
        )


def _dabs(arm: Arm) -> Iterator[Figure]:
    pins, values = _pinned(arm)
    s = interpolate_softness(arm.V, arm.F, np.flatnonzero(pins), values[pins])
    yield _field(arm, pins, s)
    yield _folded(arm, s)


def _field(arm: Arm, pins: BoolArray, s: FloatArray) -> Figure:
    painted, filled = int(pins.sum()), int((~pins & arm.free).sum())
    jump, body = check_softness(arm.edges, s, "hinge").jump, float(s[arm.fixed].mean())
    return Figure(
        "14a",
        "Softness from six dabs",
        f"Two soft dabs on the elbow and four stiff ones around it, {painted} vertices (dots); "
        f"the harmonic field fills the other {filled} of the arm. It stays in "
        f"[{s.min():g}, {s.max():g}] and differs along an edge by {jump:.2f} at most. Between the "
        f"stiff dabs a little gets past: {body:.2f} on the body.",
        arm.V,
        viridis(s),
        "arm",
        {
            "dabs": len(DABS),
            "painted": painted,
            "filled": filled,
            "least": float(s.min()),
            "most": float(s.max()),
            "steepest": jump,
            "body": body,
        },
        pins=pins,
    )


def _folded(arm: Arm, s: FloatArray) -> Figure:
    X = Deformer(arm.V, arm.F, arm.fixed, [arm.hand], s).pose([turn(FOLD, JOINT)], BEST)
    n = ArmMeasures(arm)(X)
    return Figure(
        "14b",
        "Folded with the softness of six dabs",
        f"{FOLD:.0f} degrees, hinge, rigid {BEST}: {n['bend_in_soft_part']:.0%} of the bend "
        f"gathers at the elbow, whose section keeps {n['elbow_section']:.0%} of its area; no "
        f"dihedral angle has changed by more than {n['largest_jump']:.0f} degrees.",
        X,
        viridis(s),
        "arm",
        n,
        _settings(BEST, FOLD),
    )


def _pinned(arm: Arm) -> tuple[BoolArray, FloatArray]:
    """(n,) what the dabs touch, and the value they give it."""
    pins, values = np.zeros(len(arm.V), dtype=bool), np.zeros(len(arm.V))
    limb = np.abs(arm.V - JOINT)[:, 1:].max(axis=1) < 0.1
    for x, side, value in DABS:
        ring = limb & (np.abs(arm.V[:, 0] - x) < DAB_RADIUS)
        centre = [x, JOINT[1], arm.V[ring, 2].max() if side > 0 else arm.V[ring, 2].min()]
        touched = np.linalg.norm(arm.V - centre, axis=1) < DAB_RADIUS
        pins |= touched
        values[touched] = value
    return pins, values


def _grab(arm: Arm) -> Figure:
    weights = falloff(np.linalg.norm(arm.V - GRABBED, axis=1) / GRAB_RADIUS)
    deformer = Deformer(arm.V, arm.F, arm.fixed).grab(weights)
    T = deformer.orient(0, GRABBED, GRABBED + PULL, [np.eye(4)])
    X = deformer.pose([T], BEST)
    n = _grip(arm, weights, T, X) | ArmMeasures(arm)(X)
    colors = viridis(0.5 + 0.5 * np.sqrt(weights / weights.max()))
    colors[arm.fixed] = FIXED_COLOR
    return Figure(
        "15",
        "Grabbed anywhere",
        f"Nothing is painted on the hand. One dab takes hold of {n['grabbed']} vertices (yellow "
        f"at its centre) and pulls them up; the hand turns by {n['turn']:.0f} degrees of itself. "
        f"The dab's affine fit is where it was asked to be to {n['moments_missed']:.0e}; within "
        f"it the surface gives by {n['give']:.3f}. Edge strain rms of the arm: "
        f"{n['strain_rms']:.3f}.",
        X,
        colors,
        "arm",
        n,
        {"rigid": BEST, "target": (GRABBED + PULL).tolist()},
    )


def _grip(arm: Arm, weights: FloatArray, T: FloatArray, X: FloatArray) -> Numbers:
    """How well a grab holds: sizes in world units, the turn in degrees."""
    held = weights > 0
    rest, now = arm.V[held], X[held]
    J, root = np.column_stack([rest, np.ones(len(rest))]), np.sqrt(weights[held])[:, None]
    fit = np.linalg.lstsq(root * J, root * now, rcond=None)[0]
    apart = np.linalg.norm(moved(rigid_motion(rest, now), rest) - now, axis=1)
    cosine = np.clip((np.trace(T[:3, :3]) - 1) / 2, -1, 1)
    return {
        "grabbed": int(held.sum()),
        "moments_missed": float(np.abs(fit - T[:3].T).max()),
        "turn": float(np.degrees(np.arccos(cosine))),
        "give": float(apart.max()),
        "fixed_moved": float(np.abs(X - arm.V)[arm.fixed].max()),
    }


def _settings(rigid: int, degrees: float) -> dict[str, object]:
    return {"degrees": degrees, "material": "hinge", "bending_length": 0.01, "rigid": rigid}
