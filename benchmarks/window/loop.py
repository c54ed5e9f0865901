"""The app's own loop, with somebody who watches each frame."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from app.editor.editor import Editor

Tick = Callable[[], object]


def run_watched(
    frame: Callable[[Editor | None, Tick], object], mesh: Path | None, session: Path | None
) -> None:
    """Open a window, and call `frame` in place of each frame until it is closed.

    frame: is given the editor, None before there is one, and what draws the frame.
    """
    # Here: the solver's process imports what imports this, and must not load a window.
    import polyscope as ps

    from app.window import main

    opened: list[Editor] = []
    adopt, tick = Editor.adopt, ps.frame_tick

    def watched(editor: Editor, *arguments: Any) -> None:
        adopt(editor, *arguments)
        opened[:] = [editor]

    vars(ps)["frame_tick"] = lambda: frame(opened[0] if opened else None, tick)
    setattr(Editor, "adopt", watched)  # noqa: B010 - a method is not to be assigned
    main.run_window(mesh, session, None)
