"""Draws the question that stands: a box in the middle of the window, before everything else."""

from __future__ import annotations

import polyscope.imgui as psim

from app.editor.question import Answer, Question
from app.telling import readable
from app.window.panel.widgets import shares, shortened
from app.window.scaling import scaled

BOX_WIDTH = 440.0
TITLE = "question"
PLACE = (
    psim.ImGuiWindowFlags_NoTitleBar
    | psim.ImGuiWindowFlags_NoMove
    | psim.ImGuiWindowFlags_NoResize
    | psim.ImGuiWindowFlags_AlwaysAutoResize
    | psim.ImGuiWindowFlags_NoSavedSettings
)


def draw_question(question: Question) -> Answer | None:
    """In each frame that it stands in; what was answered in this one."""
    if not psim.IsPopupOpen(TITLE):
        psim.OpenPopup(TITLE)
    width, height = psim.GetIO().DisplaySize
    psim.SetNextWindowPos((0.5 * width, 0.5 * height), psim.ImGuiCond_Always, (0.5, 0.5))
    psim.SetNextWindowSize((min(_width(question), width), 0.0))
    if not psim.BeginPopupModal(TITLE, PLACE):
        return None
    try:
        answer = _buttons(question)
        if answer is not None:
            psim.CloseCurrentPopup()
    finally:
        psim.EndPopup()
    return answer


def _width(question: Question) -> float:
    """Pixels, enough for every label."""
    style, count = psim.GetStyle(), len(question.answers)
    label = max(psim.CalcTextSize(answer.label)[0] for answer in question.answers)
    button = label + 2.0 * style.FramePadding[0]
    gaps = (count - 1) * style.ItemSpacing[0] + 2.0 * style.WindowPadding[0]
    return max(scaled(BOX_WIDTH), count * button + gaps)


def _buttons(question: Question) -> Answer | None:
    psim.TextWrapped("\n".join(map(readable, question.text.split("\n"))))
    psim.Spacing()
    labels = [answer.label for answer in question.answers]
    pressed = [_button(label, size) for label, size in shares(*labels)]
    pressed[0] |= _went_down(psim.ImGuiKey_Enter, psim.ImGuiKey_KeypadEnter)
    pressed[-1] |= _went_down(psim.ImGuiKey_Escape)
    return next((a for a, on in zip(question.answers, pressed, strict=True) if on), None)


def _button(label: str, size: tuple[float, float]) -> bool:
    """With the beginning and the end of a label that does not fit into the window."""
    room = size[0] - 2.0 * psim.GetStyle().FramePadding[0]
    return bool(psim.Button(f"{shortened(readable(label), room)}###{label}", size))


def _went_down(*keys: int) -> bool:
    return any(psim.IsKeyPressed(key, False) for key in keys)
