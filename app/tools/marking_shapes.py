"""How a press marks vertices, as a table: with a brush, a lasso, a box, or a limb at a click."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from app.model.history import Gesture
from app.scene.overlay import NOTHING, Overlay
from app.tools.loops import Box, Loop
from app.tools.marks import Mark, Marks
from app.tools.strokes import Stroke
from app.tools.tool import NEAR_SURFACE, Begin, Cursor, brush_cursor
from app.tools.whole_parts import begin_part
from app.viewpoint.events import Input
from app.workspace.interaction import Interaction
from app.workspace.nearby import near_surface
from app.workspace.workspace import Workspace


@dataclass(frozen=True)
class Shape:
    """One row of the table.

    begin: what a press starts; None leaves it to the camera.  tip: what it is for.
    cursor: what shows where it would act.  loops: whether what is hidden may be taken or not.
    """

    begin: Callable[[Workspace, Input, Marks], Interaction | None]
    tip: str
    cursor: Cursor
    loops: bool = False


def begin_marking(marks: Marks) -> Begin:
    """What a press of a tool starts that marks so; a double click takes a part.

    The first click of a double click has marked something of its own, which is taken back.
    """

    def begin(work: Workspace, press: Input) -> Interaction | None:
        again = press.clicks % 2 == 0 and work.under(press) is not None
        if again:
            work.take_back(work.before_press)
        return (begin_part if again else SHAPES[work.marking.shape].begin)(work, press, marks)

    return begin


def marking_cursor(work: Workspace, frame: Input) -> Overlay:
    """What shows where the tools that mark would act."""
    return SHAPES[work.marking.shape].cursor(work, frame)


def _begin_stroke(work: Workspace, press: Input, marks: Marks) -> Interaction | None:
    """On the surface, or a few pixels beside it."""
    hit = near_surface(work, press, NEAR_SURFACE)
    if hit is None:
        return None
    gesture = Gesture(work.document)
    paint, mirror = marks.paint(work, press.shift, gesture), None
    if work.symmetry is not None and not press.shift:
        image = work.symmetry.hit(hit, work.positions)
        radius = work.brush_radius(hit.position, press.camera)
        meets = image is None or np.linalg.norm(image.position - hit.position) < radius
        mirror = marks.across(work, gesture, bool(meets))
    return Stroke(work, press, hit, gesture, paint, mirror)


def _begin_limb(work: Workspace, press: Input, marks: Marks) -> Interaction | None:
    """The smallest limb around the click that is not marked yet, or not erased yet."""
    hit = work.under(press)
    if hit is None:
        return None
    done = marks.marked(work) != press.shift
    for limb in work.limbs.at(hit.vertex).around(hit.vertex):
        if not done[limb].all():
            return Mark(work, press, marks, np.flatnonzero(limb))
    work.say("There is no limb to take here, or no larger one: click nearer to a tip")
    return Mark(work, press, marks, np.empty(0, dtype=np.int64))


def _loop_cursor(work: Workspace, frame: Input) -> Overlay:
    loop = work.interaction
    return Overlay((loop.outline(frame.camera),)) if isinstance(loop, Loop) else NOTHING


SHAPES = {
    "brush": Shape(_begin_stroke, "Paint on the surface", brush_cursor),
    "lasso": Shape(Loop, "Draw a loop around it", _loop_cursor, loops=True),
    "box": Shape(Box, "Draw a box around it", _loop_cursor, loops=True),
    "limb": Shape(
        _begin_limb,
        "Click on a hand, a leg, a head; once more takes more",
        lambda work, frame: NOTHING,
    ),
}
