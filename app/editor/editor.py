"""The whole application without its window: one frame of input or one command at a time."""

from __future__ import annotations

import time
from collections.abc import Callable
from pathlib import Path

from app.editor.actions import ACTIONS
from app.editor.commands import Command
from app.editor.hand import Hand
from app.editor.hints import hint
from app.editor.question import Answer, Asks, Question
from app.editor.softness_warnings import Warning, softness_warnings
from app.editor.stage import Stage
from app.latest import Latest
from app.model.document import Document
from app.scene.overlay import NOTHING, Overlay
from app.scene.scene import Scene
from app.telling import tell
from app.viewpoint.events import Input
from app.workspace.color_maps import MAPS
from app.workspace.operator import Operator
from app.workspace.workspace import Workspace
from solver.errors import FileError, SolverError
from solver.types import FloatArray

PAUSE = 0.005  # seconds between two steps of a task that a script waits for


class Editor(Workspace):
    """What a person does, and what they see of it.

    Whatever goes wrong with an input, a command or a file becomes a message; the document stays
    as it was. cursor: what shows where the tool would act.  question: what is asked now: until it
    is answered, nothing else is heard.  leaving: called before another document is shown in place
    of this one; where it raises, this one stays.
    """

    leaving: Callable[[], None] = staticmethod(lambda: None)

    def adopt(self, document: Document, session_path: Path | None = None) -> None:
        """Show another document, with a history of its own."""
        self.leaving()
        super().adopt(document, session_path)
        self.cursor: Overlay = NOTHING
        self.question: Question | None = None
        self._later: list[Question] = []
        self._hand, self._stage = Hand(self), Stage(self)
        self._warnings: Latest[tuple[Warning, ...]] = Latest()

    def step(self, frame: Input) -> None:
        """One frame: advance a stroke or drag and a task, take finished binds, pose the surface."""
        if self.question is None and self._later:
            self.ask(self._later.pop(0))
        if self.question is not None:
            frame = Input(None, frame.camera)
        self._try(self.tasks.advance)
        try:
            self._hand.advance(frame)
            self._refresh()
        except (SolverError, OSError) as error:
            self.cancel()
            self.say(str(error), "error")
        self._hand.resize_brush(frame, self.execute)
        self._hand.look(frame)
        self.last_input = frame
        self.cursor = self._hand.cursor(frame)

    def execute(self, command: Command) -> None:
        """Do what a person asks for, or ask first."""
        if self.question is not None:
            return
        self._try(lambda: self._do(command))

    def _do(self, command: Command) -> None:
        if command.interrupts:
            self.finish()
        ACTIONS[type(command)](self, command)
        self._refresh()

    def ask(self, question: Question) -> None:
        """Put a question, in place of the one that stands; a stroke or drag in progress ends."""
        self.question = question
        self.finish()

    def answer(self, answer: Answer) -> Command | None:
        """Take the question away; returns what is to be done now."""
        self.question = None
        return answer.command

    def settle(self) -> None:
        """For scripts: wait until the surface is what the document asks for. Raises SolverError."""
        self.surface.settle(self.document)
        if self.catch_up():
            self.surface.settle(self.document)
        self._refresh()

    def complete(self) -> None:
        """For scripts: wait until no task is under way. What goes wrong is a message."""
        while self.tasks.now is not None:
            time.sleep(PAUSE)
            self._try(self._refresh)
            self._try(self.tasks.advance)
        self._try(self._refresh)

    def close(self) -> None:
        """End the task and the worker. A file that is being written is; what is not done is told.

        Raises what goes wrong with it, FileError where somebody would have to be asked.
        """
        try:
            undone = self.tasks.close()
        except Asks as asks:  # nobody is there to answer
            raise FileError(str(asks).partition("\n")[0]) from asks
        finally:
            self.worker.close()
        for name in undone:
            tell(f"{name} was not finished", error=True)

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
        """What is to be drawn now; rest: the rest shape in place of the surface."""
        return self._stage.scene(self.cursor, rest)

    @property
    def colors(self) -> FloatArray:
        """(n, 3) RGB of the map that is shown; another array where they have changed."""
        return self._stage.colors

    @property
    def colors_version(self) -> tuple[object, ...]:
        """Differs whenever `colors` may."""
        return self._stage.colors_version

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
        return hint(self, self.waits)

    def _try(self, act: Callable[[], object]) -> None:
        """What goes wrong becomes a message, what has to be asked first a question."""
        try:
            act()
        except Asks as asks:
            if self.question is None:
                self.ask(asks.question)
            else:  # a task's: what is being answered stays where it is
                self._later.append(asks.question)
        except (SolverError, OSError) as error:
            self.say(str(error), "error")

    def _refresh(self) -> None:
        self.surface.follow(self.document, self.captures, self.dragging)
        if self.catch_up():
            self.surface.follow(self.document, self.captures, self.dragging)
        measure = MAPS[self.map].measure
        self.heat.follow(
            measure, self.document, self.positions, self.positions_version, self.dragging
        )
