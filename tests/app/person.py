"""A scripted person: points at places of the surface and does what a hand would do."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from app.editor.commands import Command, SetBrush, SetTool
from app.editor.editor import Editor
from app.model.document import Document
from app.viewpoint.camera import FIELD_OF_VIEW, Camera
from app.viewpoint.events import Input
from app.worker.client import Worker
from app.worker.requests import Request
from solver import Mesh
from solver.types import FloatArray, IntArray
from tests.app.inline import InlineWorker
from tests.solver import shapes


def sheet(columns: int, rows: int, height: float = 0.0) -> tuple[FloatArray, IntArray]:
    """Unit squares, each two triangles, in the plane z = height."""
    V, F = shapes.grid(columns + 1, rows + 1)
    return V + [0, 0, height], F


def slab(columns: int, rows: int, thickness: float) -> Mesh:
    """A closed box: two sheets, the upper one first, joined along their rims."""
    top, F = sheet(columns, rows)
    n = len(top)
    edges = np.vstack([F[:, [0, 1]], F[:, [1, 2]], F[:, [2, 0]]])
    pairs = {(int(a), int(b)) for a, b in edges}
    rim = np.array([(a, b) for a, b in sorted(pairs) if (b, a) not in pairs])
    a, b = rim.T
    sides = np.vstack([np.column_stack([b, a, a + n]), np.column_stack([b, a + n, b + n])])
    V = np.vstack([top, top - [0, 0, thickness]])
    return Mesh.from_arrays(V, np.vstack([F, F[:, ::-1] + n, sides]))


# Of the way to the middle: rounding may not take a point of the rim off the surface.
INWARD = 1e-6


class IdleWorker(InlineWorker):
    """Never gets anywhere: as slow a bind as can be."""

    binding = True

    def request(self, request: Request) -> None:
        pass

    @property
    def busy(self) -> bool:
        return True


class Person:
    """One editor and the eye that looks at it, from above by default."""

    def __init__(
        self,
        mesh: Mesh,
        path: Path = Path("mesh.obj"),
        eye: ArrayLike = (0, 0, 60),
        worker: Worker | None = None,
    ) -> None:
        self._sit(Editor(Document(mesh, path), worker or InlineWorker()), eye)

    @classmethod
    def of(cls, editor: Editor) -> Person:
        """At an editor that is open already."""
        person = cls.__new__(cls)
        person._sit(editor, (0, 0, 60))
        return person

    def _sit(self, editor: Editor, eye: ArrayLike) -> None:
        self.editor = editor
        self.centre = editor.document.mesh.vertices.mean(axis=0)
        self.eye = self.centre + np.asarray(eye, dtype=float)

    def frame(
        self,
        point: ArrayLike | None = None,
        mouse: str = "",
        shift: bool = False,
        **more: Any,
    ) -> None:
        """One frame with the cursor on a point.

        mouse: some of p(ressed), d(own), r(eleased), of the other buttons s(econdary), m(iddle).
        more: other fields of Input.
        """
        camera = Camera.look_at(self.eye, self.centre, FIELD_OF_VIEW, (1280, 800))
        pixel = None
        if point is not None:
            inward = np.asarray(point, dtype=float) + INWARD * (self.centre - point)
            ((x, y),) = camera.project(inward[None])
            pixel = float(x), float(y)
        self.editor.step(
            Input(
                pixel,
                camera,
                pressed="p" in mouse,
                down="d" in mouse,
                released="r" in mouse,
                shift=shift,
                secondary="s" in mouse,
                middle="m" in mouse,
                **more,
            )
        )

    def hold(self, points: Iterable[ArrayLike], shift: bool = False) -> Iterator[int]:
        """Press on the first point, move through the others: yields after each frame."""
        for number, point in enumerate(points):
            self.frame(point, "d" if number else "pd", shift)
            yield number

    def stroke(self, *points: ArrayLike, shift: bool = False) -> None:
        """Press, move, and release on the last point."""
        for _ in self.hold(points, shift):
            pass
        self.frame(points[-1], "r", shift)

    def click(self, point: ArrayLike, count: int = 1, shift: bool = False) -> None:
        """So many quick clicks on a point."""
        for number in range(1, count + 1):
            self.frame(point, "pd", shift, clicks=number)
            self.frame(point, "r", shift, clicks=number)

    def use(self, tool: str, radius: float | None = None) -> None:
        """Take a tool; radius in world units."""
        self.do(SetTool(tool))
        if radius is not None:
            self.do(SetBrush(radius=radius / self.editor.document.diagonal))

    def do(self, *commands: Command) -> None:
        """Ask for things, one when the other is done."""
        for command in commands:
            self.editor.execute(command)
            if self.editor.tasks.now is not None:
                self.editor.complete()

    def answer(self, label: str) -> None:
        """Press the button of the question that stands."""
        question = self.editor.question
        assert question is not None, "nothing is asked"
        (answer,) = (answer for answer in question.answers if answer.label == label)
        command = self.editor.answer(answer)
        if command is not None:
            self.do(command)

    def ready_bar(self) -> None:
        """On `slab(20, 4, 2)`: the left end fixed, the right end a handle, bound."""
        self.use("fixed", 1.6)
        self.stroke([0, 0, 0], [0, 4, 0])
        self.use("handle", 1.6)
        self.stroke([20, 0, 0], [20, 4, 0])
        self.editor.settle()
        self.use("drag")


def transforms(document: Document) -> list[FloatArray]:
    """(4, 4) of each handle."""
    return [document.pose.of(handle.key) for handle in document.handles]


def state(document: Document) -> tuple[object, ...]:
    """Everything undoable, bit for bit."""
    return (
        document.role.tobytes(),
        document.softness.tobytes(),
        document.handles,
        [
            (document.pose.of(h.key).tobytes(), document.pose.turn(h.key).tobytes())
            for h in document.handles
        ],
        document.material,
        document.bending_length,
        document.orientation,
        document.rigid,
        document.attach,
        document.pinned.tobytes(),
        [(kept.name, kept.pose) for kept in document.poses],
        document.rest_positions.tobytes(),
    )


def question_of(person: Person) -> str:
    """What is asked."""
    assert person.editor.question is not None
    return person.editor.question.text


def error_of(person: Person) -> str:
    """The error on screen, one line."""
    message = person.editor.message
    assert message is not None
    assert message.kind == "error"
    assert "\n" not in message.text
    return message.text
