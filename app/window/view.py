"""The only writer of Polyscope's structures: draws a Scene, moves the camera, takes pictures."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import polyscope as ps
from numpy.typing import NDArray

from app.scene.looks import PLAIN
from app.scene.scene import Dots, Lines, Scene
from app.viewpoint.camera import Camera
from app.window.scaling import scaled

SURFACE, COLORS, DOTS, LINES, GHOST = "surface", "colors", "dots", "lines", "ghost"
EDGE_WIDTH, EDGE_COLOR = 0.6, (0.15, 0.15, 0.2)
DOT_COLOR = (0.96, 0.96, 0.98)
GHOST_COLOR, GHOST_OPACITY = (0.45, 0.47, 0.52), 0.35
GHOST_LAYERS = 3  # its front, its back, the surface: each is a pass over the scene


class View:
    """The scene on screen, and the camera it is seen through."""

    def __init__(self) -> None:
        self._mesh: Any = None  # Polyscope has no type hints
        self._shown: Scene | None = None

    def show(self, scene: Scene) -> None:
        """Upload what differs from the scene shown before, and nothing else."""
        before = self._shown
        if before is None or scene.polygons is not before.polygons:
            before = self._register(scene)
        if scene.positions is not before.positions:
            self._mesh.update_vertex_positions(scene.positions)
        if scene.colors is not before.colors:
            self._mesh.get_quantity_buffer(COLORS, "colors").update_data(scene.colors)
        if scene.dots is not before.dots:
            _place(scene.dots)
        if scene.lines is not before.lines:
            _thread(scene.lines, before.lines)
        if scene.looks != before.looks:  # setting it to what it is draws the whole scene again
            self._mesh.set_edge_width(scaled(EDGE_WIDTH) if scene.looks.edges else 0.0)
            self._mesh.set_smooth_shade(scene.looks.smooth)
        if scene.ghost is not before.ghost:
            _haunt(scene)
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
        _thread(scene.lines, None)
        _haunt(scene)
        return replace(scene, looks=PLAIN)

    def look(self, camera: Camera, reach: float | None = None) -> None:
        """See what `camera` sees; the field of view stays.

        reach: about how far away the farthest thing is. Polyscope draws 20 times as far as its
        centre of view is; without a reach that one stays.
        """
        if reach is not None:
            ps.set_view_center_raw(camera.position + reach * camera.forward)
        axes = np.stack([camera.right, camera.up, -camera.forward])
        matrix = np.eye(4)
        matrix[:3, :3], matrix[:3, 3] = axes, -axes @ camera.position
        ps.set_camera_view_matrix(matrix)

    def pixels(self) -> NDArray[np.uint8]:
        """What the camera sees, without the panel and what is drawn over the scene, (h, w, 3)."""
        return np.ascontiguousarray(ps.screenshot_to_buffer(transparent_bg=False)[..., :3])

    def picture(self, path: Path, transparent: bool = False) -> None:
        """Save what the camera sees, without the panel, as a PNG. Raises FileError."""
        ps.screenshot(str(path), transparent_bg=transparent, include_UI=False)


def _place(dots: Dots | None) -> None:
    """These dots in place of those before."""
    ps.remove_point_cloud(DOTS, error_if_absent=False)
    if dots is not None:
        cloud = ps.register_point_cloud(DOTS, dots.centres, color=DOT_COLOR, material="flat")
        cloud.set_radius(dots.radius, relative=False)


def _thread(lines: Lines | None, before: Lines | None) -> None:
    """These lines in place of those before."""
    if lines is None:
        ps.remove_curve_network(LINES, error_if_absent=False)
        return
    if before is not None and np.array_equal(lines.edges, before.edges):
        network = ps.get_curve_network(LINES)
        network.update_node_positions(lines.nodes)
    else:
        network = ps.register_curve_network(LINES, lines.nodes, lines.edges, material="flat")
        before = None
    if before is None or not np.array_equal(lines.colors, before.colors):
        network.add_color_quantity(COLORS, lines.colors, defined_on="edges", enabled=True)
    if before is None or lines.radius != before.radius:
        network.set_radius(lines.radius, relative=False)


def _haunt(scene: Scene) -> None:
    """The ghost of this scene in place of the one before."""
    ps.remove_surface_mesh(GHOST, error_if_absent=False)
    seen = scene.ghost is not None
    ps.set_transparency_mode("pretty" if seen else "none")
    ps.set_transparency_render_passes(GHOST_LAYERS)
    if seen:
        ghost = ps.register_surface_mesh(GHOST, scene.ghost, scene.polygons)
        ghost.set_color(GHOST_COLOR)
        ghost.set_material("flat")
        ghost.set_back_face_policy("identical")
        ghost.set_transparency(GHOST_OPACITY)
