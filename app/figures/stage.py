"""Takes the pictures of figures; the only part of this package that needs a graphics library."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from app.bundled import DEFAULT_MESH
from app.editor.editor import Editor
from app.figures.figure import Figure
from app.graphics import loading
from app.model.document import Document
from app.worker.inline import InlineWorker
from app.workspace.camera import FIELD_OF_VIEW, Camera
from solver import load_mesh
from solver.types import FloatArray

SIZE = (640, 480)
CAMERAS = {
    "figure": Camera.look_at((0.0, 0.95, 2.6), (0.0, 0.9, 0.0), FIELD_OF_VIEW, SIZE),
    "arm": Camera.look_at((0.56, 1.54, 1.25), (0.56, 1.52, 0.0), FIELD_OF_VIEW, SIZE),
    "elbow": Camera.look_at((0.48, 1.62, 0.78), (0.48, 1.57, 0.0), FIELD_OF_VIEW, SIZE),
}


class Stage(Editor):
    """Shows a figure in place of what a person did."""

    figure: Figure | None = None

    def put(self, figure: Figure) -> None:
        """Show this one from now on."""
        self.figure = figure
        self.map = "roles" if figure.pins is None else "softness"
        pins = np.zeros(len(figure.X), dtype=bool) if figure.pins is None else figure.pins
        self.document.change("pinned", pins)

    @property
    def positions(self) -> FloatArray:
        """The figure's pose."""
        return super().positions if self.figure is None else self.figure.X

    @property
    def positions_version(self) -> int:
        """Another one for each figure."""
        return id(self.figure)

    @property
    def colors(self) -> FloatArray:
        """The figure's colours."""
        return super().colors if self.figure is None else self.figure.colors

    @property
    def colors_version(self) -> tuple[object, ...]:
        """Another one for each figure."""
        return (id(self.figure),)


def draw(figures: Sequence[Figure], folder: Path) -> None:
    """Save a PNG for each figure. Raises GraphicsError."""
    with loading():
        from app.window.view import View, open_offscreen
    open_offscreen(SIZE)
    view, stage = View(), Stage(Document(load_mesh(DEFAULT_MESH), DEFAULT_MESH), InlineWorker())
    for figure in figures:
        stage.put(figure)
        view.sync(stage)
        view.look(CAMERAS[figure.camera])
        view.picture(folder / figure.picture)
        print(f"{folder / figure.picture}: {figure.title}")
