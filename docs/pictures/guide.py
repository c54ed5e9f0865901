"""The window in user.md, one thing at a time."""

from __future__ import annotations

import os
import shutil
from datetime import datetime
from itertools import pairwise
from pathlib import Path

import numpy as np

from app.bundled import ASSETS, DEFAULT_MESH
from app.demo import DRAG, HAND, HAND_RADIUS, Point
from app.tools.gizmo.shape import RADIUS
from docs.pictures.first_minute import CHEST, FIGURE, LEFT_HAND, RAISED
from docs.pictures.scene import Scene, Seat, copies

ARM: tuple[Point, Point] = ((0.1, 1.3, 0.0), (1.0, 1.55, 0.0))  # corners of what is seen of it
UPPER_ARM: Point = (0.3, 1.42, 0.05)
WAIST_UP: tuple[Point, Point] = ((-0.95, 1.0, 0.0), (0.95, 1.85, 0.0))
AROUND_HEAD: tuple[Point, ...] = (
    (-0.2, 1.75, 0.0),
    (-0.12, 1.87, 0.0),
    (0.1, 1.87, 0.0),
    (0.2, 1.75, 0.0),
    (0.14, 1.58, 0.0),
    (-0.12, 1.56, 0.0),
)


def gizmo(seat: Seat) -> None:
    """A hand before it is turned and meanwhile, with the angle beside the mouse."""
    seat.person.key("5")
    seat.settle()
    ((x, y),) = seat.pixels([(0.86, 1.425, 0.0)])
    box = seat.around((0.2, 1.2, 0.0), (1.12, 1.66, 0.0))
    ring = [(x + RADIUS * np.cos(a), y - RADIUS * np.sin(a)) for a in np.radians([150, 165, 200])]
    seat.person.move(*ring[0])
    seat.settle()
    seat.shot("gizmo.png", box)
    seat.person.press()
    for place in ring[1:]:
        seat.person.move(*place)
    seat.settle()
    seat.shot("gizmo-turning.png", box)
    seat.person.release()


def lasso(seat: Seat) -> None:
    """A loop around the head, not closed yet."""
    seat.person.key("2")
    seat.person.choose("lasso", 0.1)
    path = seat.pixels(AROUND_HEAD)
    seat.person.move(*path[0])
    seat.person.press()
    for start, end in pairwise(path):
        for share in (0.25, 0.5, 0.75, 1.0):
            seat.person.move(*(np.array(start) + share * (np.array(end) - np.array(start))))
    seat.settle()
    seat.shot("lasso.png", seat.around((-0.45, 1.3, 0.0), (0.45, 1.85, 0.0)))
    seat.person.release()


def limb(seat: Seat) -> None:
    """An arm as the handle and all else fixed, after three clicks."""
    seat.person.key("3")
    seat.person.choose("limb", 0.1)
    seat.settle()
    seat.stroke(UPPER_ARM)
    seat.person.key("2")
    seat.person.choose("all else")
    seat.aside()
    seat.shot("limb.png", seat.around((-0.2, 1.3, 0.0), (0.96, 1.85, 0.0)))


def mirror(seat: Seat) -> None:
    """Both hands, dragged by one."""
    seat.person.key("5")
    seat.stroke(CHEST)
    seat.person.key("x")
    seat.person.key("3")
    seat.brush(HAND_RADIUS)
    seat.stroke(*HAND)
    seat.person.key("5")
    seat.settle()
    seat.stroke(LEFT_HAND, RAISED, steps=20)
    seat.person.key("1")
    seat.aside()
    seat.shot("mirror.png", seat.around(*WAIST_UP))


def poses(seat: Seat) -> None:
    """Two kept poses, and the slider halfway between rest and one of them."""
    person = seat.person
    for section in ("Tools", "Regions", "Soft parts"):
        person.choose(section, 0.3)
    person.key("5")
    seat.stroke(*DRAG, steps=20)
    person.choose("Keep pose")
    person.wait_still()
    person.choose("##pose")
    person.key("ctrl+a")
    person.type("arm up")
    person.key("Return")
    person.wait_still()
    person.drag([person.widget("##share", at) for at in (0.02, 0.5)])
    seat.aside()
    person.drag([(1100, 600), (770, 620)], button=3)
    seat.aside()
    seat.shot("poses.png", (0, 0, 850, 405))


def before_after(seat: Seat) -> None:
    """The rest shape beside what became of it."""
    seat.person.key("5")
    seat.stroke(*DRAG, steps=20)
    seat.person.open_section("View", "beside")
    seat.person.choose("beside")
    seat.person.key("1")
    seat.person.key("Home")
    seat.aside()
    seat.shot("before-after.png", (360, 225, 1150, 575))


def fill(seat: Seat) -> None:
    """A soft dab and two stiff ones, and what lies between them filled."""
    seat.person.key("4")
    seat.brush(0.05)
    for value, x in ((1, 0.465), (0, 0.25), (0, 0.7)):
        seat.value("##value", value)
        seat.stroke((x, 1.425, 0.03))
    seat.aside()
    seat.shot("fill-before.png", seat.around(*ARM))
    seat.person.choose("Fill")
    seat.aside()
    seat.shot("fill-after.png", seat.around(*ARM))


def question(seat: Seat) -> None:
    """A mesh is opened that was worked on before."""
    seat.aside()
    seat.shot("question.png", (400, 320, 880, 480))


def left_before(folder: Path) -> Path:
    """The mesh, and beside it a session of another day."""
    session = shutil.copy(ASSETS / "mannequin-elbow.json", folder / "mannequin.json")
    then = datetime(2026, 5, 4, 17, 30).timestamp()
    os.utime(session, (then, then))
    return Path(shutil.copy(DEFAULT_MESH, folder))


READY = copies(ASSETS / "mannequin-elbow.json", DEFAULT_MESH)  # the hand can be dragged at once

SCENES = (
    Scene(("lasso.png",), FIGURE, lasso),
    Scene(("limb.png",), FIGURE, limb),
    Scene(("mirror.png",), FIGURE, mirror),
    Scene(("gizmo.png", "gizmo-turning.png"), READY, gizmo),
    Scene(("fill-before.png", "fill-after.png"), FIGURE, fill),
    Scene(("poses.png",), READY, poses),
    Scene(("before-after.png",), READY, before_after),
    Scene(("question.png",), left_before, question),
)
