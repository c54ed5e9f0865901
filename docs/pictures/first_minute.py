"""The window in README.md: the walkthrough, pins, a character of pieces, a large mesh."""

from __future__ import annotations

from pathlib import Path

import igl
import numpy as np

from app.bundled import ASSETS, DEFAULT_MESH
from app.demo import (
    BODY,
    BODY_RADIUS,
    DRAG,
    ELBOW,
    ELBOW_RADIUS,
    HAND,
    HAND_RADIUS,
    Point,
)
from docs.pictures.scene import Scene, Seat, copies
from solver import Mesh, load_mesh

# Clicked in turn; then some of them are dragged, with nothing painted.
CHEST: Point = (0.0, 1.25, 0.13)
LEFT_HAND: Point = (0.85, 1.425, 0.02)
RIGHT_HAND: Point = (-0.85, 1.425, 0.02)
FEET: tuple[Point, Point] = ((0.13, 0.05, 0.12), (-0.13, 0.05, 0.12))
RAISED: Point = (0.62, 1.78, 0.02)


def walkthrough(seat: Seat) -> None:
    """The window after each step."""
    for number, (tool, radius, paths) in enumerate(
        (("2", BODY_RADIUS, BODY), ("3", HAND_RADIUS, [HAND]), ("4", ELBOW_RADIUS, [ELBOW])), 1
    ):
        seat.person.key(tool)
        seat.brush(radius)
        for path in paths:
            seat.stroke(*path)
        seat.shot(f"step-{number}.png")
    seat.person.key("5")
    seat.stroke(*DRAG, steps=20)
    seat.shot("step-4.png")


def pins(seat: Seat) -> None:
    """Some clicks and drags, with nothing painted."""
    seat.person.key("5")
    for place in (CHEST, LEFT_HAND, RIGHT_HAND, *FEET):
        seat.stroke(place)
    seat.stroke(LEFT_HAND, RAISED, steps=20)
    seat.stroke(RIGHT_HAND, (-0.58, 1.08, 0.02), steps=20)
    seat.stroke(FEET[0], (0.42, 0.32, 0.12), steps=20)
    seat.shot("window-pins.png")


def dressed(seat: Seat) -> None:
    """A character of many pieces, its hand dragged."""
    seat.person.key("5")
    seat.settle(3.0)
    seat.stroke(*DRAG, steps=20)
    seat.shot("window-dressed.png")


def large(seat: Seat) -> None:
    """Half a million vertices, held at the chest and dragged at a hand."""
    seat.person.choose("5 Drag")
    seat.settle(4.0)
    for place in (CHEST, LEFT_HAND):
        seat.stroke(place)
        seat.settle(4.0)
    seat.stroke(LEFT_HAND, RAISED, steps=20)
    seat.follows(RAISED)
    seat.shot("window-large.png")


def refined(folder: Path) -> Path:
    """The mannequin in more than half a million vertices."""
    mesh = load_mesh(DEFAULT_MESH)
    V, F = np.array(mesh.vertices), np.array(mesh.faces)
    for _ in range(3):
        V, F = igl.loop(V, F)
    Mesh.from_arrays(V, F).save(folder / "large.obj", V)
    return folder / "large.obj"


FIGURE = copies(DEFAULT_MESH)
DRESSED = copies(ASSETS / "dressed-elbow.json", ASSETS / "dressed.obj")

SCENES = (
    Scene(("step-1.png", "step-2.png", "step-3.png", "step-4.png"), FIGURE, walkthrough),
    Scene(("window-pins.png",), FIGURE, pins),
    Scene(("window-dressed.png",), DRESSED, dressed),
    Scene(("window-large.png",), refined, large),
)
