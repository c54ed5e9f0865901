"""The arm from near, drawn without a window: painted, soft, folded, strained."""

from __future__ import annotations

from app.bundled import DEFAULT_MESH
from app.demo import DRAG, PICTURE_SIZE, Performer, paint_elbow, paint_regions, painter
from app.editor.commands import SetMap
from app.editor.editor import Editor
from app.model.document import Document
from app.viewpoint.camera import FIELD_OF_VIEW, Camera
from app.viewpoint.framing import framing
from app.worker.client import ProcessWorker
from docs.pictures.scene import IMAGES
from solver import load_mesh

SIZE = (640, 560)
PICTURES = ("painted.png", "soft.png", "folded.png", "folded-soft.png", "folded-strain.png")


def make() -> None:
    """All of them."""
    editor = Editor(Document(load_mesh(DEFAULT_MESH), DEFAULT_MESH), ProcessWorker())
    performer = Performer(editor, framing(editor.positions, PICTURE_SIZE))
    near = Camera.look_at((0.4, 1.52, 1.3), (0.4, 1.52, 0.0), FIELD_OF_VIEW, SIZE)
    draw = painter(editor, near, SIZE)
    paint_regions(performer)
    draw(IMAGES / "painted.png", "painted")
    paint_elbow(performer)
    draw(IMAGES / "soft.png", "soft")
    performer.take("drag")
    performer.stroke(DRAG)
    draw(IMAGES / "folded.png", "folded")
    for name, what in (("softness", "soft"), ("strain", "strain")):
        editor.execute(SetMap(name))
        draw(IMAGES / f"folded-{what}.png", f"folded, {name}")
    editor.close()
