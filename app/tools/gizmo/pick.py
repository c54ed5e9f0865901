"""Picking the point that a handle turns about."""

from __future__ import annotations

from dataclasses import replace

from app.pointing.picking import Hit
from app.scene.overlay import NOTHING, Label, Overlay
from app.viewpoint.events import Input
from app.workspace.operator import Operator
from app.workspace.workspace import Workspace
from solver.geometry.motions import moved_back


class PickPivot(Operator):
    """The next click on the surface is the pivot of the active handle, and moves with it."""

    def __init__(self, work: Workspace) -> None:
        self._work = work
        self._hit: Hit | None = None

    def move(self, frame: Input) -> None:
        """Remember what the cursor points at."""
        self._hit = self._work.under(frame)

    def finish(self) -> None:
        """Take that point; beside the surface nothing changes."""
        work, hit = self._work, self._hit
        if hit is None or work.active is None:
            return
        key, rest = work.active.key, work.document.surface_number
        point = moved_back(work.document.pose.of(key), hit.position)
        points = {**work.placing.points, (key, rest): point}
        work.placing = replace(work.placing, pivot="point", points=points)

    def cancel(self) -> None:
        """Keep the pivot as it was."""

    def type(self, keys: str) -> None:
        """Nothing can be typed."""

    def overlay(self, frame: Input) -> Overlay:
        """What to do."""
        if frame.pixel is None:
            return NOTHING
        return Overlay(labels=(Label("Click the point to turn about", frame.pixel),))
