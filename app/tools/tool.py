"""What a tool is: one row with all that the editor, the panel and the keyboard know of it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from app.pointing.brush_rim import brush_rim
from app.pointing.picking import Hit
from app.scene.overlay import ERASING, NOTHING, PAINTING, Overlay
from app.tools.marks import Marks
from app.viewpoint.events import Input
from app.workspace.interaction import Interaction
from app.workspace.nearby import near_surface
from app.workspace.workspace import Workspace

NEAR_SURFACE = 15.0  # pixels beside the surface that still count
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
    """Starts only where the press meets the surface, or all but meets it, and is told where."""

    def begin_there(work: Workspace, press: Input) -> Interaction | None:
        hit = near_surface(work, press, NEAR_SURFACE)
        return None if hit is None else begin(work, press, hit)

    return begin_there


def first_of(*begins: Begin) -> Begin:
    """What the first of these starts that starts anything."""

    def begin_one(work: Workspace, press: Input) -> Interaction | None:
        started = (begin(work, press) for begin in begins)
        return next((one for one in started if one is not None), None)

    return begin_one


def brush_cursor(work: Workspace, frame: Input) -> Overlay:
    """The rim of the brush on the surface under the cursor, in another colour where it erases."""
    hit = near_surface(work, frame, NEAR_SURFACE)
    orbiting = frame.down and work.interaction is None
    if hit is None or orbiting:
        return NOTHING
    color = ERASING if frame.shift else PAINTING
    corners = work.positions[work.parts.faces[hit.face]]
    places = [(hit, corners)]
    if work.symmetry is not None:
        image = work.symmetry.hit(hit, work.positions)
        if image is not None and image.vertex != hit.vertex:
            places.append((image, work.symmetry.plane.reflect(corners)))
    radius = work.brush_radius(hit.position, frame.camera)
    surface = work.neighbours, work.positions
    rims = (brush_rim(*surface, *place, radius, frame.camera, color) for place in places)
    return Overlay(tuple(rims))
