"""What is open and what is chosen: the state that tools and commands work on.

Editor adds the two ways in (`step` and `execute`); everything below it sees only this.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Literal

from app.latest import Latest
from app.live.live_surface import LiveSurface
from app.model.document import Document, clock
from app.model.handles import Handle, Pose
from app.model.history import Gesture, History
from app.model.reach import Reach
from app.pointing.brush import Brush, Neighbours
from app.pointing.picking import Hit, Picker
from app.scene.looks import PLAIN, Looks
from app.scene.regions import Regions
from app.selection.piece_limbs import PieceLimbs
from app.viewpoint.camera import Camera, Ray
from app.viewpoint.events import Input
from app.viewpoint.viewpoint import Viewpoint
from app.worker.client import Worker
from app.workspace.blend import Blend
from app.workspace.chosen import ChosenHandles
from app.workspace.heat import Heat
from app.workspace.interaction import Interaction, Message, Moment
from app.workspace.late import Late
from app.workspace.marking import Marking
from app.workspace.own_files import OwnFiles
from app.workspace.parts import Parts
from app.workspace.placing import Pivots, Placing
from app.workspace.recent import Recent
from app.workspace.seen_handles import SeenHandles
from app.workspace.symmetry import Symmetry
from app.workspace.tasks import Tasks
from solver.mesh.progress import Progress
from solver.types import FloatArray


class Workspace:
    """One open document with its history and its surface on screen, and what a person chose.

    tool: a name in tools.TOOLS.  map: a name in color_maps.MAPS.  turn: dragged handles turn by
    themselves.  keep: what was grabbed stays where it was taken.
    radii: of the brushes of the tools that are not in the hand.
    chosen: which handle is the active one.  placing: how handles are placed exactly.
    blend: of two poses.  looks: how the surface is drawn.  recent: the files opened or saved last.
    symmetry: the mirror across which all happens twice, None for none.
    message: the last one, None before the first.  interaction: the stroke or drag in progress.
    progress: what is told how far reading is.  tasks: what takes longer than a frame.
    viewpoint: where the person looks from.
    last_input: of the frame before.  export_path: where Export goes by default.  session_path: the
    session file last opened or saved.  exported: where the last export went.
    own: the files that may be replaced without asking.
    late: what a drag owes that was over before the solver's bind had come.
    before_press: what there was before the mouse was pressed last.
    """

    def __init__(
        self,
        document: Document,
        worker: Worker,
        session_path: Path | None = None,
        export_path: Path | None = None,
    ) -> None:
        self.worker = worker
        self.export_path = export_path
        self.tool = "navigate"
        self.brush = Brush()
        self.radii: dict[str, float] = {}
        self.marking = Marking()
        self.turn = True
        self.keep = False
        self.placing = Placing()
        self.map = "roles"
        self.looks: Looks = PLAIN
        self.message: Message | None = None
        self.progress: Progress | None = None
        self.tasks = Tasks(self.say)
        self.viewpoint = Viewpoint()
        self.recent = Recent()
        self.adopt(document, session_path)

    def adopt(self, document: Document, session_path: Path | None = None) -> None:
        """Show another document, with a history of its own."""
        mesh = document.mesh
        self.worker.drop()
        self.interaction: Interaction | None = None
        self.document = document
        self.session_path = session_path
        self.exported: Path | None = None
        self.own = OwnFiles()
        if session_path is not None:
            self.own.add(session_path)
        self.history = History()
        self.late = Late()
        self.surface = LiveSurface(document.rest_positions, self.worker, self._complain)
        self.neighbours = Neighbours(mesh.vertices, mesh.faces)
        self.pivots = Pivots(self.neighbours.edges)
        self.placing = replace(self.placing, points={})
        self.blend = Blend()
        self.heat = Heat(mesh)
        self.parts = Parts(mesh)
        self.regions = Regions()
        self.symmetry: Symmetry | None = None
        self.symmetry_name = "off"
        self.picker = Picker(mesh.vertices, mesh.faces)
        self._under: Latest[Hit | None] = Latest()
        self.seen_handles = SeenHandles()
        self._reach: Latest[Reach] = Latest()
        self._centres: Latest[dict[int, FloatArray]] = Latest()
        self.limbs = PieceLimbs(mesh)
        self.last_input: Input | None = None
        self.chosen = ChosenHandles(document)
        self.before_press = self.moment
        self._diagonal = document.diagonal  # found now, not at the first stroke
        self.viewpoint.show(document.rest_positions[mesh.pieces >= 0])

    def say(self, text: str, kind: Literal["info", "error"] = "info") -> None:
        """Put a message on screen."""
        self.message = Message(text, kind, next(clock))

    def _complain(self, text: str) -> None:
        self.say(text, "error")

    @contextmanager
    def edit(self, label: str, merge: str = "") -> Iterator[Gesture]:
        """Changes that become one entry of the history, or none at all if the block raises."""
        gesture = Gesture(self.document)
        try:
            yield gesture
        except BaseException:
            gesture.cancel()
            raise
        self.history.record(gesture.finish(label, merge))

    def finish(self) -> None:
        """Keep the stroke or drag in progress, if there is one."""
        interaction, self.interaction = self.interaction, None
        if interaction is not None:
            interaction.finish()

    def cancel(self) -> None:
        """Take back the stroke or drag in progress, if there is one."""
        interaction, self.interaction = self.interaction, None
        if interaction is not None:
            interaction.cancel()

    def catch_up(self) -> bool:
        """Pay what is `late`, if that is possible by now; whether it was. Raises SolverError."""
        return self.interaction is None and self.late.pay(self.document, self.history, self.surface)

    @property
    def moment(self) -> Moment:
        """What a second click comes back to."""
        return Moment(self.history.top, self.chosen.choice)

    def take_back(self, since: Moment) -> None:
        """Take the last entry back for good, if it is the only one made since."""
        if self.history.retract(self.document, since.top):
            self.chosen.choice = since.choice

    @property
    def dragging(self) -> bool:
        """Whether a drag is in progress."""
        return self.interaction is not None and self.interaction.drags

    def under(self, frame: Input) -> Hit | None:
        """What the cursor of a frame points at: picked once, as long as the surface stays."""
        ray = frame.ray
        if ray is None:
            return None
        return self._under((frame, self.surface.version), lambda: self.pick(ray))

    @property
    def hovered(self) -> int | None:
        """The number of the part under the cursor, None for none."""
        hit = None if self.last_input is None else self.under(self.last_input)
        return None if hit is None else int(self.document.mesh.pieces[hit.vertex])

    def pick(self, ray: Ray) -> Hit | None:
        """The first point of the surface on screen that the ray meets."""
        return self.picker.pick(ray, self.positions)

    def show_part(self, number: int, on: bool) -> None:
        """Show a part again, or hide it."""
        self.parts.show(number, on)
        self.picker = Picker(self.document.mesh.vertices, self.parts.faces)
        self._under = Latest()

    def mirrored(self, pose: Pose, keys: Collection[int]) -> Pose:
        """The pose with what mirrors handles `keys`, which were moved, moved along.

        Raises ConstraintError where one of them is too far, see Reach.
        """
        for key in keys:
            handle = self.document.find(key)
            self.reach.check(pose.of(key), handle.name if handle else "what is grabbed")
        return self.symmetry.followed(self.document, pose, keys) if self.symmetry else pose

    @property
    def reach(self) -> Reach:
        """How far handles may go; found again for another rest shape."""
        return self._reach(self.document.surface_number, lambda: Reach(self.document))

    @property
    def positions(self) -> FloatArray:
        """(n, 3) on screen."""
        return self.surface.positions

    @property
    def handle_centres(self) -> dict[int, FloatArray]:
        """(3,) the middle at rest of each handle, found again when it may differ."""
        revision = self.document.revision
        version = revision["role"], revision["rest"], revision["handles"]
        return self._centres(version, self.document.handle_centres)

    def brush_radius(self, point: FloatArray, camera: Camera) -> float:
        """In world units, of a brush at a point of the surface."""
        return self.brush.radius * self.brush_unit(point, camera)

    def brush_unit(self, point: FloatArray, camera: Camera) -> float:
        """What radii of the brush are a fraction of, in world units."""
        if self.brush.on_screen:
            return camera.size[1] * camera.units_per_pixel(point)
        return self._diagonal

    @property
    def active(self) -> Handle | None:
        """The handle that the handle brush paints, see ChosenHandles."""
        return self.chosen.active

    @property
    def selected(self) -> tuple[Handle, ...]:
        """The handles that are placed together, the active one first."""
        return self.chosen.selected

    @property
    def pivot(self) -> FloatArray | None:
        """(3,) what the selected handles turn about; None where they have no vertices."""
        keys = [handle.key for handle in self.selected]
        return self.pivots.of(self.document, keys, self.placing)
