"""The mouse in one frame: who has it, the tool in the hand, an operator, or the camera."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from app.editor.commands import SetBrush
from app.pointing.brush import RADIUS_STEP
from app.scene.overlay import NOTHING, Overlay
from app.tools.table import TOOLS
from app.viewpoint.events import ENTER, Input
from app.viewpoint.viewpoint import Motion
from app.workspace.operator import Operator
from app.workspace.workspace import Workspace
from solver.types import FloatArray


class Hand:
    """Begins, moves and ends what a person does with the mouse in one workspace."""

    def __init__(self, work: Workspace) -> None:
        self._work = work
        self._left: Motion | None = None  # what the button that is down does to the camera
        self._refusing = False  # the secondary button is down that took an operator back

    def advance(self, frame: Input) -> None:
        """A stroke, a drag or an operator goes on by a frame, begins or ends."""
        work = self._work
        self._refusing = self._refusing and frame.secondary
        operator = work.interaction
        if isinstance(operator, Operator) and (operator.modal or not frame.pressed):
            self._operate(operator, frame)
            return
        if frame.pressed:
            work.finish()  # a release that nobody saw
            before = work.moment
            self._begin(frame)
            work.before_press = before
        elif work.interaction is not None and (frame.down or frame.released):
            work.interaction.move(frame)
        if work.interaction is None and frame.released:
            work.history.seal()  # a slider was let go: the next slide is an entry of its own
        if not frame.down:
            self._touch(frame)
            self._left = None
            work.finish()

    def look(self, frame: Input) -> None:
        """Move the camera."""
        seen = replace(frame, secondary=False) if self._refusing else frame
        self._work.viewpoint.advance(seen, self._left, lambda: self._point(frame))

    def resize_brush(self, frame: Input, execute: Callable[[SetBrush], None]) -> None:
        """The wheel with Ctrl resizes the brush of a tool that has one."""
        work = self._work
        if frame.wheel and frame.ctrl and TOOLS[work.tool].marks is not None:
            execute(SetBrush(radius=work.brush.radius * RADIUS_STEP**frame.wheel))

    def cursor(self, frame: Input) -> Overlay:
        """What shows where it would act."""
        work = self._work
        if isinstance(work.interaction, Operator):
            return work.interaction.overlay(frame)
        cursor = TOOLS[work.tool].cursor
        return NOTHING if cursor is None else cursor(work, frame)

    def _operate(self, operator: Operator, frame: Input) -> None:
        """An operator follows the cursor and hears the keys until it is kept or taken back."""
        if operator.modal and frame.secondary:
            self._refusing = True
            self._work.cancel()
            return
        if frame.typed:
            operator.type(frame.typed)
        operator.move(frame)
        done = frame.pressed if operator.modal else not frame.down
        if done or ENTER in frame.typed:
            self._work.finish()

    def _begin(self, frame: Input) -> None:
        """A press over the scene is the tool's, else it moves the camera."""
        work = self._work
        if frame.pixel is None:
            return
        begin = TOOLS[work.tool].begin
        if begin is not None and not frame.alt:
            work.interaction = begin(work, frame)
        if work.interaction is None:
            self._left = "pan" if frame.shift and not frame.alt else "orbit"
        else:
            self._touch(frame)

    def _touch(self, frame: Input) -> None:
        """The view turns about the point that a stroke or drag last touched."""
        point = self._point(frame) if self._work.interaction is not None else None
        if point is not None:
            self._work.viewpoint.pivot = point

    def _point(self, frame: Input) -> FloatArray | None:
        """Of the surface, under the cursor."""
        hit = self._work.under(frame)
        return None if hit is None else hit.position
