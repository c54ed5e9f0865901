"""The program, with a note of where everything in its panel is: a person sees it, a test reads.

`python -m tests.gui.watched NOTE ARGUMENTS...` is `python -m app ARGUMENTS...`, which after each
frame that has moved something writes to NOTE, as JSON, the pixels of each widget by its label:
[left, top, right, bottom].
"""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

KINDS = (
    *("Button", "SmallButton", "Checkbox", "RadioButton", "Combo", "BeginCombo", "Selectable"),
    *("SliderInt", "SliderFloat", "DragFloat", "InputText", "InputTextWithHint", "MenuItem"),
    *("CollapsingHeader", "TreeNode"),
)


class Note:
    """Writes down what a frame has drawn, where it differs from the one before."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self._now: dict[str, list[float]] = {}
        self._written: dict[str, list[float]] = {}

    def watched(self, psim: Any, draw: Callable[..., Any]) -> Callable[..., Any]:
        """`draw`, noted."""

        def noted(*arguments: Any) -> Any:
            result = draw(*arguments)
            low, high = psim.GetItemRectMin(), psim.GetItemRectMax()
            label = str(arguments[0]).rpartition("###")[2]  # what stands before it may change
            self._now.setdefault(label, [*map(float, low), *map(float, high)])
            return result

        return noted

    def end_of_frame(self) -> None:
        """Once a frame."""
        if self._now != self._written:
            beside = self._path.with_suffix(".new")
            beside.write_text(json.dumps(self._now), encoding="utf-8")
            os.replace(beside, self._path)
            self._written = self._now
        self._now = {}


def main(path: Path, arguments: list[str]) -> int:
    """Run the program; its exit code."""
    # Here, because the solver's process imports this module too and must not load a window.
    import polyscope as ps
    import polyscope.imgui as psim

    from app.__main__ import main as program

    note = Note(path)
    for kind in KINDS:
        setattr(psim, kind, note.watched(psim, getattr(psim, kind)))
    tick = ps.frame_tick

    def ticked() -> None:
        tick()
        note.end_of_frame()

    vars(ps)["frame_tick"] = ticked
    return program(arguments)


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]), sys.argv[2:]))
