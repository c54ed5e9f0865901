"""Takes the pictures of figures; the only part of this package that needs a graphics library."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from app.bundled import DEFAULT_MESH
from app.figures.figure import Figure
from app.graphics import loading
from app.scene.scene import Dots, Scene, dot_radius
from app.scene.shading import shaded
from app.telling import tell
from app.viewpoint.camera import FIELD_OF_VIEW, Camera
from solver import load_mesh
from solver.geometry.topology import Topology

SIZE = (640, 480)
CAMERAS = {
    "figure": Camera.look_at((0.0, 0.95, 2.6), (0.0, 0.9, 0.0), FIELD_OF_VIEW, SIZE),
    "arm": Camera.look_at((0.56, 1.54, 1.25), (0.56, 1.52, 0.0), FIELD_OF_VIEW, SIZE),
    "elbow": Camera.look_at((0.48, 1.62, 0.78), (0.48, 1.57, 0.0), FIELD_OF_VIEW, SIZE),
}


def draw(figures: Sequence[Figure], folder: Path) -> None:
    """Save a PNG for each figure. Raises GraphicsError."""
    with loading():
        from app.window.drawing.view import View
        from app.window.opening import open_offscreen
    open_offscreen(SIZE)
    view, mesh = View(), load_mesh(DEFAULT_MESH)
    radius = dot_radius(mesh.vertices, Topology(mesh.faces, len(mesh.vertices)).edges)
    surface = shaded(mesh, hard=False)
    for figure in figures:
        dots = None if figure.pins is None else Dots(figure.X[figure.pins], radius)
        view.show(Scene(surface, figure.X, figure.colors, dots))
        view.look(CAMERAS[figure.camera])
        view.picture(folder / figure.picture)
        tell(f"{folder / figure.picture}: {figure.title}")
