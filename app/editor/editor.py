"""The whole application without its window: one frame of input or one command at a time."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from app.editor.actions import ACTIONS
from app.editor.commands import Command, SetBrush
from app.editor.softness_warnings import Warning, softness_warnings
from app.model.document import Document
from app.model.handles import FIRST_HANDLE, FIXED
from app.tools.table import TOOLS
from app.viewpoint.events import ENTER, Input
from app.viewpoint.viewpoint import Motion
from app.workspace.brush import RADIUS_STEP
from app.workspace.color_maps import MAPS
from app.workspace.ghost import ghost as rest_ghost
from app.workspace.latest import Latest
from app.workspace.operator import Operator
from app.workspace.overlay import NOTHING, Overlay
from app.workspace.regions import Borders, border_lines
from app.workspace.scene import Dots, Lines, Scene, dot_radius
from app.workspace.workspace import Workspace
from solver.errors import SolverError
from solver.types import FloatArray

TO_BEGIN = (
    f"Paint a handle ({TOOLS['handle'].key}), "
    f"or take the drag tool ({TOOLS['drag'].key}), click what stays and drag"
)
TO_DRAG = f"Take the drag tool ({TOOLS['drag'].key}), then press on a handle and drag"


class Editor(Workspace):
    """What a person does, and what they see of it.

    Whatever goes wrong with an input, a command or a file becomes a message; the document stays
    as it was. cursor: what shows where the tool would act.
    """

    def adopt(self, document: Document, session_path: Path | None = None) -> None:
        """Show another document, with a history of its own."""
        super().adopt(document, session_path)
        self.cursor: Overlay = NOTHING
        self._colors: Latest[FloatArray] = Latest()
        self._dots: Latest[Dots | None] = Latest()
        self._borders: Borders | None = None
        self._lines: Latest[Lines | None] = Latest()
        self._dot_radius = dot_radius(document.mesh.vertices, self.neighbours.edges)
        self._ghost: Latest[FloatArray] = Latest()
        self._warnings: Latest[tuple[Warning, ...]] = Latest()
        self._left: Motion | None = None  # what the button that is down does to the camera
        self._refusing = False  # the secondary button is down that took an operator back

    def step(self, frame: Input) -> None:
        """One frame: advance a stroke or drag, take finished binds, pose the surface."""
        try:
            self._advance(frame)
            self._refresh()
        except (SolverError, OSError) as error:
            self.cancel()
            self.say(str(error), "error")
        self._resize_brush(frame)
        seen = replace(frame, secondary=False) if self._refusing else frame
        self.viewpoint.advance(seen, self._left, lambda: self._point(frame))
        self.last_input = frame
        self.cursor = self._cursor(frame)

    def execute(self, command: Command) -> None:
        """Do what a person asks for."""
        try:
            if command.interrupts:
                self.finish()
            ACTIONS[type(command)](self, command)
            self._refresh()
        except (SolverError, OSError) as error:
            self.say(str(error), "error")

    def settle(self) -> None:
        """For scripts: wait until the surface is what the document asks for. Raises SolverError."""
        self.surface.settle(self.document)
        self._refresh()

    def close(self) -> None:
        """End the worker."""
        self.worker.close()

    @property
    def captures(self) -> bool:
        """Whether a stroke or a drag has the mouse, and the primary button leaves the camera."""
        return self.interaction is not None

    @property
    def hears(self) -> bool:
        """Whether what is typed goes to an operator, and no shortcut but Esc is meant."""
        return isinstance(self.interaction, Operator)

    @property
    def busy(self) -> bool:
        """Whether the surface is not yet what the document asks for: a bind or a pose is under way.

        A drag shows its poses as they come; only a bind counts then.
        """
        return self.worker.binding if self.dragging else self.worker.busy

    @property
    def waits(self) -> bool:
        """Whether what is under way takes so long that a person should be told."""
        return self.worker.binding or (self.busy and self.surface.slow)

    @property
    def dirty(self) -> bool:
        """Whether there are changes that no session file holds."""
        return self.history.dirty

    def scene(self, rest: bool = False) -> Scene:
        """What is to be drawn now.

        rest: the rest shape in place of the surface, and no cursor on it.
        """
        document, mesh, polygons = self.document, self.document.mesh, self.parts.polygons
        positions = document.rest_positions if rest else self.positions
        dots = None
        if MAPS[self.map].pins:
            revision = document.revision["pinned"]
            version = revision, self.positions_version, self.parts.hidden, rest
            dots = self._dots(version, lambda: self._pinned(positions))
        ghost = self._seen_through() if self.looks.rest and not rest else None
        overlay, lines = (NOTHING, None) if rest else (self.cursor, self._border_lines())
        shown = positions, self.colors, dots, self.looks, ghost, lines, overlay
        return Scene(mesh, polygons, *shown)

    def _seen_through(self) -> FloatArray:
        """The rest shape as a ghost."""
        document = self.document
        return self._ghost(
            document.revision["rest"],
            lambda: rest_ghost(document.rest_positions, document.mesh.faces, document.diagonal),
        )

    @property
    def colors(self) -> FloatArray:
        """(n, 3) RGB of the map that is shown; another array where they have changed."""
        return self._colors(self.colors_version, lambda: MAPS[self.map].paint(self))

    @property
    def colors_version(self) -> tuple[object, ...]:
        """Differs whenever `colors` may."""
        return (self.map, self.selected, MAPS[self.map].version(self))

    @property
    def positions_version(self) -> int:
        """Differs whenever `positions` does."""
        return self.surface.version

    @property
    def warnings(self) -> tuple[Warning, ...]:
        """What is wrong with the softness, in plain words; checked again when it has changed."""
        revision = self.document.revision
        version = tuple(revision[field] for field in ("role", "softness", "material"))
        return self._warnings(
            version, lambda: softness_warnings(self.document, self.neighbours.edges)
        )

    @property
    def bind_seconds(self) -> float | None:
        """How long the bind in use took, None without one."""
        return self.surface.bound.seconds if self.surface.bound else None

    @property
    def drag_seconds(self) -> float:
        """What the solver took of the last drag frame: orientation and pose."""
        return self.surface.orient_seconds + self.surface.pose_seconds

    @property
    def hint(self) -> str:
        """What to do next, or what is missing before a drag is possible."""
        role = self.document.role
        if not (role >= FIRST_HANDLE).any():
            return TOOLS[self.tool].hint or TO_BEGIN
        if self.waits:
            return "Binding ..." if self.worker.binding else "Refining ..."
        if self.surface.bind_error:
            return self.surface.bind_error
        hint = TOOLS[self.tool].hint or TO_DRAG
        if not (role == FIXED).any():
            return f"{hint}; nothing is fixed, so the whole part moves along"
        active, bound = self.active, self.surface.bound
        if active is not None and bound is not None and bound.is_loose(active.key):
            piece = self.document.mesh.pieces[self.document.vertices_of(active.key)[0]]
            hint += f"; nothing holds {self.parts.name(int(piece))}, so it moves as a whole"
        return hint

    def _border_lines(self) -> Lines | None:
        """The borders of what is held; those before while a stroke is changing them."""
        if self.interaction is None or self._borders is None:
            self._borders = self.regions.borders(self.document)
        borders, selected = self._borders, tuple(handle.key for handle in self.selected)
        radius = self.viewpoint.line_radius
        version = borders, self.positions_version, selected, radius
        return self._lines(version, lambda: border_lines(borders, self.positions, selected, radius))

    def _pinned(self, positions: FloatArray) -> Dots | None:
        """A dot on every pinned vertex."""
        document = self.document
        if not document.pinned.any():
            return None
        return Dots(positions[document.pinned & self.parts.visible], self._dot_radius)

    def _refresh(self) -> None:
        self.surface.follow(self.document, self.captures, self.dragging)
        measure = MAPS[self.map].measure
        self.heat.follow(
            measure, self.document, self.positions, self.positions_version, self.dragging
        )

    def _advance(self, frame: Input) -> None:
        self._refusing = self._refusing and frame.secondary
        operator = self.interaction
        if isinstance(operator, Operator) and (operator.modal or not frame.pressed):
            self._operate(operator, frame)
            return
        if frame.pressed:
            self.finish()  # a release that nobody saw
            self._begin(frame)
        elif self.interaction is not None and (frame.down or frame.released):
            self.interaction.move(frame)
        if self.interaction is None and frame.released:
            self.history.seal()  # a slider was let go: the next slide is an entry of its own
        if not frame.down:
            self._touch(frame)
            self._left = None
            self.finish()

    def _operate(self, operator: Operator, frame: Input) -> None:
        """An operator follows the cursor and hears the keys until it is kept or taken back."""
        if operator.modal and frame.secondary:
            self._refusing = True
            self.cancel()
            return
        if frame.typed:
            operator.type(frame.typed)
        operator.move(frame)
        done = frame.pressed if operator.modal else not frame.down
        if done or ENTER in frame.typed:
            self.finish()

    def _begin(self, frame: Input) -> None:
        """A press over the scene is the tool's, else it moves the camera."""
        if frame.pixel is None:
            return
        begin = TOOLS[self.tool].begin
        if begin is not None and not frame.alt:
            self.interaction = begin(self, frame)
        if self.interaction is None:
            self._left = "pan" if frame.shift and not frame.alt else "orbit"
        else:
            self._touch(frame)

    def _resize_brush(self, frame: Input) -> None:
        """The wheel with Ctrl resizes the brush of a tool that has one."""
        if frame.wheel and frame.ctrl and TOOLS[self.tool].marks is not None:
            self.execute(SetBrush(radius=self.brush.radius * RADIUS_STEP**frame.wheel))

    def _touch(self, frame: Input) -> None:
        """The view turns about the point that a stroke or drag last touched."""
        point = self._point(frame) if self.interaction is not None else None
        if point is not None:
            self.viewpoint.pivot = point

    def _point(self, frame: Input) -> FloatArray | None:
        """Of the surface, under the cursor."""
        hit = self.under(frame)
        return None if hit is None else hit.position

    def _cursor(self, frame: Input) -> Overlay:
        if isinstance(self.interaction, Operator):
            return self.interaction.overlay(frame)
        cursor = TOOLS[self.tool].cursor
        return NOTHING if cursor is None else cursor(self, frame)
