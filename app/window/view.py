"""The only writer of Polyscope's structures: shows what an Editor holds, and takes pictures."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import polyscope as ps
import polyscope.imgui as psim

from app.editor.editor import Editor
from app.graphics import GraphicsError
from app.workspace.camera import FIELD_OF_VIEW, Camera
from app.workspace.picking import Hit
from solver.types import FloatArray

TITLE = "Surface deformation"
BACKGROUND = (0.74, 0.75, 0.78)  # before Polyscope's tone mapping, which brightens it
PALETTE = {
    "WindowBg": (0.13, 0.14, 0.17, 1.0),
    "PopupBg": (0.16, 0.17, 0.21, 1.0),
    "Text": (0.91, 0.92, 0.94, 1.0),
    "TextDisabled": (0.58, 0.61, 0.66, 1.0),
    "FrameBg": (0.2, 0.22, 0.27, 1.0),
    "FrameBgHovered": (0.25, 0.28, 0.34, 1.0),
    "FrameBgActive": (0.28, 0.32, 0.4, 1.0),
    "Button": (0.24, 0.27, 0.33, 1.0),
    "ButtonHovered": (0.31, 0.35, 0.43, 1.0),
    "ButtonActive": (0.18, 0.5, 0.85, 1.0),
    "SliderGrab": (0.42, 0.6, 0.85, 1.0),
    "SliderGrabActive": (0.5, 0.7, 0.95, 1.0),
    "CheckMark": (0.5, 0.75, 1.0, 1.0),
    "Separator": (0.26, 0.29, 0.35, 1.0),
    "TitleBgActive": (0.2, 0.22, 0.27, 1.0),
}
SURFACE = "surface"
COLORS = "colors"
BRUSH_SEGMENTS = 48
EDGE_WIDTH, EDGE_COLOR = 0.6, (0.15, 0.15, 0.2)
PINS = "pins"
PIN_COLOR, PIN_SIZE = (0.96, 0.96, 0.98), 0.16  # radius, in edges of the mesh


def open_window() -> None:
    """A window on the screen. Raises GraphicsError where there is none."""
    _start(("openGL3_glfw",), (1280, 800))


def open_offscreen(size: tuple[int, int]) -> None:
    """A canvas for pictures, without a display where EGL can. Raises GraphicsError."""
    _start(("openGL3_egl", "openGL3_glfw"), size)
    ps.set_background_color((1.0, 1.0, 1.0))
    ps.set_SSAA_factor(2)  # a picture has the time that a frame has not


def _start(backends: tuple[str, ...], size: tuple[int, int]) -> None:
    ps.set_verbosity(0)
    ps.set_use_prefs_file(False)
    ps.set_program_name(TITLE)
    ps.set_window_size(*size)
    ps.set_build_default_gui_panels(False)
    ps.set_open_imgui_window_for_user_callback(False)
    ps.set_configure_imgui_style_callback(_style)
    _init(backends)
    ps.set_frame_tick_limit_fps_mode("ignore_limits")
    ps.set_ground_plane_mode("none")
    ps.set_background_color(BACKGROUND)
    ps.set_up_dir("y_up")
    ps.set_front_dir("z_front")
    ps.set_navigation_style("turntable")
    ps.set_vertical_fov_degrees(float(np.degrees(FIELD_OF_VIEW)))


def _init(backends: tuple[str, ...]) -> None:
    """The first backend that starts; the reason of the last where none does."""
    for number, backend in enumerate(backends, start=1):
        try:
            ps.init(backend)
        except RuntimeError as error:
            if number == len(backends):
                ps.init("openGL_mock")  # else Polyscope complains at exit that it never started
                raise GraphicsError(error) from error
        else:
            return


def _style() -> None:
    """A quiet dark panel, dense enough that nothing needs scrolling at 800 pixels."""
    style = psim.GetStyle()
    style.FramePadding, style.ItemSpacing, style.WindowPadding = (6.0, 2.0), (6.0, 3.0), (10.0, 8.0)
    style.FrameRounding = style.GrabRounding = 4.0
    style.WindowBorderSize = 0.0
    for name, color in PALETTE.items():
        style.Colors[getattr(psim, f"ImGuiCol_{name}")] = color


class View:
    """What is on screen, and what of it is out of date.

    inset: pixels at the left of the window that a panel covers.
    """

    def __init__(self, inset: float = 0.0) -> None:
        self._inset = inset
        self._mesh: Any = None  # Polyscope has no type hints
        self._document = self._positions = -1
        self._edges = False
        self._colors: object = None
        self._pins: object = None
        self._pin_radius = 0.0

    def sync(self, editor: Editor) -> None:
        """Upload what has changed since the last call, and nothing else."""
        if self._document != editor.document.serial:
            self._register(editor)
            self.frame_mesh(editor.positions)
            return
        if self._positions != editor.positions_version:
            self._mesh.update_vertex_positions(editor.positions)
            self._positions = editor.positions_version
        if self._colors != editor.colors_version:
            buffer = self._mesh.get_quantity_buffer(COLORS, "colors")
            buffer.update_data(editor.colors)
            self._colors = editor.colors_version
        self._sync_pins(editor)

    def _sync_pins(self, editor: Editor) -> None:
        """A dot on every pinned vertex, while the map is shown that says what they are pinned to.

        Dots are as small as the mesh is fine: they never hide the colours between them.
        """
        shown = editor.map == "softness"
        document = editor.document
        version = shown and (document.revision["pinned"], editor.positions_version)
        if version == self._pins:
            return
        self._pins = version
        ps.remove_point_cloud(PINS, error_if_absent=False)
        if shown and document.pinned.any():
            at = editor.positions[document.pinned]
            pins = ps.register_point_cloud(PINS, at, color=PIN_COLOR, material="flat")
            pins.set_radius(self._pin_radius, relative=False)

    def _register(self, editor: Editor) -> None:
        polygons = editor.document.mesh.polygons
        self._mesh = ps.register_surface_mesh(
            SURFACE, editor.positions, polygons, smooth_shade=True, material="wax"
        )
        self._mesh.set_back_face_policy("identical")
        self._mesh.set_edge_color(EDGE_COLOR)
        self._edges = False
        self._mesh.add_color_quantity(COLORS, editor.colors, enabled=True)
        ends = editor.document.mesh.vertices[editor.neighbours.edges]
        length = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
        self._pin_radius = PIN_SIZE * float(length.mean()) if len(length) else 0.0
        self._pins = None
        self._sync_pins(editor)
        self._document = editor.document.serial
        self._positions = editor.positions_version
        self._colors = editor.colors_version

    def show_edges(self, on: bool) -> None:
        """Draw the edges of the file's polygons, or not."""
        if on != self._edges:  # setting it, even to what it is, draws the whole scene again
            self._edges = on
            self._mesh.set_edge_width(EDGE_WIDTH if on else 0.0)

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

    def draw_brush(self, editor: Editor, hit: Hit, erasing: bool) -> None:
        """The rim of the brush as a circle on the surface under the cursor."""
        corners = editor.positions[editor.document.mesh.faces[hit.face]]
        normal = np.cross(corners[1] - corners[0], corners[2] - corners[0])
        # A face without area has no plane: draw the circle facing the person.
        camera = self.camera()
        if not np.linalg.norm(normal) > 0:
            normal = camera.forward
        one = np.cross(normal, np.eye(3)[np.abs(normal).argmin()])
        one /= np.linalg.norm(one)
        two = np.cross(normal / np.linalg.norm(normal), one)
        angle = np.linspace(0, 2 * np.pi, BRUSH_SEGMENTS, endpoint=False)[:, None]
        rim = hit.position + editor.brush_radius * (np.cos(angle) * one + np.sin(angle) * two)
        pixels = camera.project(rim)
        if np.isfinite(pixels).all():
            dark, bright = (
                (30, 30, 40, 200),
                (255, 90, 70, 255) if erasing else (255, 255, 255, 255),
            )
            for color, width in ((dark, 4.0), (bright, 2.0)):
                psim.GetBackgroundDrawList().AddPolyline(
                    np.asfortranarray(pixels, dtype=np.float32),
                    psim.IM_COL32(*color),
                    psim.ImDrawFlags_Closed,
                    width,
                )

    def picture(self, path: Path, transparent: bool = False) -> None:
        """Save what the camera sees, without the panel, as a PNG. Raises FileError."""
        ps.screenshot(str(path), transparent_bg=transparent, include_UI=False)
