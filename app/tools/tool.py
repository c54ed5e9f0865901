"""What a tool is: one row with all that the editor, the panel and the keyboard know of it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from app.tools.marks import Marks
from app.viewpoint.events import Input
from app.workspace.brush_rim import brush_rim
from app.workspace.overlay import ERASING, NOTHING, PAINTING, Overlay
from app.workspace.picking import Hit
from app.workspace.workspace import Interaction, Workspace

Begin = Callable[[Workspace, Input], Interaction | None]
Cursor = Callable[[Workspace, Input], Overlay]


@dataclass(frozen=True)
class Tool:
    """One row of the table.

    label, key: on its button and on the keyboard.
    begin: what a press over the scene starts, anywhere or `on_surface`. Where it is None, or
        starts nothing, the press is left to the camera.
    cursor: what shows where the tool would act, None for nothing.
    marks: what a press or a command marks, None for a tool that marks no vertices.
    options: the rows of the panel it needs, by their names in panel.tool_options.OPTIONS.
    map: the one of color_maps.MAPS that shows what the tool does, None to leave it as it is.
    keeps_heat: a heat map on screen stays, whatever `map` says.
    hint: what to do with it once the surface can be dragged; where it is empty the hint leads to
        the drag tool.
    """

    label: str
    key: str
    begin: Begin | None = None
    cursor: Cursor | None = None
    marks: Marks | None = None
    options: tuple[str, ...] = ()
    map: str | None = None
    keeps_heat: bool = False
    hint: str = ""


def on_surface(begin: Callable[[Workspace, Input, Hit], Interaction | None]) -> Begin:
    """Starts only where the press meets the surface, and is told where that is."""

    def begin_there(work: Workspace, press: Input) -> Interaction | None:
        hit = work.under(press)
        return None if hit is None else begin(work, press, hit)

    return begin_there


def brush_cursor(work: Workspace, frame: Input) -> Overlay:
    """The rim of the brush on the surface under the cursor, in another colour where it erases."""
    hit = work.under(frame)
    if hit is None:
        return NOTHING
    corners = work.positions[work.parts.faces[hit.face]]
    color = ERASING if frame.shift else PAINTING
    place = work.neighbours, work.positions, hit, corners
    radius = work.brush_radius(hit.position, frame.camera)
    return Overlay((brush_rim(*place, radius, frame.camera, color),))
