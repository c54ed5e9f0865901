"""Draws the question that stands: a box in the middle of the window, before everything else."""

from __future__ import annotations

import polyscope.imgui as psim

from app.editor.question import Answer, Question
from app.window.panel.widgets import shares
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
    psim.SetNextWindowSize((min(scaled(BOX_WIDTH), width), 0.0))
    if not psim.BeginPopupModal(TITLE, PLACE):
        return None
    try:
        answer = _buttons(question)
        if answer is not None:
            psim.CloseCurrentPopup()
    finally:
        psim.EndPopup()
    return answer


def _buttons(question: Question) -> Answer | None:
    psim.TextWrapped(question.text)
    psim.Spacing()
    labels = [answer.label for answer in question.answers]
    pressed = [psim.Button(label, size) for label, size in shares(*labels)]
    pressed[0] |= _went_down(psim.ImGuiKey_Enter, psim.ImGuiKey_KeypadEnter)
    pressed[-1] |= _went_down(psim.ImGuiKey_Escape)
    return next((a for a, on in zip(question.answers, pressed, strict=True) if on), None)


def _went_down(*keys: int) -> bool:
    return any(psim.IsKeyPressed(key, False) for key in keys)
