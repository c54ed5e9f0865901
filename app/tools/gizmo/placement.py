"""Turning or moving handles exactly, by the cursor or a typed number."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import ClassVar

import numpy as np

from app.model.handles import NO_TURN, Handle, Pose
from app.model.history import Gesture
from app.scene.overlay import Label, Overlay
from app.tools.gizmo.freedoms import (
    Freedom,
    MoveAcross,
    MoveAlong,
    TurnAbout,
    round_step,
)
from app.tools.gizmo.number import Number
from app.tools.gizmo.shape import axis_line, turn_circle
from app.tools.lateness import follow_late
from app.viewpoint.camera import Camera, Pixel
from app.viewpoint.events import Input
from app.workspace.operator import Operator
from app.workspace.placing import axes_of
from app.workspace.workspace import Workspace
from solver.geometry.turns import nearest_turn, turned_by
from solver.types import FloatArray

AxisFreedom = Callable[[FloatArray, FloatArray, str], Freedom]
# What an axis that is named while it goes on is for.
ALONG: dict[str, AxisFreedom] = {"Move": MoveAlong, "Turn": TurnAbout}
LOCKS = ("world", "local", "")  # the axes meant by a letter typed once, twice, three times


class Placement(Operator):
    """Turns or moves the selected handles as one.

    Each frame adds what the cursor went since the last one, so that whole turns count and the
    camera may move meanwhile.
    """

    drags: ClassVar[bool] = True

    def __init__(
        self,
        work: Workspace,
        kind: str,
        freedom: Freedom,
        pivot: FloatArray,
        start: Pixel | None,
        modal: bool,
    ) -> None:
        """kind: one of ALONG.  start: where the cursor is, None while it is elsewhere."""
        self._work, self._kind, self._pivot, self.modal = work, kind, pivot, modal
        self._free = self._freedom = freedom
        self._handles = work.selected
        self._before = work.document.pose
        self._gesture = Gesture(work.document)
        self._step = round_step(work.document.diagonal)
        self._start = self._last = start
        self._value: FloatArray = np.zeros(3)
        self._number = Number()
        self._snaps = False
        self._camera = work.viewpoint.camera
        self._letter, self._times = "", 0
        self._done: tuple[object, ...] = ()

    def move(self, frame: Input) -> None:
        """Follow the cursor, round values with Ctrl; while the camera moves it is not followed."""
        self._camera, self._snaps = frame.camera, frame.ctrl
        if frame.pixel is None:
            return
        if self._last is None or frame.middle or frame.wheel:
            self._start = self._last = frame.pixel
        else:
            way = self._freedom.way(frame.camera, self._last, frame.pixel)
            if way is not None:
                self._value, self._last = self._value + way, frame.pixel
        self._apply()

    def type(self, keys: str) -> None:
        """x, y and z lock an axis, anything else is part of a number."""
        for key in keys:
            if key in "xyz":
                self._lock(key)
            else:
                self._number = self._number.after(key)
        self._apply()

    def finish(self) -> None:
        """Keep it as one entry of the history."""
        moved = self._gesture.started
        self._work.history.record(self._gesture.finish(label_of(self._kind, self._handles)))
        if moved:
            follow_placed(self._work, self._handles, self._kind)

    def cancel(self) -> None:
        """Put the handles back."""
        self._gesture.cancel()

    def overlay(self, frame: Input) -> Overlay:
        """The axis, and how far beside the cursor."""
        freedom, value = self._result()
        size = self._number.text if self._typed else freedom.size(value)
        text = f"{freedom.name} {size}{freedom.unit}".strip()
        labels = () if frame.pixel is None else (Label(text, frame.pixel),)
        pivot = self._work.pivot
        assert pivot is not None
        line = axis_line(freedom, pivot, self._work.document.diagonal)
        return Overlay((*line, *turn_circle(freedom, pivot, self._work.viewpoint.camera)), labels)

    @property
    def _typed(self) -> bool:
        return self._number != Number()

    def _lock(self, name: str) -> None:
        """Along this axis of the world, named again of the handle, and then as it began."""
        self._times = self._times + 1 if name == self._letter else 0
        self._letter = name
        self._freedom = self._free
        if axes := LOCKS[self._times % len(LOCKS)]:
            transform = self._before.of(self._handles[0].key)
            axis = axes_of(axes, transform, self._camera)["xyz".index(name)]
            self._freedom = ALONG[self._kind](self._pivot, axis, name)
        way = None
        if self._start is not None and self._last is not None:
            way = self._freedom.way(self._camera, self._start, self._last)
        self._value = np.zeros(3) if way is None else way

    def _result(self) -> tuple[Freedom, FloatArray]:
        """What is done and how far: as typed, else round, else as the cursor went."""
        number = self._number.value
        if number is not None:
            exact = self._freedom.exact
            assert exact.axis is not None
            return exact, number * exact.axis
        if self._snaps:
            return self._freedom, self._freedom.snapped(self._value, self._step)
        return self._freedom, self._value

    def _apply(self) -> None:
        work, (freedom, value) = self._work, self._result()
        asked = (freedom, *value, work.surface.bound, work.placing.pivot, work.symmetry)
        if asked == self._done:  # nothing has changed
            return
        self._done, pose = asked, self._before
        if value.any():
            turn = np.radians(value) if self._kind == "Turn" else NO_TURN
            pose = placed(work, pose, freedom.motion(value), self._kind, turn)
        if pose != work.document.pose:
            self._gesture.change("pose", pose)


def placed(
    work: Workspace, pose: Pose, T: FloatArray, kind: str, turn: FloatArray | None = None
) -> Pose:
    """The pose with the selected handles moved by T (4, 4); turned ones may find their place.

    turn: (3,) in radians, the way round to T; without one the shorter way.
    """
    keys = [handle.key for handle in work.selected]
    way = nearest_turn(T[:3, :3], NO_TURN) if turn is None else turn
    for key in keys:
        pose = pose.moved(key, T @ pose.of(key), turned_by(pose.turn(key), way))
    pose = work.mirrored(pose, keys)
    return _followed(work, pose, keys) if _follows(work, kind) else pose


def follow_placed(work: Workspace, handles: Sequence[Handle], kind: str) -> None:
    """Say so where the surface has yet to follow handles that were kept at a place before a bind.

    Turned ones find their place when it is there.
    """
    keys = [handle.key for handle in handles if handle.key in work.handle_centres]
    if not all(map(work.surface.holds, keys)):
        pose = (lambda: _followed(work, work.document.pose, keys)) if _follows(work, kind) else None
        follow_late(work, keys, pose)


def _follows(work: Workspace, kind: str) -> bool:
    return kind == "Turn" and work.placing.pivot == "free"


def _followed(work: Workspace, pose: Pose, keys: Sequence[int]) -> Pose:
    """Both sides of a mirror find their places together, and are mirror images afterwards."""
    across = [work.symmetry.handle(work.document, key) for key in keys] if work.symmetry else []
    both = {*keys, *(key for key in across if key is not None)}
    return work.mirrored(work.surface.placed(pose, both), keys)


def label_of(kind: str, handles: Sequence[Handle]) -> str:
    """Of an entry of the history."""
    return f"{kind} {handles[0].name if len(handles) == 1 else f'{len(handles)} handles'}"


def free_freedom(kind: str, pivot: FloatArray, camera: Camera, axes: FloatArray) -> Freedom:
    """What an operator does until an axis is named: in the plane of the view."""
    if kind == "Turn":
        return TurnAbout(pivot, -camera.forward, "view")
    across = np.stack([camera.right, camera.up])
    return MoveAcross(pivot, across, MoveAlong(pivot, axes[0], "x"))
