"""The paper's figures, made by the tool on the default mesh."""

from __future__ import annotations

from pathlib import Path

from app.bundled import DEFAULT_MESH
from app.camera import Camera
from app.demo import DRAG, PICTURE_SIZE, Performer, paint_regions, painter
from app.document import Document
from app.editor import Editor
from app.worker import ProcessWorker
from solver import load_mesh


def figures(folder: Path) -> None:
    """Save figures 4, 6 and 7 as PNG files. Raises SolverError."""
    editor = Editor(Document(load_mesh(DEFAULT_MESH), DEFAULT_MESH), ProcessWorker())
    camera = Camera.framing(editor.positions, PICTURE_SIZE)
    performer = Performer(editor, camera)
    draw = painter(editor, camera)
    draw(folder / "figure-04.png", "the original mesh")
    paint_regions(performer)
    draw(folder / "figure-06.png", "fixed (purple) and movable (yellow) handle")
    performer.take("drag")
    performer.stroke(DRAG[:3])
    draw(folder / "figure-07.png", "the arm follows the movable handle")
    editor.close()
