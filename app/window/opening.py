"""Starts Polyscope, in a window or without one, and how the window looks before a mesh is in it."""

from __future__ import annotations

import atexit

import numpy as np
import polyscope as ps
import polyscope.imgui as psim

from app.graphics import GraphicsError
from app.viewpoint.camera import FIELD_OF_VIEW
from app.window.scaling import scaled, set_scale

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
    "Header": (0.17, 0.185, 0.225, 1.0),
    "HeaderHovered": (0.22, 0.245, 0.3, 1.0),
    "HeaderActive": (0.26, 0.29, 0.36, 1.0),
    "ScrollbarBg": (0.0, 0.0, 0.0, 0.0),
    "ScrollbarGrab": (0.26, 0.29, 0.35, 1.0),
}
SIZE = (1280, 800)
LARGEST_AT_FIRST = 1.5  # times that size: where more is asked for, the screen may have no room
FONT_SIZE = 18.0
# All that has a length: Polyscope keeps the style, so that nothing may be scaled twice.
MEASURES: dict[str, float | tuple[float, float]] = {
    "FramePadding": (6.0, 2.0),
    "ItemSpacing": (6.0, 3.0),
    "ItemInnerSpacing": (4.0, 4.0),
    "WindowPadding": (10.0, 8.0),
    "IndentSpacing": 21.0,
    "FrameRounding": 4.0,
    "GrabRounding": 4.0,
    "GrabMinSize": 12.0,
    "ScrollbarSize": 10.0,
    "ScrollbarRounding": 5.0,
}


def open_window(scale: float | None = None, size: tuple[int, int] | None = None) -> float:
    """A window on the screen. Raises GraphicsError where there is none.

    scale: how large the interface is drawn, None as the screen asks.
    size: of the window, None for one that suits the interface.
    Returns what the screen asks for.
    """
    _start(("openGL3_glfw",), size or SIZE)
    asked = ps.get_ui_scale()
    if size is None:
        ps.set_window_size(*(round(min(asked, LARGEST_AT_FIRST) * length) for length in SIZE))
    set_scale(asked if scale is None else scale)
    return asked


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
    ps.set_navigation_style("none")  # app.viewpoint moves the camera
    ps.set_do_default_mouse_interaction(False)
    ps.set_vertical_fov_degrees(float(np.degrees(FIELD_OF_VIEW)))


def _init(backends: tuple[str, ...]) -> None:
    """The first backend that starts. Raises GraphicsError, the reason of the last, if none does."""
    for number, backend in enumerate(backends, start=1):
        try:
            ps.init(backend)
        except RuntimeError as error:
            if number == len(backends):
                raise GraphicsError(error) from error
        else:
            return


def _start_at_last() -> None:
    """Polyscope complains at exit, or crashes there, where it was loaded and never started."""
    if not ps.is_initialized():
        ps.set_verbosity(0)
        ps.init("openGL_mock")


atexit.register(_start_at_last)


def _style() -> None:
    """A quiet dark panel, dense, as large as the interface is to be."""
    style = psim.GetStyle()
    for name, measure in MEASURES.items():
        pixels = tuple(map(scaled, measure)) if isinstance(measure, tuple) else scaled(measure)
        setattr(style, name, pixels)
    style.FontSizeBase, style.FontScaleMain = FONT_SIZE, scaled(1.0)
    style.WindowBorderSize = 0.0
    for name, color in PALETTE.items():
        style.Colors[getattr(psim, f"ImGuiCol_{name}")] = color
