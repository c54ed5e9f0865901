"""The mirror: across which plane, and what is done to a whole side at once."""

from __future__ import annotations

import polyscope.imgui as psim

from app.editor import commands as c
from app.editor.editor import Editor
from app.window.panel.widgets import shares

PLANES = {
    "off": "off",
    "found": "the mesh's own",
    "x": "across x",
    "y": "across y",
    "z": "across z",
}
WHOLE = (
    ("Mirror pose", c.MirrorPose(), "Exchange the poses of the two sides"),
    ("Mirror regions", c.MirrorRegions(), "Paint the other side as that of the active handle"),
)


def mirror(editor: Editor, asked: list[c.Command]) -> None:
    """The plane, and two buttons."""
    names = list(PLANES)
    chosen = names.index(editor.symmetry_name)
    changed, index = psim.Combo("mirror", chosen, list(PLANES.values()))
    psim.SetItemTooltip("Strokes and drags happen on both sides of it (X)")
    if changed:
        asked.append(c.SetSymmetry(names[index]))
    for (label, command, tip), (_, size) in zip(WHOLE, shares(*(r[0] for r in WHOLE)), strict=True):
        if psim.Button(label, size):
            asked.append(command)
        psim.SetItemTooltip(tip)
