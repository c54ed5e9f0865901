"""The window with a clock: `python -m benchmarks.window.ticks LOG SESSION` logs every frame."""

from __future__ import annotations

import json
import sys
import time
from pathlib import Path
from typing import Any


def run(log: Path, session: Path) -> None:
    """The app's own loop. One line a frame: begin (epoch, s), seconds, binding, dragging."""
    # Here, because the solver's process imports this module too and must not load a window.
    import polyscope as ps

    from app.editor.editor import Editor
    from app.window import main

    editors: list[Editor] = []
    adopt, tick = Editor.adopt, ps.frame_tick

    def watched(editor: Editor, *arguments: Any) -> None:
        adopt(editor, *arguments)
        editors[:] = [editor]

    with log.open("w", encoding="utf-8", buffering=1) as lines:

        def timed() -> None:
            state = [(e.worker.binding, e.dragging) for e in editors] or [(False, False)]
            begin = time.time()
            tick()
            if editors:
                print(json.dumps([begin, time.time() - begin, *state[0]]), file=lines)

        vars(ps)["frame_tick"] = timed
        setattr(Editor, "adopt", watched)  # noqa: B010 - a method is not to be assigned
        main.run_window(None, session, None)


if __name__ == "__main__":
    run(Path(sys.argv[1]), Path(sys.argv[2]))
