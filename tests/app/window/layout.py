"""A program: draws the panel without a screen and prints where everything in it lies, as JSON.

`python -m tests.app.window.layout WIDTH HEIGHT SCALE TOOL MESH`, each line an Item. The mock of
a graphics library that Polyscope has lays out all of the interface, and draws nothing.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Callable
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

FRAMES = 4  # until what scrolls knows how long it is
# What draws one thing, and where its text stands: in a frame it must fit, or beside it.
FRAMED = ("Button", "SmallButton")
FREE = (
    *("Text", "TextDisabled", "TextColored", "TextWrapped", "Checkbox", "RadioButton", "Combo"),
    *("SliderInt", "SliderFloat", "InputText", "InputTextWithHint", "ColorButton", "BeginCombo"),
    *("TreeNode", "CollapsingHeader", "Dummy", "DragFloat", "InputInt"),
)


@dataclass(frozen=True)
class Item:
    """Pixels of one thing in the panel. inner: in a list that scrolls by itself.

    needs: how wide its text is with its frame, 0 where it has none.
    below: how far the panel can be scrolled.
    """

    kind: str
    label: str
    low: tuple[float, float]
    high: tuple[float, float]
    inner: bool
    needs: float
    below: float


class Watch:
    """Notes everything that is drawn in a frame."""

    def __init__(self, psim: Any) -> None:
        self._psim = psim
        self.items: list[Item] = []
        self._inner = 0
        for kind in (*FRAMED, *FREE):
            setattr(psim, kind, self._watched(kind, getattr(psim, kind)))
        for name, step in (("BeginChild", 1), ("EndChild", -1)):
            setattr(psim, name, self._counted(step, getattr(psim, name)))
        opening, tree = psim.SetNextItemOpen, psim.TreeNode
        psim.SetNextItemOpen = lambda is_open, condition=0: opening(True)
        psim.TreeNode = lambda label: (opening(True), tree(label))[1]

    def _watched(self, kind: str, draw: Callable[..., Any]) -> Callable[..., Any]:
        def watched(*arguments: Any) -> Any:
            result, psim = draw(*arguments), self._psim
            label = str(arguments[0])
            padding = 2 * psim.GetStyle().FramePadding[0]
            needs = padding + psim.CalcTextSize(label.split("##")[0])[0] if kind in FRAMED else 0.0
            low, high = psim.GetItemRectMin(), psim.GetItemRectMax()
            place = tuple(low), tuple(high), self._inner > 0, needs, psim.GetScrollMaxY()
            self.items.append(Item(kind, label, *place))
            return result

        return watched

    def _counted(self, step: int, call: Callable[..., Any]) -> Callable[..., Any]:
        def counted(*arguments: Any) -> Any:
            self._inner += step
            return call(*arguments)

        return counted


def main(width: int, height: int, scale: float, tool: str, mesh: Path) -> None:
    """Print the items of a panel that has everything unfolded."""
    import polyscope as ps
    import polyscope.imgui as psim

    init = ps.init
    ps.init = lambda backend: init("openGL_mock")
    watch = Watch(psim)
    from app.dialogs.dialogs import Dialogs
    from app.dialogs.programs import tk
    from app.editor import commands as c
    from app.editor.editor import Editor
    from app.editor.files.actions import load_document
    from app.model.preferences import PreferencesFile
    from app.window.drawing.view import View
    from app.window.file_dialogs import FileDialogs
    from app.window.films.studio import Studio
    from app.window.opening import FONT_SIZE, open_window
    from app.window.panel import Panel
    from app.window.panel.file_rows import FileRows
    from app.window.panel.looking import LookingRows
    from tests.app.person import IdleWorker

    open_window(scale, (width, height))
    session = mesh.suffix == ".json"
    document = load_document(*(None, mesh) if session else (mesh, None))
    editor = Editor(document, IdleWorker())
    editor.execute(c.SetTool(tool))
    editor.execute(c.SetMap("strain"))
    dialogs = FileDialogs(Dialogs(tk if session else None))
    files = FileRows(dialogs)
    looking = LookingRows(Studio(editor, View()), PreferencesFile(mesh / "none"), dialogs)
    panel = Panel(files, looking)

    def frame() -> None:
        # The mock enlarges its letters once more.
        style = psim.GetStyle()
        style.FontScaleMain *= FONT_SIZE * scale / psim.GetFontSize()
        watch.items.clear()
        panel.draw(editor)

    ps.set_user_callback(frame)
    for _ in range(FRAMES):
        ps.frame_tick()
    for item in watch.items:
        print(json.dumps(asdict(item)))


if __name__ == "__main__":
    width, height, scale, tool, mesh = sys.argv[1:]
    main(int(width), int(height), float(scale), tool, Path(mesh))
