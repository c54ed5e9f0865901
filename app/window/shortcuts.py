"""The keys of the window, as a table, and what each asks for."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import polyscope.imgui as psim

from app.editor import commands as c
from app.pointing.brush import RADIUS_STEP, Brush
from app.tools.table import TOOLS


@dataclass(frozen=True)
class WindowAction(c.Command):
    """Something the window does by itself: "help", "rest", a dialog or row of files, a picture,
    "stop" for the end of a recording."""

    name: str


@dataclass(frozen=True)
class SetInterface(c.Command):
    """How large the interface is drawn. None: as the screen asks."""

    scale: float | None


@dataclass(frozen=True)
class Shortcut:
    """A key and what it asks for. ctrl: with Ctrl, or Command on a Mac.

    held: asked for in every frame that the key is down.
    """

    keys: str
    meaning: str
    key: int
    command: Callable[[Brush], c.Command]
    ctrl: bool = False
    shift: bool = False
    repeats: bool = False
    held: bool = False


def _always(command: c.Command) -> Callable[[Brush], c.Command]:
    return lambda brush: command


def _scaled(factor: float) -> Callable[[Brush], c.Command]:
    return lambda brush: c.SetBrush(radius=brush.radius * factor)


SHORTCUTS = (
    *(
        Shortcut(
            tool.key, tool.label, getattr(psim, f"ImGuiKey_{tool.key}"), _always(c.SetTool(name))
        )
        for name, tool in TOOLS.items()
    ),
    Shortcut(
        "[", "Smaller brush", psim.ImGuiKey_LeftBracket, _scaled(1 / RADIUS_STEP), repeats=True
    ),
    Shortcut("]", "Larger brush", psim.ImGuiKey_RightBracket, _scaled(RADIUS_STEP), repeats=True),
    *(
        Shortcut(keys, meaning, key, _always(c.ChangeMarks(name)), ctrl=True, repeats=repeats)
        for keys, meaning, key, name, repeats in (
            ("Ctrl+Keypad +", "Grow what is marked", psim.ImGuiKey_KeypadAdd, "grow", True),
            ("Ctrl+Keypad -", "Shrink it", psim.ImGuiKey_KeypadSubtract, "shrink", True),
            ("Ctrl+I", "Invert it", psim.ImGuiKey_I, "invert", False),
        )
    ),
    Shortcut("Ctrl+Z", "Undo", psim.ImGuiKey_Z, _always(c.Undo()), ctrl=True, repeats=True),
    Shortcut(
        "Ctrl+Shift+Z", "Redo", psim.ImGuiKey_Z, _always(c.Redo()), True, shift=True, repeats=True
    ),
    Shortcut("Ctrl+Y", "Redo", psim.ImGuiKey_Y, _always(c.Redo()), ctrl=True, repeats=True),
    Shortcut("Ctrl+O", "Open", psim.ImGuiKey_O, _always(WindowAction("open")), ctrl=True),
    Shortcut("Ctrl+S", "Save session", psim.ImGuiKey_S, _always(WindowAction("save")), ctrl=True),
    Shortcut("Ctrl+E", "Export mesh", psim.ImGuiKey_E, _always(WindowAction("export")), ctrl=True),
    Shortcut("Ctrl+R", "Reset pose", psim.ImGuiKey_R, _always(c.ResetPose()), ctrl=True),
    Shortcut("G", "Move handles (X, Y, Z, a number)", psim.ImGuiKey_G, _always(c.MoveHandles())),
    Shortcut("R", "Turn handles (X, Y, Z, a number)", psim.ImGuiKey_R, _always(c.TurnHandles())),
    Shortcut(
        "F",
        "Frame the handle, the part under the cursor, all",
        psim.ImGuiKey_F,
        _always(c.FrameSelected()),
    ),
    Shortcut("Home", "Front view of all", psim.ImGuiKey_Home, _always(c.ViewFrom("front"))),
    *(
        Shortcut(
            f"{'Ctrl+' if ctrl else ''}Keypad {key}",
            f"View from {side}",
            getattr(psim, f"ImGuiKey_Keypad{key}"),
            _always(c.ViewFrom(side)),
            ctrl=ctrl,
        )
        for key, *sides in ((1, "front", "back"), (3, "right", "left"), (7, "top", "bottom"))
        for side, ctrl in zip(sides, (False, True), strict=True)
    ),
    Shortcut("K", "Keep what is grabbed, as a pin", psim.ImGuiKey_K, _always(c.SetKeep())),
    Shortcut("X", "Mirror what you paint and drag", psim.ImGuiKey_X, _always(c.ToggleSymmetry())),
    Shortcut(
        "` (left of 1)",
        "See the rest shape, while it is held",
        psim.ImGuiKey_GraveAccent,
        _always(WindowAction("rest")),
        held=True,
    ),
    Shortcut("F1", "Help", psim.ImGuiKey_F1, _always(WindowAction("help"))),
    Shortcut("Esc", "Cancel stroke or drag", psim.ImGuiKey_Escape, _always(c.CancelGesture())),
)
