"""The only writer of Polyscope's structures: draws a Scene, moves the camera, takes pictures."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import polyscope as ps
from numpy.typing import NDArray

from app.scene.scene import Dots, Lines, Scene
from app.viewpoint.camera import FIELD_OF_VIEW, Camera
from app.window.drawing.surface import COLORS, Shape, Surface

DOTS, LINES, GHOST = "dots", "lines", "ghost"
DOT_COLOR = (0.96, 0.96, 0.98)
GHOST_COLOR, GHOST_OPACITY = (0.45, 0.47, 0.52), 0.35
GHOST_LAYERS = 3  # its front, its back, the surface: each is a pass over the scene


class View:
    """The scene on screen, and the camera it is seen through."""

    def __init__(self) -> None:
        self._surface, self._twin = Surface("surface"), Surface("twin")
        self._shown: Scene | None = None
        self._camera = Camera.look_at([0, 0, 1], [0, 0, 0], FIELD_OF_VIEW, (1, 1))

    def show(self, scene: Scene) -> None:
        """Upload what differs from the scene shown before, and nothing else."""
        before = self._shown
        self._surface.show(Shape(scene.shaded, scene.positions, scene.colors, scene.looks))
        if scene.twin is not None:
            self._twin.show(Shape(scene.shaded, scene.twin.positions, scene.colors, scene.looks))
            self._twin.put(scene.twin.place(self._camera))
        else:
            self._twin.remove()
        if before is None or scene.dots is not before.dots:
            _place(scene.dots)
        if before is None or scene.lines is not before.lines:
            _thread(scene.lines, before.lines if before else None)
        if (
            before is None
            or scene.ghost is not before.ghost
            or (scene.ghost is not None and scene.shaded is not before.shaded)
        ):
            _haunt(scene)
        self._shown = scene

    def look(self, camera: Camera, reach: float | None = None) -> None:
        """See what `camera` sees; the field of view stays.

        reach: about how far away the farthest thing is. Polyscope draws 20 times as far as its
        centre of view is; without a reach that one stays.
        """
        if reach is not None:
            ps.set_view_center_raw(camera.position + reach * camera.forward)
        self._camera = camera
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
    if scene.ghost is not None:
        ghost = ps.register_surface_mesh(GHOST, scene.shaded.of(scene.ghost), scene.shaded.polygons)
        ghost.set_color(GHOST_COLOR)
        ghost.set_material("flat")
        ghost.set_back_face_policy("identical")
        ghost.set_transparency(GHOST_OPACITY)
