"""Reads the mouse and the keyboard: one Input and the commands of one frame."""

from __future__ import annotations

import polyscope.imgui as psim

from app.editor import commands as c
from app.pointing.brush import Brush
from app.viewpoint.camera import Camera
from app.viewpoint.events import BACKSPACE, ENTER, Input
from app.window.shortcuts import SHORTCUTS, Shortcut

TYPED = {
    **{getattr(psim, f"ImGuiKey_{digit}"): digit for digit in "0123456789"},
    **{getattr(psim, f"ImGuiKey_Keypad{digit}"): digit for digit in "0123456789"},
    **{getattr(psim, f"ImGuiKey_{letter.upper()}"): letter for letter in "xyz"},
    psim.ImGuiKey_Minus: "-",
    psim.ImGuiKey_KeypadSubtract: "-",
    psim.ImGuiKey_Period: ".",
    psim.ImGuiKey_Comma: ".",
    psim.ImGuiKey_KeypadDecimal: ".",
    psim.ImGuiKey_Backspace: BACKSPACE,
    psim.ImGuiKey_Enter: ENTER,
    psim.ImGuiKey_KeypadEnter: ENTER,
}
BEGIN_OPERATOR = c.MoveHandles, c.TurnHandles


def read_mouse(camera: Camera) -> Input:
    """The mouse of this frame, seen through the camera of this frame."""
    io = psim.GetIO()
    x, y = io.MousePos
    inside = 0 <= x < io.DisplaySize[0] and 0 <= y < io.DisplaySize[1]
    over_scene = inside and not io.WantCaptureMouse
    return Input(
        pixel=(x, y) if over_scene else None,
        camera=camera,
        pressed=psim.IsMouseClicked(0),
        down=psim.IsMouseDown(0),
        released=psim.IsMouseReleased(0),
        clicks=max(io.MouseClickedCount[0], 1),
        secondary=psim.IsMouseDown(1),
        middle=psim.IsMouseDown(2),
        wheel=io.MouseWheel if over_scene else 0.0,
        shift=_held(io.KeyShift, psim.ImGuiKey_LeftShift, psim.ImGuiKey_RightShift),
        ctrl=_held(io.KeyCtrl, psim.ImGuiKey_LeftCtrl, psim.ImGuiKey_RightCtrl),
        alt=io.KeyAlt,
        typed=_typed(),
    )


def read_shortcuts(brush: Brush, heard: bool, unfolded: bool) -> list[c.Command]:
    """The commands of keys that went down in this frame, or are held; none while somebody types.

    heard: an operator hears the keys, so that none but Esc is a shortcut.
    unfolded: a list or menu was, in the last frame, which Esc has folded up by now.
    """
    io = psim.GetIO()
    if io.WantTextInput:
        return []
    ctrl_now = io.KeyCtrl or io.KeySuper
    ctrl = _held(ctrl_now, psim.ImGuiKey_LeftCtrl, psim.ImGuiKey_RightCtrl)
    ctrl = _held(ctrl, psim.ImGuiKey_LeftSuper, psim.ImGuiKey_RightSuper)
    shift = _held(io.KeyShift, psim.ImGuiKey_LeftShift, psim.ImGuiKey_RightShift)
    # A frame that sees Ctrl let go may also see the plain key that was pressed after it.
    asked: list[c.Command] = [
        shortcut.command(brush)
        for shortcut in SHORTCUTS
        if (ctrl and shortcut.shift == shift if shortcut.ctrl else not ctrl_now) and _asks(shortcut)
    ]
    if unfolded:
        asked = [command for command in asked if not isinstance(command, c.CancelGesture)]
    if heard:
        return [command for command in asked if isinstance(command, c.CancelGesture)]
    # What went down in the same frame was typed after the key of an operator, and is for it.
    operator = next((command for command in asked if isinstance(command, BEGIN_OPERATOR)), None)
    return asked if operator is None else [operator]


def is_unfolded() -> bool:
    """Whether a list or menu is, after all was drawn."""
    return bool(psim.IsPopupOpen("", psim.ImGuiPopupFlags_AnyPopup))


def _typed() -> str:
    """See Input.typed; empty while somebody types in a field, or with Ctrl."""
    io = psim.GetIO()
    if io.WantTextInput or io.KeyCtrl or io.KeySuper:
        return ""
    return "".join(text for key, text in TYPED.items() if psim.IsKeyPressed(key, False))


def _asks(shortcut: Shortcut) -> bool:
    if shortcut.held:
        return bool(psim.IsKeyDown(shortcut.key))
    return bool(psim.IsKeyPressed(shortcut.key, shortcut.repeats))


def _held(now: bool, left: int, right: int) -> bool:
    """Whether a modifier counts as down: also in the frame that sees a fast chord let go of it."""
    return now or psim.IsKeyReleased(left) or psim.IsKeyReleased(right)
