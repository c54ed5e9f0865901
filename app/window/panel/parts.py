"""The parts of the mesh: what each is called, whether it is seen, whether it follows."""

from __future__ import annotations

import polyscope.imgui as psim

from app.editor import commands as c
from app.editor.editor import Editor
from app.window.panel.widgets import text_until
from app.window.scaling import scaled

ROWS = 6  # more than these scroll
FOLLOWS_COLUMN = 216.0


def has_parts(editor: Editor) -> bool:
    """Whether there are several."""
    return len(editor.parts.all) > 1


def parts(editor: Editor, asked: list[c.Command]) -> None:
    """A row for each piece."""
    found = editor.parts.all
    following = sum(editor.document.follows(part.number) for part in found)
    changed, on = psim.Checkbox("all follow what they are near", following == len(found))
    psim.SetItemTooltip("Eyes stay in the head, buttons on the shirt")
    if changed:
        asked.append(c.SetSetting("attach", on))
    psim.TextDisabled(f"shown, of {len(found)}")
    psim.SameLine(scaled(FOLLOWS_COLUMN))
    psim.TextDisabled("follows")
    height = min(len(found), ROWS) * psim.GetFrameHeightWithSpacing()
    psim.BeginChild("##parts", (0.0, height))
    for part in found:
        _row(editor, part.number, asked)
    psim.EndChild()


def _row(editor: Editor, number: int, asked: list[c.Command]) -> None:
    part = editor.parts.all[number]
    psim.PushID(str(number))
    changed, seen = psim.Checkbox("##seen", number not in editor.parts.hidden)
    psim.SetItemTooltip("Show this part. A hidden one cannot be painted; it still follows")
    if changed:
        asked.append(c.ShowPart(number, seen))
    psim.SameLine()
    text_until(FOLLOWS_COLUMN, f"{part.name}  {part.count:,}")
    psim.SameLine(scaled(FOLLOWS_COLUMN))
    changed, follows = psim.Checkbox("##follows", editor.document.follows(number))
    psim.SetItemTooltip("Follow the larger part that this one touches or is near")
    if changed:
        asked.append(c.SetFollows(number, follows))
    psim.PopID()
