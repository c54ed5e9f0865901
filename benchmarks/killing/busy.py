"""The window, busy: `python -m benchmarks.killing.busy TASK LOG MESH` renames a handle each frame.

TASK: "save" or "export" does that each time, "autosave" leaves it to the program. A line of LOG for
each time that it is done: its number, which is the handle's name, and when (epoch, s).
"""

from __future__ import annotations

import json
import sys
import time
from pathlib import Path
from typing import Any

TASKS = "save", "export", "autosave"


def run(task: str, log: Path, mesh: Path) -> None:
    """The app's own loop, until somebody ends it."""
    # Here, because the solver's process imports this module too and must not load a window.
    import polyscope as ps

    from app.editor import commands as c
    from app.editor.actions import ACTIONS
    from app.editor.editor import Editor
    from app.window import main

    editors: list[Any] = []
    adopt, tick = Editor.adopt, ps.frame_tick
    number = 0

    def watched(editor: Any, *arguments: Any) -> None:
        adopt(editor, *arguments)
        editors[:] = [editor]

    def act(editor: Any) -> None:
        nonlocal number
        if editor.question is not None:
            command = editor.answer(editor.question.answers[0]).command
            if type(command) in ACTIONS:
                editor.execute(command)
        if not editor.document.handles:
            editor.execute(c.AddHandle())
        number += 1
        editor.execute(c.RenameHandle(editor.document.handles[0].key, str(number)))
        editor.history.seal()
        if task != "autosave":
            editor.execute(c.SaveSession() if task == "save" else c.Export())
        print(json.dumps([number, time.time()]), file=lines)

    def ticked() -> None:
        tick()
        if editors:
            act(editors[0])

    with log.open("w", encoding="utf-8", buffering=1) as lines:
        vars(ps)["frame_tick"] = ticked
        setattr(Editor, "adopt", watched)  # noqa: B010 - a method is not to be assigned
        main.run_window(mesh, None, None)


if __name__ == "__main__":
    run(sys.argv[1], Path(sys.argv[2]), Path(sys.argv[3]))
