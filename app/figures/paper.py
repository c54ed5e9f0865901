"""Figures 4 to 12 of the paper, by its own linear method (rigid 0)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import asdict

import numpy as np

from app.figures.arm import JOINT, REACH, SHOULDER, WRIST, Arm, Gains, turn
from app.figures.figure import Figure, plain, regions, soft
from app.figures.measures import ArmMeasures, Numbers
from solver import PRESETS, fundamental_forms, reconstruct
from solver.geometry.bounding_box import diagonal, middle
from solver.geometry.frames import triangle_frames
from solver.geometry.motions import moved, rotation
from solver.geometry.procrustes import rigid_motion
from solver.types import FloatArray

# The paper weighs bending by a length of about six radii of its arm: so is this, in diagonals.
BENDING_LENGTH = 0.1
# It turns the hand about a point near the outer side of the arm, so that the elbow is compressed.
PIVOT = JOINT - [0.0, 0.04, 0.0]
FOLD, MORE = 50.0, 70.0  # degrees, the paper's
STRETCH = 0.2  # world units that the hand is pulled away by
NONE = Gains()
PAPER = Gains(PRESETS["paper"].bending, PRESETS["paper"].stretching)
STEP, SMOOTH_STEP = Gains(2.0, 0.1, step=True), Gains(2.0, 0.1)
TOO_SOFT = Gains(100.0, 0.01)
FOLDS = {
    "08": (PAPER, FOLD),
    "09": (PAPER, MORE),
    "10": (NONE, MORE),
    "11": (STEP, MORE),
    "12": (TOO_SOFT, MORE),
}


def of_the_paper(arm: Arm) -> Iterator[Figure]:
    """Figures 4 to 12."""
    yield _original(arm)
    yield _reconstruction(arm)
    yield _handles(arm)
    yield _stretched(arm)
    yield from _folds(arm)


def _original(arm: Arm) -> Figure:
    return Figure(
        "04",
        "The original mesh",
        f"The mannequin, {len(arm.V)} vertices and {len(arm.F)} triangles, as it comes from its "
        "file.",
        arm.V,
        plain(arm),
        "figure",
        {"vertices": len(arm.V), "triangles": len(arm.F)},
    )


def _reconstruction(arm: Arm) -> Figure:
    centre = middle(arm.V)
    R = turn(30.0, centre)[:3, :3] @ rotation([0, 1, 0], 40.0)
    X = reconstruct(
        arm.F,
        fundamental_forms(arm.V, arm.F),
        seed_frame=R @ triangle_frames(arm.V[arm.F[:1]]).axes[0],
        seed_position=R @ (arm.V[arm.F[0, 0]] - centre) + centre,
    )
    size = diagonal(arm.V)
    apart = np.linalg.norm(moved(rigid_motion(arm.V, X), arm.V) - X, axis=1).max() / size
    away = np.linalg.norm(X - arm.V, axis=1).max() / size
    return Figure(
        "05",
        "Reconstructed from its fundamental forms",
        "Rebuilt from edge lengths and dihedral angles alone, from another seed frame and "
        f"position. It lies elsewhere (by up to {away:.2f} diagonals) and is the same surface: "
        f"after rigid alignment no vertex is further off than {apart:.1e} diagonals.",
        X,
        plain(arm),
        "figure",
        {"moved": float(away), "distance_after_alignment": float(apart)},
    )


def _handles(arm: Arm) -> Figure:
    return Figure(
        "06",
        "The handles",
        f"Fixed, dark purple: {len(arm.fixed)} vertices. Movable, bright yellow: {len(arm.hand)} "
        f"vertices of the hand. The {int(arm.free.sum())} between are free.",
        arm.V,
        regions(arm),
        "arm",
        {"fixed": len(arm.fixed), "handle": len(arm.hand), "free": int(arm.free.sum())},
    )


def _stretched(arm: Arm) -> Figure:
    T = np.eye(4)
    T[0, 3] = STRETCH
    X = arm.deformer(NONE, BENDING_LENGTH).pose([T])
    moved = np.abs(X - arm.V)[arm.fixed].max()
    missed = np.abs(X - arm.V - T[:3, 3])[arm.hand].max()
    length = 1 + STRETCH / (WRIST - SHOULDER)
    numbers = {"arm_length": length, "fixed_moved": float(moved), "hand_off_target": float(missed)}
    numbers |= ArmMeasures(arm)(X)
    return Figure(
        "07",
        "The arm stretched",
        f"The hand is pulled away and the arm follows: {length:.2f} times as long between its "
        f"handles. Fixed vertices have moved by {moved:g}, the hand is {missed:.0e} off its "
        f"target; the elbow keeps {numbers['elbow_width']:.0%} of its width.",
        X,
        regions(arm),
        "arm",
        numbers,
        _settings(NONE, 0.0),
    )


def _folds(arm: Arm) -> Iterator[Figure]:
    measure = ArmMeasures(arm)
    deformer = arm.deformer(NONE, BENDING_LENGTH)

    def fold(gains: Gains, degrees: float) -> tuple[FloatArray, Numbers]:
        bound = deformer.rebind(edge_gains=arm.edge_gains(gains))
        X = bound.pose([turn(degrees, PIVOT)])
        return X, measure(X)

    found = {number: fold(gains, degrees) for number, (gains, degrees) in FOLDS.items()}
    smooth = fold(SMOOTH_STEP, MORE)[1]
    found["11"][1]["rim_jump_if_smooth"] = smooth["rim_jump"]
    for number, (X, numbers) in found.items():
        gains, degrees = FOLDS[number]
        title, caption = CAPTIONS[number]
        words = {"n": numbers, "soft": found["09"][1], "plain": found["10"][1], "smooth": smooth}
        yield Figure(
            number,
            title,
            caption.format(**words, reach=REACH, angle=degrees),
            X,
            regions(arm) if gains is NONE else soft(arm, gains.step),
            "elbow",
            numbers,
            _settings(gains, degrees),
        )


def _settings(gains: Gains, degrees: float) -> dict[str, object]:
    return {
        "degrees": degrees,
        "gains": asdict(gains),
        "bending_length": BENDING_LENGTH,
        "orientation": True,
        "rigid": 0,
    }


CAPTIONS = {
    "08": (
        "The arm folded, with material",
        "The hand has turned by {angle:.0f} degrees; bright yellow is softest (bending x2, "
        "stretching x0.5), dark purple is held or rigid. The inner side of the elbow keeps "
        "{n[inner_side]:.0%} of its area, the elbow {n[elbow_width]:.0%} of its width, and at the "
        "rim of the soft part dihedral angles change by {n[rim_jump]:.0f} degrees at most.",
    ),
    "09": (
        "The arm folded more, with material",
        "{angle:.0f} degrees, the material of figure 8. The inner side gives way: "
        "{n[inner_side]:.1%} of its area is left, against {plain[inner_side]:.1%} without material "
        "(figure 10), and the elbow is {n[elbow_width]:.1%} as wide as at rest, against "
        "{plain[elbow_width]:.1%}. The arm keeps {n[volume]:.0%} of its volume "
        "({plain[volume]:.0%}).",
    ),
    "10": (
        "The arm folded more, without material",
        "The same {angle:.0f} degrees. The elbow is wider than with material "
        "({n[elbow_width]:.1%} of rest against {soft[elbow_width]:.1%}) and its inner side keeps "
        "more of its area ({n[inner_side]:.1%} against {soft[inner_side]:.1%}). The difference is "
        "small, and the narrowest section of the soft part does not show it "
        "({n[narrowest_section]:.1%} against {soft[narrowest_section]:.1%}). Nothing is wider "
        "than at rest, as the paper sees it: no section of the soft part is wider or deeper than "
        "{n[widest_section]:.1%} of rest. A linear method leaves the axis of the fold alone and "
        "shrinks the surface across it.",
    ),
    "11": (
        "A material that ends in a step",
        "Bending x2 and stretching x0.1 within {reach:g} of the elbow, none beyond. At the rim "
        "dihedral angles change by up to {n[rim_jump]:.0f} degrees: a crease. With the same gains "
        "in the smooth field of figure 9 it is {smooth[rim_jump]:.0f} degrees, with figure 9's own "
        "{soft[rim_jump]:.0f}.",
    ),
    "12": (
        "Too soft a material",
        "Bending x100 and stretching x0.01, smooth. The arm is sheared off at the elbow, whose "
        "section keeps {n[elbow_section]:.0%} of its area (figure 9: {soft[elbow_section]:.0%}); "
        "{n[edges_folded_over]:.0f} edges have bent by more than 90 degrees, the most by "
        "{n[largest_jump]:.0f}, and a triangle is left with {n[least_triangle]:.0%} of its area.",
    ),
}
