"""The only writer of Polyscope's structures: draws a Scene, moves the camera, takes pictures."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import polyscope as ps
import polyscope.imgui as psim

from app.workspace.camera import Camera
from app.workspace.scene import Dots, Outline, Scene
from solver.types import FloatArray

SURFACE, COLORS, DOTS = "surface", "colors", "dots"
EDGE_WIDTH, EDGE_COLOR = 0.6, (0.15, 0.15, 0.2)
DOT_COLOR = (0.96, 0.96, 0.98)
# An outline is bright on a wider dark line, so that it is seen on every colour.
DARK, DARK_WIDTH, BRIGHT_WIDTH = (30, 30, 40, 200), 4.0, 2.0


class View:
    """The scene on screen, and the camera it is seen through.

    inset: pixels at the left of the window that a panel covers.
    """

    def __init__(self, inset: float = 0.0) -> None:
        self._inset = inset
        self._mesh: Any = None  # Polyscope has no type hints
        self._shown: Scene | None = None

    def show(self, scene: Scene) -> None:
        """Upload what differs from the scene shown before, and nothing else."""
        before = self._shown
        if before is None or scene.polygons is not before.polygons:
            if before is None or scene.mesh is not before.mesh:
                self.frame_mesh(scene.positions)
            before = self._register(scene)
        if scene.positions is not before.positions:
            self._mesh.update_vertex_positions(scene.positions)
        if scene.colors is not before.colors:
            self._mesh.get_quantity_buffer(COLORS, "colors").update_data(scene.colors)
        if scene.dots is not before.dots:
            _place(scene.dots)
        if scene.edges != before.edges:  # setting it to what it is draws the whole scene again
            self._mesh.set_edge_width(EDGE_WIDTH if scene.edges else 0.0)
        if scene.outline is not None:
            _draw(scene.outline, self.camera())
        self._shown = scene

    def _register(self, scene: Scene) -> Scene:
        """Another surface, or another part of it; returns what of the scene is shown by now."""
        self._mesh = ps.register_surface_mesh(
            SURFACE, scene.positions, scene.polygons, smooth_shade=True, material="wax"
        )
        self._mesh.set_back_face_policy("identical")
        self._mesh.set_edge_color(EDGE_COLOR)
        self._mesh.add_color_quantity(COLORS, scene.colors, enabled=True)
        _place(scene.dots)
        return replace(scene, edges=False)

    def frame_mesh(self, positions: FloatArray) -> None:
        """Move the camera so that the whole surface is seen beside the panel, from the front."""
        self.look(Camera.framing(positions, tuple(ps.get_window_size()), self._inset))

    def look(self, camera: Camera) -> None:
        """See what `camera` sees; the field of view stays."""
        ps.look_at(camera.position, camera.position + camera.forward)

    def camera(self) -> Camera:
        """The camera of this frame."""
        p = ps.get_view_camera_parameters()
        forward, up = (np.asarray(v, dtype=np.float64) for v in (p.get_look_dir(), p.get_up_dir()))
        return Camera(
            np.asarray(p.get_position(), dtype=np.float64),
            forward / np.linalg.norm(forward),
            up / np.linalg.norm(up),
            float(np.radians(p.get_fov_vertical_deg())),
            tuple(ps.get_window_size()),
        )

    def picture(self, path: Path, transparent: bool = False) -> None:
        """Save what the camera sees, without the panel, as a PNG. Raises FileError."""
        ps.screenshot(str(path), transparent_bg=transparent, include_UI=False)


def _place(dots: Dots | None) -> None:
    """These dots in place of those before."""
    ps.remove_point_cloud(DOTS, error_if_absent=False)
    if dots is not None:
        cloud = ps.register_point_cloud(DOTS, dots.centres, color=DOT_COLOR, material="flat")
        cloud.set_radius(dots.radius, relative=False)


def _draw(outline: Outline, camera: Camera) -> None:
    """A line over the scene, left out where part of it is behind the camera."""
    pixels = camera.project(outline.corners)
    if not np.isfinite(pixels).all():
        return
    flags = psim.ImDrawFlags_Closed if outline.closed else psim.ImDrawFlags_None
    for color, width in ((DARK, DARK_WIDTH), ((*outline.color, 255), BRIGHT_WIDTH)):
        psim.GetBackgroundDrawList().AddPolyline(
            np.asfortranarray(pixels, dtype=np.float32), psim.IM_COL32(*color), flags, width
        )
